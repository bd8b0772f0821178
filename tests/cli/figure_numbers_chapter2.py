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


def cube_lists(t, n):
    t.assertEqual((n["vertices"], n["triangles"], n["indices"]), (8, 12, 36))
    t.assertAlmostEqual(n["volume"], 1, 6)


def strip_restart(t, n):
    t.assertEqual((n["indices"], n["restarts"], n["triangles"], n["list indices"]), (25, 1, 20, 60))
    t.assertAlmostEqual(n["least signed area"], 0.5, 9)


def manifold(t, n):
    t.assertEqual(n["manifold"], [1, 1, 1, 1, 0, 0])
    t.assertEqual(n["faces at the edge"], 3)
    t.assertEqual((n["non-manifold edges of (b)"], n["non-manifold vertices of (b)"]), (1, 1))


def rings(t, n):
    t.assertEqual((n["one-ring"], n["two-ring, more"]), (6, 12))
    t.assertEqual(n["one-ring of the cow"], n["valence of the cow's vertex"])


def face_based(t, n):
    for i in range(3):
        beyond = set(n["corners of t1 t2 t3"][3 * i:3 * i + 3])
        t.assertEqual(beyond & set(n["p"]), {n["p"][i], n["p"][(i + 1) % 3]})


def onering_walk(t, n):
    k = n["valence"]
    t.assertEqual((n["triangles"], n["vertices"], n["refusals"]), (k, k, k))
    t.assertEqual(n["triangles at step"], 3)


def follows(corners, a, b):
    """The face has a then b."""
    return corners[(corners.index(a) + 1) % len(corners)] == b


def winged_edge(t, n):
    p, q = n["P Q"]
    a, b, c, d = (set(n["ends of a b c d"][2 * i:2 * i + 2]) for i in range(4))
    left, right = n["corners of L"], n["corners of R"]
    t.assertTrue(follows(left, p, q) and follows(right, q, p), "L lies on the left of PQ")
    t.assertTrue(q in a and a <= set(left), "a at Q on the left")
    t.assertTrue(p in b and b <= set(left), "b at P on the left")
    t.assertTrue(p in c and c <= set(right), "c at P on the right")
    t.assertTrue(q in d and d <= set(right), "d at Q on the right")


def half_edge(t, n):
    p, q = n["PQ"]
    t.assertEqual(n["pair"], [q, p])
    t.assertEqual(n["vert"], q)
    t.assertEqual(n["next b"][0], q)
    t.assertEqual(n["prev a"][1], p)
    for edge in (n["PQ"], n["next b"], n["prev a"]):
        t.assertTrue(follows(n["corners of L"], *edge))


def half_edge_faces(t, n):
    t.assertGreater(n["least area on the left"], 0, "anticlockwise in every face")
    t.assertEqual(n["half-edges with a face on both sides"], 12)
    t.assertEqual(n["of these opposite to their pair"], 12)
    t.assertTrue(n["next of e1 is e2 and prev is e3"])


def face_normal(t, n):
    for x, y in zip(n["(2.5)"], n["cross product"]):
        t.assertAlmostEqual(x, y, 6)
    t.assertAlmostEqual(n["length"], n["twice the area by its sides"], 9)


def shading(t, n):
    t.assertEqual((n["face normals"], n["vertex normals"]), (n["F"], n["V"]))


def adjacency_primitive(t, n):
    v = n["V0 to V5"]
    t.assertEqual(sorted(v[0::2]), sorted(n["corners"]))
    t.assertEqual(v[1::2], n["beyond V0V2, V2V4, V4V0"])
    silhouette, crease, border = n["n1.view, n2.view, angle"][:3], n["n1.view, n2.view, angle"][3:6], n["n1.view, n2.view, angle"][6:]
    t.assertLess(silhouette[0] * silhouette[1], 0, "one faces the viewer, one does not")
    t.assertTrue(crease[0] > 0 and crease[1] > 0 and crease[2] > 60)
    t.assertEqual(len(border), 1, "one face only")


def adjacency_halfedges(t, n):
    t.assertEqual(n["target of next of opposite is V1, V3, V5"], [1] * 6)
    t.assertEqual(len(set(n["inner"])), 6)
    v = n["border"]
    repeated = [i for i in (1, 3, 5) if v[i] in v[0::2]]
    t.assertEqual(len(repeated), 1)
    t.assertEqual(v[repeated[0]], v[repeated[0] - 1], "the vertex the side begins at")


def queries(t, n):
    t.assertEqual(n["counts"], [6, 6, 6, 2, 10, 2, 3, 3, 3])


CHECKS = {
    "2.01-cube-lists": cube_lists,
    "2.02-cube-strip": cube_strip,
    "2.03-strip-restart": strip_restart,
    "2.04-manifold": manifold,
    "2.05-rings": rings,
    "2.06-genus": genus,
    "2.07-face-based": face_based,
    "2.08-onering-walk": onering_walk,
    "2.09-winged-edge": winged_edge,
    "2.10-half-edge": half_edge,
    "2.11-half-edge-faces": half_edge_faces,
    "2.12-face-normal": face_normal,
    "2.13-shading": shading,
    "2.14-adjacency-primitive": adjacency_primitive,
    "2.15-adjacency-halfedges": adjacency_halfedges,
    "2.T1-adjacency-queries": queries,
}
