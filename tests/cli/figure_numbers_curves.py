"""What must hold in figures 3.10 to 3.12: curves by subdivision of the unit square."""


def bad_curve(t, n):
    t.assertEqual(n["N"], [4, 8, 16, 64])
    t.assertLessEqual(max(n["outside the square"]), 1e-12, "every new point inside the hull")
    t.assertEqual(max(n["distance of control points"]), 0)
    bad, good = n["kinks, scheme=positive"], n["kinks, scheme=four-point"]
    t.assertGreater(bad[8] / bad[5], 0.9, "kinks stay")
    t.assertLess(good[8] / good[5], 0.4, "and go with negative outer weights")


def four_point(t, n):
    t.assertEqual(n["N"], [4, 8, 16, 32, 64])
    t.assertEqual(max(n["distance of control points"]), 0, "every control point on the curve")
    t.assertAlmostEqual(n["outside the square"][1], 0.125, 12)


def approximation(t, n):
    t.assertEqual(n["N"], [4, 8, 16, 64])
    for area, wanted in zip(n["area"], [1, 0.75, 0.6953, 0.6789]):
        t.assertAlmostEqual(area, wanted, 4)
    t.assertGreater(min(n["distance of control points"][1:]), 0.1, "no control point on the curve")
    t.assertEqual(n["corner"][0], 0)
    t.assertAlmostEqual(n["corner"][-1], 1 / 6, 4)


CHECKS = {
    "3.10-bad-curve": bad_curve,
    "3.11-four-point": four_point,
    "3.12-approximation": approximation,
}
