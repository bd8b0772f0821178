"""What must hold in figures 3.13 to 3.24: subdivision of surfaces."""


def splits(t, n):
    t.assertEqual(n["triangle faces"], [1, 4, 16, 16])
    t.assertEqual(n["quad faces"], [1, 4, 16, 16])
    t.assertEqual(n["triangle inner valences"], [6])
    t.assertEqual(n["quad inner valences"], [4])
    t.assertTrue(n["4-adic is dyadic twice"])


def butterfly_stencil(t, n):
    t.assertEqual(n["weights 16"], [1 / 2, 1 / 2, 1 / 8, 1 / 8] + 4 * [-1 / 16])
    t.assertEqual(n["weights 8"], [1 / 2, 1 / 2, 1 / 4, 1 / 4] + 4 * [-1 / 8])
    t.assertEqual([n["sum 16"], n["sum 8"]], [1, 1])


def dyadic(t, n):
    for k in range(3):
        t.assertEqual(n["F"][k + 1], 4 * n["F"][k])
        t.assertEqual(n["V"][k + 1], n["V"][k] + n["E"][k])
    t.assertEqual({v - e + f for v, e, f in zip(n["V"], n["E"], n["F"])}, {2})


def butterfly(t, n):
    dyadic(t, n)
    t.assertEqual(n["largest displacement of old vertices"], 0)


def loop(t, n):
    dyadic(t, n)
    t.assertGreater(n["mean displacement of old vertices"], 0)
    t.assertLess(n["volume after"], n["volume before"], "old vertices move inwards")


def loop_stencils(t, n):
    t.assertEqual(sorted(n["new"]), [1 / 8, 1 / 8, 3 / 8, 3 / 8])
    t.assertEqual(n["old"], [10 / 16] + 6 * [1 / 16])


def loop_boundary(t, n):
    t.assertEqual(n["new"], [1 / 2, 1 / 2])
    t.assertEqual(n["old"], [6 / 8, 1 / 8, 1 / 8])


def sqrt3_steps(t, n):
    t.assertEqual(n["faces"][1:], [3 * n["faces"][0], 3 * n["faces"][0]])
    t.assertEqual(n["valence of the middle after"], n["valence of the middle before"])


def sqrt3(t, n):
    t.assertEqual(n["V"], [12, 32, 92, 272])
    t.assertEqual(n["F"], [20, 60, 180, 540])
    for k in range(3):
        t.assertEqual(n["V"][k + 1], n["V"][k] + n["F"][k])
        t.assertEqual(n["E"][k + 1], 3 * n["E"][k])
    t.assertEqual(n["valences after one"], [5, 6], "old keep theirs, new get 6")


def catmull_steps(t, n):
    t.assertEqual(n["valence"], 4)
    t.assertGreater(n["moved"], 0)


def catmull_split(t, n):
    t.assertEqual(n["sides before"], [3, 4, 5])
    t.assertEqual(n["sides after"], [4])
    t.assertEqual(n["faces after"], n["corners before"])
    t.assertEqual(set(n["valence of inner edge points"]), {4})


def catmull_cube(t, n):
    t.assertEqual(n["V"], [8, 26, 98, 386])
    t.assertEqual(n["E"], [12, 48, 192, 768])
    t.assertEqual(n["F"], [6, 24, 96, 384])
    t.assertEqual(n["vertices of valence 3"], [8, 8, 8, 8])
    for value, book in zip(n["corner"], [1, 0.5556, 0.5093, 0.5015]):
        t.assertAlmostEqual(value, book, delta=5e-5)


def catmull(t, n):
    for k in range(3):
        t.assertEqual(n["V"][k + 1], n["V"][k] + n["E"][k] + n["F"][k])
        t.assertEqual(n["F"][k + 1], 4 * n["F"][k])


CHECKS = {
    "3.13-splits": splits,
    "3.14-butterfly-stencil": butterfly_stencil,
    "3.15-butterfly": butterfly,
    "3.16-loop-stencils": loop_stencils,
    "3.17-loop-boundary": loop_boundary,
    "3.18-loop": loop,
    "3.19-sqrt3-steps": sqrt3_steps,
    "3.20-sqrt3": sqrt3,
    "3.21-catmull-steps": catmull_steps,
    "3.22-catmull-split": catmull_split,
    "3.23-catmull-cube": catmull_cube,
    "3.24-catmull": catmull,
}
