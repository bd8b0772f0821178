"""What must hold in the figures of chapter 3.4: morphs."""


def idea(t, n):
    t.assertLess(n["off the torus"], 1e-12)
    t.assertAlmostEqual(n["phi"], 2 * 3.141592653589793 * 1.3 / 2 - 3.141592653589793)


def cylinder(t, n):
    t.assertLess(n["off the torus"][-1], 1e-5)
    t.assertGreater(n["off the torus"][0], 0.1)


def sphere(t, n):
    t.assertLess(n["off the torus"][-1], 1e-5)
    t.assertAlmostEqual(n["ring of the poles"][-1], 1 - 0.4, places=5)
    t.assertAlmostEqual(n["ring of the poles"][0], 0, places=6)
    for part in ("0", "0.25", "0.5", "0.75", "1"):
        t.assertLess(n["uneven " + part], 1e-5)


def projective_map(t, n):
    for solid in ("cube", "tetrahedron"):
        t.assertEqual(n[solid], [12, 30, 20])
        t.assertEqual(n[solid + " Euler"], 2)


def projective(t, n):
    t.assertEqual(n["crossings"], 13)
    t.assertEqual(n["vertices"], 4 + 8 + 13)
    t.assertEqual(n["faces"], 2 * 25 - 4)
    t.assertEqual(n["Euler"], 2)
    t.assertAlmostEqual(n["volume"][0], n["tetrahedron"], places=5)
    t.assertAlmostEqual(n["volume"][-1], n["cube"], places=5)
    t.assertAlmostEqual(n["tetrahedron"], 8 / 3 * 0.8**3, places=5)
    t.assertAlmostEqual(n["cube"], 1.2**3, places=5)


def overlay(t, n):
    t.assertEqual(n["house"], [15, 36, 22])
    t.assertEqual(n["car"], [32, 73, 42])
    t.assertEqual(n["fold-overs"], 0)
    t.assertAlmostEqual(n["sum of weights"], 1)
    t.assertLess(n["residual"], 1e-9)


def barycentric(t, n):
    t.assertAlmostEqual(n["area"][0], n["house"], places=4)
    t.assertAlmostEqual(n["area"][-1], n["car"], places=4)
    t.assertEqual(n["Euler"], 1)


CHECKS = {
    "3.30-parametric-morph-idea": idea,
    "3.31-cylinder-torus": cylinder,
    "3.32-sphere-torus": sphere,
    "3.33-projective-map": projective_map,
    "3.34-projective-morph": projective,
    "3.35-barycentric-overlay": overlay,
    "3.36-barycentric-morph": barycentric,
}
