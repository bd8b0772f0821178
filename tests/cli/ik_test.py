"""ik: a joint reaches its target, and the file says so. What the file says is worked out here from its JSON, by the glTF specification."""
import json
import math
import struct

from harness import DATA, Case, main, needs_data


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def matrix(t, r, s):
    x, y, z, w = r
    m = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[m[i][k] * s[k] for k in range(3)] + [t[i]] for i in range(3)] + [[0, 0, 0, 1]]


class Gltf:
    """A .glb as it stands at the last key of each channel of its only clip, or at rest."""

    def __init__(self, file):
        data = file.read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.binary = data[20 + length + 8:]

    def last(self, accessor):
        a = self.json["accessors"][accessor]
        assert a["componentType"] == 5126
        view = self.json["bufferViews"][a["bufferView"]]
        n = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
        at = view.get("byteOffset", 0) + a.get("byteOffset", 0) + (a["count"] - 1) * view.get("byteStride", 4 * n)
        return struct.unpack_from("<%df" % n, self.binary, at)

    def worlds(self, clip):
        moved = {}
        for c in self.json["animations"][0]["channels"] if clip else []:
            sampler = self.json["animations"][0]["samplers"][c["sampler"]]
            moved[c["target"]["node"], c["target"]["path"]] = self.last(sampler["output"])
        found = {}

        def visit(i, parent):
            n = self.json["nodes"][i]
            if "matrix" in n:
                local = [[n["matrix"][4 * c + r] for c in range(4)] for r in range(4)]
            else:
                local = matrix(moved.get((i, "translation"), n.get("translation", (0, 0, 0))), moved.get((i, "rotation"), n.get("rotation", (0, 0, 0, 1))),
                               moved.get((i, "scale"), n.get("scale", (1, 1, 1))))
            found[i] = multiply(parent, local)
            for c in n.get("children", []):
                visit(c, found[i])

        for root in self.json["scenes"][0]["nodes"]:
            visit(root, [[float(i == j) for j in range(4)] for i in range(4)])
        return found

    def joints(self):
        """Nodes of the first skin's joints in the order of the tree: as info lists them."""
        joints, order = set(self.json["skins"][0]["joints"]), []

        def visit(i):
            order.extend([i] if i in joints else [])
            for c in self.json["nodes"][i].get("children", []):
                visit(c)

        for root in self.json["scenes"][0]["nodes"]:
            visit(root)
        return order

    def place(self, joint, clip=True):
        """Of a joint by its number, or of a node by its name."""
        if isinstance(joint, str):
            node = [i for i, n in enumerate(self.json["nodes"]) if n.get("name") == joint]
            assert len(node) == 1, joint
        else:
            node = [self.joints()[joint]]
        m = self.worlds(clip)[node[0]]
        return [m[i][3] for i in range(3)]


@needs_data
class Ik(Case):
    file = DATA and DATA / "characters/cesium_man.gltf"

    def rest(self):
        file = self.folder / "rest.glb"
        self.ok("convert", self.file, file)
        gltf = Gltf(file)
        return gltf, max(range(19), key=lambda j: gltf.place(j, clip=False)[2])  # a hand: the joint furthest to one side

    def reach(self, solver, hand, target, *more):
        file = self.folder / "o.glb"
        said = self.json("ik", self.file, "--effector", "#%d" % hand, "--target", ",".join(map(str, target)), "--solver", solver, "-o", file,
                         "--json", *more)
        self.assertEqual(len(self.json("info", file, "--json")["clips"]), 1)
        return said, Gltf(file)

    def test_the_last_key_is_the_solution(self):
        before, hand = self.rest()
        at = before.place(hand, clip=False)
        for solver in ("ccd", "fabrik"):
            target = [0.2, 1.05, 0.35]
            said, gltf = self.reach(solver, hand, target)
            self.assertTrue(said["reached"], said)
            self.assertLess(math.dist(gltf.place(hand), target), 5e-4)
            self.assertEqual(len(gltf.json["animations"]), 1)
            self.assertLess(math.dist(gltf.place(hand, clip=False), at), 1e-5, "the file rests where it did")

    def test_out_of_reach_is_told(self):
        _, hand = self.rest()
        for solver in ("ccd", "fabrik"):
            said, gltf = self.reach(solver, hand, (5, 5, 5))
            self.assertFalse(said["reached"])
            self.assertEqual(said["within_reach"], "too far")
            self.assertAlmostEqual(math.dist(gltf.place(hand), (5, 5, 5)), said["error"], 3)
        ran = self.ok("ik", self.file, "--effector", "#%d" % hand, "--target", "5,5,5", "-o", self.folder / "far.glb")
        self.assertIn("out of reach", ran.out)

    def test_a_longer_chain_reaches_further(self):
        _, hand = self.rest()
        said, gltf = self.reach("fabrik", hand, (0.4, 1.2, 0.4), "--root", "#0")
        self.assertTrue(said["reached"], said)
        self.assertLess(math.dist(gltf.place(hand), (0.4, 1.2, 0.4)), 5e-4)

    def test_a_bvh(self):
        file = DATA / "bvh/01_01.bvh"
        names = self.json("info", file, "--json")["skeletons"][0]["joints"]
        hand = [n for n in names if n.lower().endswith("hand")][0]
        said = self.json("ik", file, "--effector", hand, "--target", "0.2,0.3,0.4", "-o", self.folder / "o.glb", "--json")
        gltf = Gltf(self.folder / "o.glb")
        self.assertAlmostEqual(math.dist(gltf.place(hand), (0.2, 0.3, 0.4)), said["error"], 3)

    def test_refusals(self):
        out = ("-o", self.folder / "o.glb")
        self.fails("ik", self.file, "--effector", "nose", "--target", "1,1,1", *out, says="#1")
        self.fails("ik", self.file, "--effector", "#99", "--target", "1,1,1", *out, says="#0 to #18")
        self.fails("ik", self.file, "--effector", "#3", "--target", "1,1", *out, says="x,y,z", code=2)
        self.fails("ik", self.file, "--effector", "#3", "--target", "1,nan,1", *out, says="target", code=2)
        self.fails("ik", self.file, "--target", "1,1,1", *out, says="--effector", code=2)
        self.fails("ik", self.file, "--effector", "#3", "--target", "1,1,1", "--solver", "magic", *out, says="ccd or fabrik", code=2)
        self.fails("ik", self.file, "--effector", "#0", "--target", "1,1,1", *out, says="is a root")
        sphere = self.source("s.glb", "icosphere")
        self.fails("ik", sphere, "--effector", "a", "--target", "1,1,1", *out, says="no skeleton")


if __name__ == "__main__":
    main()
