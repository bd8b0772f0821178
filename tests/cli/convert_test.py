"""convert: what goes round through other formats comes back as it was."""
import json
import os

from harness import DATA, Case, main, needs_data

SAME = ("vertices", "edges", "faces", "face_sizes", "euler", "genus", "components", "boundary_loops", "boundary_edges", "nonmanifold_edges")


class RoundTrip(Case):
    def same(self, a, b, keys=SAME):
        a, b = self.mesh(a), self.mesh(b)
        for key in keys:
            self.assertEqual(a[key], b[key], key)
        self.assertAlmostEqual(a["area"], b["area"], delta=1e-5 * max(1e-9, a["area"]))


class Convert(RoundTrip):
    def test_polygons_through_ply_and_obj(self):
        first = self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0.1234567\nf 1 2 3 4\nf 2 5 3\n")
        here = first
        for name in ("b.ply", "c.obj", "d.ply", "e.obj"):
            self.ok("convert", here, self.folder / name)
            here = self.folder / name
        self.same(first, here)
        self.assertEqual(self.mesh(first)["bounds"], self.mesh(here)["bounds"])

    def test_polygons_come_back_from_a_project(self):
        first = self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2 5 3\n")
        self.ok("convert", first, self.folder / "a.glb", "--project")
        self.same(first, self.folder / "a.glb")
        self.ok("convert", self.folder / "a.glb", self.folder / "b.obj")
        self.same(first, self.folder / "b.obj")

    def test_ascii_ply(self):
        self.ok("convert", self.source("s.glb", "icosphere:subdivisions=1"), self.folder / "s.ply", "--ascii")
        self.assertIn("format ascii 1.0", (self.folder / "s.ply").read_text())
        self.same(self.folder / "s.glb", self.folder / "s.ply")

    def test_onto_itself(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=2")
        before = self.mesh(sphere)
        self.ok("convert", sphere, sphere)
        self.assertEqual(before, self.mesh(sphere))

    def test_an_interrupted_write_leaves_the_old_file(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=1")
        before = sphere.read_bytes()
        self.fails("process", sphere, "--op", "decimate-quadric:ratio=9", "-o", sphere)
        self.assertEqual(sphere.read_bytes(), before)
        self.assertEqual(os.listdir(self.folder), ["s.ply"])


@needs_data
class RealFiles(RoundTrip):
    def test_round_trips(self):
        for file in ("meshes/closed_genus0/spot.obj", "meshes/quads/suzanne.obj", "meshes/nonmanifold/fan3.obj",
                     "meshes/nonmanifold/moebius.obj", "meshes/format_variants/float-color.ply", "meshes/nonmanifold/spider.obj"):
            with self.subTest(file):
                for name in ("x.ply", "x.obj"):
                    self.ok("convert", DATA / file, self.folder / name)
                    self.same(DATA / file, self.folder / name)
                self.ok("convert", DATA / file, self.folder / "x.glb", "--project")
                self.same(DATA / file, self.folder / "x.glb")

    def test_gltf_hierarchies(self):
        for file in ("characters/robot.glb", "characters/cesium_man.gltf"):
            with self.subTest(file):
                self.ok("convert", DATA / file, self.folder / "x.glb")
                before, after = (self.json("info", f, "--json") for f in (DATA / file, self.folder / "x.glb"))
                self.assertEqual([m["faces"] for m in before["meshes"]], [m["faces"] for m in after["meshes"]])
                self.assertEqual((before["materials"], before["images"]), (after["materials"], after["images"]))
                json.dumps(after)


if __name__ == "__main__":
    main()
