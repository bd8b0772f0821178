"""What must hold in the figures of chapter 2."""


def cube_strip(t, n):
    t.assertEqual(n["strip indices"], 14)
    t.assertEqual(n["list indices"], 36)
    t.assertEqual(n["triangles"], 12)
    t.assertEqual(n["decoded"], [12, 213, 237, 731, 715, 514, 547, 746, 762, 264, 240, 41])
    t.assertEqual(n["distinct half-edges"], 36, "each half-edge once")


def genus(t, n):
    t.assertEqual(n["genus"], [0, 1, 2])
    t.assertEqual(n["V-E+F"], [2, 0, -2])
    for v, e, f, euler, valences in zip(n["V"], n["E"], n["F"], n["V-E+F"], n["sum of valences"]):
        t.assertEqual(v - e + f, euler)
        t.assertEqual(valences, 2 * e)
        t.assertEqual(2 * e, 3 * f)
    t.assertEqual(n["E"][0], 3 * n["V"][0] - 6)
    t.assertEqual(n["F"][0], 2 * n["V"][0] - 4)


CHECKS = {
    "2.02-cube-strip": cube_strip,
    "2.06-genus": genus,
}
