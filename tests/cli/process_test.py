"""process: sources, operations in turn on files, tables; and what it refuses."""
import csv
import json
import math
import struct

from harness import DATA, SANITIZED, Case, Ran, main, needs_data


class Process(Case):
    def test_sphere_to_every_format(self):
        for name in ("s.glb", "s.gltf", "s.obj", "s.ply"):
            m = self.mesh(self.source(name, "icosphere:subdivisions=3"))
            self.assertEqual((m["vertices"], m["edges"], m["faces"], m["genus"], m["closed"]), (642, 1920, 1280, 0, True), name)
            self.assertLess(abs(m["volume"] - 4 / 3 * math.pi), 0.05)

    def test_operations_in_turn(self):
        m = self.mesh(self.source("s.ply", "icosphere:subdivisions=2", "subdivide-loop:levels=2", "decimate-quadric:ratio=0.25"))
        self.assertEqual((m["faces"], m["genus"]), (320 * 16 // 4, 0))

    def test_says_what_changed(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=2")
        out = self.ok("process", sphere, "--op", "subdivide-loop:levels=1", "-o", self.folder / "t.ply").out
        self.assertIn("162 vertices, 320 faces -> 642 vertices, 1280 faces", out)

    def test_morph_comes_with_its_animation(self):
        sphere, out = self.source("s.obj", "icosphere:subdivisions=2"), self.folder / "m.gltf"
        box = self.source("big box.obj", "box:width=3")
        for words in ([f'morph:other="{box}"'], ["morph:method=sphere-torus"]):
            self.ok("process", sphere, "--op", words[0], "-o", out)
            gltf = json.loads(out.read_text())
            mesh = gltf["meshes"][0]
            self.assertEqual(len(mesh["primitives"][0]["targets"]), 1)
            self.assertEqual(set(mesh["primitives"][0]["targets"][0]), {"POSITION", "NORMAL"})
            self.assertEqual(mesh["extras"]["targetNames"], ["big box" if "other" in words[0] else "torus"])
            animation = gltf["animations"][0]
            self.assertEqual(animation["channels"][0]["target"]["path"], "weights")
            self.assertIn("mesh", gltf["nodes"][animation["channels"][0]["target"]["node"]])
        # At the middle of the clip it is the other mesh.
        self.ok("process", sphere, "--op", f'morph:other="{box}"', "-o", out)
        posed = self.folder / "posed.obj"
        self.ok("pose", out, "--time", "2", "-o", posed)
        self.assertAlmostEqual(self.mesh(posed)["volume"], 3, places=4)
        self.ok("pose", out, "--time", "4", "-o", posed)
        self.assertAlmostEqual(self.mesh(posed)["volume"], self.mesh(sphere)["volume"], places=4)
        self.ok("process", sphere, "--op", f'morph:other="{box}"', "-o", self.folder / "p.glb", "--project")
        self.ok("pose", self.folder / "p.glb", "--time", "2", "-o", posed)

    def test_a_map_is_in_the_gltf(self):
        out = self.folder / "m.gltf"
        self.source("m.gltf", "house", "embed-planar")
        gltf = json.loads(out.read_text())
        data = (self.folder / gltf["buffers"][0]["uri"]).read_bytes()
        primitive = gltf["meshes"][0]["primitives"][0]

        def values(index, letter, width):
            accessor = gltf["accessors"][index]
            view = gltf["bufferViews"][accessor["bufferView"]]
            at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            flat = struct.unpack_from(f"<{accessor['count'] * width}{letter}", data, at)
            return [flat[i:i + width] for i in range(0, len(flat), width)]

        places = values(primitive["attributes"]["TEXCOORD_0"], "f", 2)
        corners = [c for (c,) in values(primitive["indices"], "H", 1)]
        self.assertEqual((len(places), len(corners)), (15, 66))
        ring = [set() for _ in places]
        for i, c in enumerate(corners):
            ring[c] |= set(corners[i - i % 3:i - i % 3 + 3]) - {c}
        border = [v for v, p in enumerate(places) if abs(math.dist(p, (0.5, 0.5)) - 0.5) < 1e-6]
        self.assertEqual(len(border), 6)
        for v in set(range(15)) - set(border):
            for k in (0, 1):
                self.assertAlmostEqual(places[v][k], sum(places[w][k] for w in ring[v]) / len(ring[v]), places=5)

    def test_tables(self):
        sphere = self.source("s.obj", "icosphere:subdivisions=2")
        table = self.folder / "v.csv"
        self.ok("process", sphere, "--op", "vertex-valence", "-o", table)
        lines = list(csv.reader(table.read_text().splitlines()))
        self.assertEqual(lines[0][0], "vertex")
        valences = [float(line[1]) for line in lines[1:]]
        self.assertEqual((len(valences), valences.count(5), valences.count(6)), (162, 12, 150))
        strips = self.folder / "s.json"
        self.ok("process", sphere, "--op", "stripify", "-o", strips)
        result = json.loads(strips.read_text())
        self.assertEqual(result["operation"], "stripify")
        self.assertEqual(len(result["results"]), 1)
        self.assertTrue(result["results"][0]["summary"] or result["results"][0]["lists"])

    def test_distance_to_another_file(self):
        fine = self.source("fine.obj", "icosphere:subdivisions=4,radius=2")
        coarse = self.source("coarse.obj", "icosphere:subdivisions=2,radius=2")
        out = self.folder / "d.json"
        self.ok("process", coarse, "--op", f"distance:other={fine}", "-o", out)
        result = json.loads(out.read_text())["results"][0]
        found = result["summary"]
        # Vertices of the coarse one are vertices of the fine one; the middle of its largest face is farthest from the sphere.
        self.assertLess(max(result["columns"][1]["values"]), 1e-6)
        self.assertAlmostEqual(found["hausdorff %"], 100 * found["hausdorff"] / found["diagonal"], 6)
        self.assertGreaterEqual(found["hausdorff"], found["rms"])
        self.assertTrue(0.01 < found["hausdorff"] < 0.1, found)
        onto = self.source("onto.obj", "icosphere:subdivisions=2,radius=3")
        back = self.folder / "back.obj"
        self.ok("process", onto, "--op", f"project-onto:other={fine}", "-o", back)
        self.ok("process", back, "--op", f"distance:other={fine}", "-o", out)
        self.assertLess(max(json.loads(out.read_text())["results"][0]["columns"][1]["values"]), 1e-5)
        self.fails("process", coarse, "--op", "distance", "-o", out, says="other")
        self.fails("process", coarse, "--op", "distance:other=nobody", "-o", out, says="nobody")
        if SANITIZED:
            return  # that program has no renderer
        self.ok("render", coarse, "-o", self.folder / "d.png", "--style", f"heat:distance:other={fine}", "--size", "300x200")
        self.ok("render", coarse, "-o", self.folder / "e.png", "--style", "heat:edge-dihedral:form=cosine", "--size", "300x200")

    def test_refusals(self):
        sphere = self.source("s.obj", "icosphere:subdivisions=1")
        out = self.folder / "out.glb"

        def refused(*words, says):
            self.fails("process", *words, "-o", out, says=says)
            self.assertFalse(out.exists())

        refused(sphere, "--op", "decimate-quadrics", says="decimate-quadric")
        refused(sphere, "--op", "decimate-quadric:ratio=7", says="ratio=7")
        refused(sphere, "--op", "decimate-quadric:ratio=nan", says="ratio=nan")
        refused(sphere, "--op", "decimate-quadric:ratio=-1e300", says="ratio=")
        refused(sphere, "--op", "decimate-quadric:ratio=lots", says="must be a number")
        refused(sphere, "--op", "decimate-quadric:ratio", says="no value")
        refused(sphere, "--op", "decimate-quadric:size=1", says="there is no parameter")
        refused(sphere, "--op", "subdivide-loop:levels=1000000", says="levels=")
        refused(sphere, "--op", "subdivide-loop:levels=99999999999999999999999", says="levels=")
        refused(sphere, "--op", "icosphere", says="from nothing")
        refused("-", "--op", "weld", says="source")
        refused("-", "--op", "icosphere:subdivisions=99", says="subdivisions=99")
        refused("-", "--op", "icosphere", "--op", "vertex-valence", says=".csv")
        refused("-", "--op", "icosphere", "--op", "vertex-valence", "--op", "weld", says="must be the last")
        self.fails("process", sphere, "-o", self.folder / "a.csv", says="a.csv: ")

    def test_quads_are_refused_or_cut_by_loop_but_never_crash(self):
        quad = self.write("q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        ran = Ran(["process", quad, "--op", "subdivide-loop", "-o", self.folder / "q.ply"])
        self.assertIn(ran.code, (0, 1), ran)
        if ran.code == 1:
            self.assertIn("q.obj: ", ran.err)

    def test_project_keeps_modifiers(self):
        out = self.folder / "p.glb"
        cube = self.write("c.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")
        self.ok("process", cube, "--op", "weld", "--project", "-o", out)
        m = self.mesh(out)
        self.assertEqual((m["faces"], m["face_sizes"]), (6, {"4": 6}))
        self.assertIn("after 1 modifier", self.ok("info", out).out)


class OtherKinds(Case):
    def test_curves(self):
        out = self.folder / "c.csv"
        self.ok("process", "-", "--op", "sample-curve:given=0,0 1,1 2,0 3,1", "--op", "subdivide-curve:levels=1", "-o", out)
        lines = out.read_text().splitlines()
        self.assertEqual(lines[0], "x,y,z")
        self.assertEqual(len(lines), 1 + 7)
        x, y, _ = map(float, lines[1 + 3].split(","))  # between the second and the third: -1/16, 9/16, 9/16, -1/16
        self.assertAlmostEqual(x, 1.5)
        self.assertAlmostEqual(y, (-0 + 9 * 1 + 9 * 0 - 1) / 16)
        again = self.folder / "d.json"
        self.ok("process", out, "--op", "subdivide-curve:levels=2,scheme=b-spline", "-o", again)
        curve = json.loads(again.read_text())
        self.assertEqual((curve["kind"], len(curve["points"]), len(curve["control"])), ("curve", 25, 7))
        self.ok("process", out, "--op", "subdivide-curve", "-o", self.folder / "lines.obj")

    def test_poses(self):
        out = self.folder / "p.json"
        ran = self.ok("process", "-", "--op", "joint-chain:links=3,target=1.5/1/0", "--op", "fabrik:tolerance=1e-6", "-o", out)
        self.assertIn("from its target", ran.out)
        pose = json.loads(out.read_text())
        places = [j["place"] for j in pose["joints"]]
        for a, b in zip(places, places[1:]):
            self.assertAlmostEqual(math.dist(a, b), 1, 6)
        self.assertLess(math.dist(places[-1], (1.5, 1, 0)), 1e-6)
        table = self.folder / "p.csv"
        self.ok("process", "-", "--op", "joint-chain", "-o", table)
        self.assertEqual(len(table.read_text().splitlines()), 1 + 5)

    def test_rotations(self):
        out = self.folder / "r.csv"
        self.ok("process", "-", "--op", "interpolate-rotation:samples=5", "-o", out)
        rows = out.read_text().splitlines()
        self.assertEqual(len(rows), 1 + 15)
        self.assertEqual({len(r.split(",")) for r in rows}, {9})

    def test_height_maps(self):
        out = self.folder / "h.png"
        self.ok("process", "-", "--op", "diamond-square:size=33", "-o", out)
        head = out.read_bytes()[:26]
        self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual((int.from_bytes(head[16:20], "big"), head[24], head[25]), (33, 16, 0), "16 bits, grey")

    def test_refusals(self):
        self.fails("process", "-", "--op", "joint-chain", "-o", self.folder / "p.glb", says=".json or .csv")
        self.fails("process", "-", "--op", "sample-curve", "--op", "weld", "-o", self.folder / "c.csv", says="not on a curve")
        self.fails("process", "-", "--op", "diamond-square:size=33", "-o", self.folder / "h.csv", says=".png")
        self.fails("process", self.write("c.csv", "1,2\n2,3\n"), "--op", "sample-curve", "-o", self.folder / "d.csv", says="give - as input")


@needs_data
class RealFiles(Case):
    def test_scan_to_a_tenth(self):
        out = self.folder / "bunny.glb"
        self.ok("process", DATA / "meshes/boundary/stanford-bunny.obj", "--op", "decimate-quadric:ratio=0.1", "-o", out)
        m = self.mesh(out)
        self.assertAlmostEqual(m["faces"], 6945, delta=8)
        self.assertEqual((m["genus"], m["boundary_loops"], m["nonmanifold_edges"], m["nonmanifold_vertices"]), (0, 5, 0, 0))

    def test_hierarchy_and_materials_stay(self):
        robot = DATA / "characters/robot.glb"
        before = self.json("info", robot, "--json")
        out = self.folder / "r.glb"
        self.ok("process", robot, "--op", "weld", "-o", out)
        after = self.json("info", out, "--json")
        for key in ("nodes", "materials", "images"):
            self.assertEqual(before[key], after[key], key)
        self.assertEqual([m["name"] for m in before["meshes"]], [m["name"] for m in after["meshes"]])


if __name__ == "__main__":
    main()
