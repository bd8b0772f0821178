"""What must hold in figures 3.01 to 3.09: costs and simplification."""


def average_plane(t, n):
    # A 6-fan of height 1, by hand: two thirds of the height; normals lean by the slant of the sides.
    t.assertAlmostEqual(n["d"], 2 / 3, 6)
    t.assertAlmostEqual(n["length of the mean"], 0.75**0.5 / 1.75**0.5, 6)
    t.assertAlmostEqual(n["cost"], 2 / 3 / 2**0.5, 6)
    t.assertAlmostEqual(n["unit normal"], 1, 12)


def same_distance(t, n):
    t.assertAlmostEqual(n["d"][0], n["d"][1], 6)
    t.assertLess(2 * n["d / longest edge"][0], 1.5 * n["d / longest edge"][1])


def planarity(t, n):
    t.assertEqual(n["border vertices"], n["undefined"])
    t.assertGreater(n["vertices"], n["undefined"])


def boundary_cost(t, n):
    t.assertAlmostEqual(n["d"], n["d again"], 9)
    t.assertAlmostEqual(n["d"], n["to the foot"], 9)
    t.assertGreater(n["d"], 0)


def edge_cost(t, n):
    t.assertEqual(n["edges"], n["values"])
    t.assertGreaterEqual(n["least"], 0)
    t.assertLessEqual(n["most"], n["legend"])


def vertex_removal(t, n):
    t.assertEqual(n["change of V, E, F"], [-1, -3, -2, -1, -3, -2, -1, -2, -1])


def edge_collapse(t, n):
    t.assertTrue(n["legal"])
    t.assertEqual(n["change of V, E, F"], [-1, -3, -2])


def illegal_collapse(t, n):
    t.assertEqual(n["reasons"], [1, 4, 2], "link, borders, a face that turns over")


def simplification(t, n):
    for got, wanted in zip(n["triangles"], n["wanted"]):
        t.assertLessEqual(abs(got - wanted), 2)
    t.assertEqual(set(n["V-E+F"]), {2})
    t.assertEqual(n["hausdorff %"], sorted(n["hausdorff %"]))
    t.assertEqual(n["hausdorff %"][0], 0)
    t.assertGreater(n["hausdorff %"][1], 0)


CHECKS = {
    "3.01-average-plane": average_plane,
    "3.02-same-distance": same_distance,
    "3.03-planarity": planarity,
    "3.04-boundary-cost": boundary_cost,
    "3.05-edge-cost": edge_cost,
    "3.06-vertex-removal": vertex_removal,
    "3.07-edge-collapse": edge_collapse,
    "3.08-illegal-collapse": illegal_collapse,
    "3.09-simplification": simplification,
}
