"""convert: every format that is read to every format that is written, on real files; units and axes on the command line."""
import struct

from harness import DATA, Case, Ran, main, needs_data

# One file of each format and encoding, and what a target cannot hold of it.
SOURCES = ("meshes/closed_genus0/bumpy.off", "meshes/format_variants/beetle_binary.off", "meshes/format_variants/Wuson.off",
           "meshes/closed_genus0/icosahedron_ascii.stl", "meshes/format_variants/Wuson.stl", "meshes/quads/suzanne.obj",
           "meshes/format_variants/cube_with_vertexcolors.obj", "meshes/format_variants/cube_uv.ply", "meshes/format_variants/cube_binary.ply",
           "characters/robot.glb", "characters/cesium_man.gltf", "characters/animation_with_skeleton.fbx", "characters/Testwuson.X",
           "characters/bob/Bob.md5mesh")
TARGETS = (("glb",), ("gltf",), ("obj",), ("off",), ("off", "--ascii"), ("ply",), ("ply", "--ascii"), ("ply", "--big-endian"), ("stl",), ("stl", "--ascii"))


def size(info):
    """Of all meshes together."""
    low = [min(m["bounds"]["min"][k] for m in info["meshes"]) for k in range(3)]
    high = [max(m["bounds"]["max"][k] for m in info["meshes"]) for k in range(3)]
    return [h - l for l, h in zip(low, high)]


class Units(Case):
    TRIANGLE = "v 0 0 0\nv 1000 0 0\nv 0 0 500\nf 1 2 3\n"

    def test_found_asked_and_shown(self):
        plain, stated = self.write("a.obj", self.TRIANGLE), self.write("b.obj", "# Units: inches\n# up: z\n" + self.TRIANGLE)
        info = self.json("info", plain, "--json")
        self.assertEqual((info["units"], info["metres_per_unit"], info["up"], info["placement_from_file"]), ("unknown", 1, "y", False))
        self.assertIn("unit-guess", [w["code"] for w in info["warnings"]])
        info = self.json("info", plain, "--unit", "mm", "--up", "z", "--json")
        self.assertEqual((info["units"], info["metres_per_unit"], info["up"]), ("millimetres", 0.001, "z"))
        self.assertNotIn("unit-guess", [w["code"] for w in info["warnings"]])
        info = self.json("info", stated, "--json")
        self.assertEqual((info["units"], info["metres_per_unit"], info["up"], info["placement_from_file"]), ("inches", 0.0254, "z", True))
        self.assertIn("units unknown, taken as metres, y up", self.ok("info", plain).out)
        self.assertIn("units inches, z up", self.ok("info", stated).out)

    def test_metres_and_y_up_come_out(self):
        plain = self.write("a.obj", self.TRIANGLE)
        self.ok("convert", plain, self.folder / "b.ply", "--unit", "mm", "--up", "z", "--ascii")
        bounds = self.mesh(self.folder / "b.ply")["bounds"]
        self.assertEqual((bounds["min"], bounds["max"]), ([0, 0, 0], [1, 0.5, 0]))

    def test_any_unit_and_axis_come_out(self):
        plain = self.write("a.obj", self.TRIANGLE)
        for name in ("b.obj", "b.ply", "b.off", "b.stl"):
            self.ok("convert", plain, self.folder / name, "--unit", "mm", "--up", "z", "--out-unit", "0.5", "--out-up", "x")
            bounds = self.mesh(self.folder / name)["bounds"]
            self.assertEqual((bounds["min"], bounds["max"]), ([0, -2, 0], [1, 0, 0]), name)
        self.assertIn("always in metres", self.ok("convert", plain, self.folder / "b.glb", "--out-unit", "mm").err)
        # The same way in and out changes no number.
        self.ok("convert", plain, self.folder / "c.obj", "--unit", "mm", "--up", "z", "--out-unit", "mm", "--out-up", "z")
        self.assertEqual([l for l in (self.folder / "c.obj").read_text().splitlines() if l[0] != "#"], self.TRIANGLE.split("\n")[:-1])

    def test_every_verb_that_reads_takes_them(self):
        file = self.write("a.obj", self.TRIANGLE)
        self.ok("process", file, "--unit", "cm", "--op", "weld", "-o", self.folder / "p.ply")
        self.assertEqual(self.mesh(self.folder / "p.ply")["bounds"]["max"], [10, 0, 5])
        self.ok("pose", file, "--unit", "cm", "--time", "0", "-o", self.folder / "q.ply")
        self.assertEqual(self.mesh(self.folder / "q.ply")["bounds"]["max"], [10, 0, 5])
        self.ok("step", file, "--unit", "cm", "--up", "z", "--op", "weld", "--until", "1")

    def test_nonsense_is_wrong_usage(self):
        file = self.write("a.obj", self.TRIANGLE)
        for words in (("--unit", "parsec"), ("--unit", "0"), ("--unit", "-1"), ("--up", "w"), ("--unit", "1e99")):
            self.fails("info", file, *words, code=2)
        self.fails("convert", file, self.folder / "b.obj", "--out-unit", "parsec", code=2)


class Wild(Case):
    def test_content_tells_whatever_the_name(self):
        stl = b"solid by name only".ljust(80) + struct.pack("<I12fH", 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
        texts = {"OFF (text)": b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "STL (binary)": stl, "OBJ": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                 "STL (text)": b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
                 "PLY (text)": b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"}
        for name in ("a.dat", "noending", "a.ply", "a.stl", "a.off"):
            for form, text in texts.items():
                if form == "OBJ" and name.startswith("a.") and name != "a.dat":
                    continue  # nothing in a line of text says for certain that it is OBJ
                (self.folder / name).write_bytes(text)
                self.assertEqual(self.json("info", self.folder / name, "--json")["format"], form, name)

    def test_lines_and_points_go_through_all_that_hold_them(self):
        here = self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2 3\np 4\n")
        for name in ("b.ply", "c.glb", "d.obj", "e.gltf", "f.ply"):
            self.ok("convert", here, self.folder / name)
            here = self.folder / name
            self.assertIn("2 loose lines", self.ok("info", here).out)
            self.assertEqual(self.mesh(here)["vertices"], 4, name)
        self.assertIn("\np 4\n", (self.folder / "d.obj").read_text())


@needs_data
class Matrix(Case):
    def test_every_format_to_every_other(self):
        for source in SOURCES:
            before = self.json("info", DATA / source, "--json")
            first = None
            for target, *words in TARGETS:
                with self.subTest(f"{source} -> {target} {' '.join(words)}"):
                    out = self.folder / f"x.{target}"
                    self.ok("convert", DATA / source, out, *words)
                    after = self.json("info", out, "--json")
                    triangles = lambda info: sum(m["triangles"] for m in info["meshes"])
                    self.assertEqual(triangles(after), triangles(before))
                    if target in ("glb", "gltf"):
                        self.assertEqual((after["units"], after["up"]), ("metres", "y"))
                        self.assertIn(after["nodes"] - before["nodes"], (0, 1))  # a joint that shows a mesh gets a node for it
                        self.assertEqual([(c["name"], round(c["duration"], 4)) for c in after["clips"]],
                                         [(c["name"], round(c["duration"], 4)) for c in before["clips"]])
                        continue
                    # The formats without a hierarchy agree among each other on where everything is.
                    self.assertEqual(len(after["meshes"]), 1)
                    if target != "stl":
                        self.assertEqual(after["meshes"][0]["faces"], sum(m["faces"] for m in before["meshes"]))
                    mine = (after["meshes"][0]["area"], *after["meshes"][0]["bounds"]["min"], *after["meshes"][0]["bounds"]["max"])
                    first = first or mine
                    for a, b in zip(first, mine):
                        self.assertAlmostEqual(a, b, delta=1e-6 * max(1, abs(a)))
                    if not before["skeletons"]:
                        for a, b in zip(size(before), size(after)):
                            self.assertAlmostEqual(a, b, delta=1e-5 * max(1, abs(a)))

    def test_height_maps_and_motions_say_what_they_cannot_become(self):
        for source in ("terrain", "bvh"):
            for file in sorted((DATA / source).rglob("*"))[:40]:
                if file.suffix not in (".png", ".bvh", ".tga"):
                    continue
                for target in ("off", "stl", "ply", "obj"):
                    ran = Ran(["convert", file, self.folder / f"x.{target}"])
                    self.assertIn(ran.code, (0, 1), ran)
                    if ran.code:
                        self.assertIn("no visible mesh", ran.err)


if __name__ == "__main__":
    main()
