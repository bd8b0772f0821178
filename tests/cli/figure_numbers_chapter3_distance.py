"""What must hold in figure 3.29: a point and a triangle."""


def point_triangle(t, n):
    t.assertAlmostEqual(n["D"], 2.1, 12, "the triangle lies in z = 0")
    t.assertAlmostEqual(n["P to Q"], abs(n["D"]), 12)
    t.assertTrue(n["inside"])
    t.assertFalse(n["outside is inside"])
    t.assertEqual(len(set(n["signs inside"])), 1)
    t.assertEqual(len(set(n["signs outside"])), 2)
    t.assertAlmostEqual(n["closest to Q"], n["nearest side to Q"], 9)


CHECKS = {"3.29-point-triangle": point_triangle}
