"""What must hold in the figures of chapter 3.3: meshes laid out in the plane and on the sphere."""
import math


def idea(t, n):
    t.assertEqual(n["house"], [15, 36, 22])
    t.assertEqual(n["fold-overs"], 0)
    t.assertAlmostEqual(sum(n["shares in space"]), 1)
    for a, b in zip(n["shares in space"], n["shares in the plane"]):
        t.assertAlmostEqual(a, b)
        t.assertGreater(a, 0)


def springs(t, n):
    t.assertEqual(n["springs"], 36)
    t.assertEqual((n["pinned"], n["free"]), (6, 9))
    t.assertLess(n["off the circle"], 1e-12)
    t.assertLess(n["residual"], 1e-9)


def maps(t, n):
    for shape, counts, inside, border in (("house", [15, 36, 22], 9, 6), ("car", [32, 73, 42], 12, 20)):
        t.assertEqual(n[shape], counts)
        t.assertEqual((n[shape + " inside"], n[shape + " border"]), (inside, border))
        t.assertEqual(len(n[shape + " steps"]), border)
        for step in n[shape + " steps"]:
            t.assertAlmostEqual(step, 360 / border)
        t.assertLess(n[shape + " off the circle"], 1e-12)
        t.assertEqual(n[shape + " fold-overs"], 0)
        t.assertLess(n[shape + " residual"], 1e-9)


def sphere(t, n):
    t.assertEqual(n["Euler"], 2)
    t.assertEqual(n["fold-overs"], 0)
    t.assertAlmostEqual(n["area"], 4 * math.pi)
    t.assertGreater(n["marked area"], 0.005)
    t.assertLess(n["off the point of the angles"], 1e-12)
    t.assertGreater(n["alpha"], 0.3)
    t.assertGreater(n["delta"], 0.3)


CHECKS = {
    "3.25-embedding-idea": idea,
    "3.26-springs": springs,
    "3.27-barycentric-map": maps,
    "3.28-spherical-triangle": sphere,
}
