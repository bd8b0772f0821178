"""Figures of info: against closed forms on small files, and against the measured table of the outside data."""
import re

from harness import DATA, Case, main, needs_data, rows

KEYS = {"name", "vertices", "edges", "faces", "triangles", "euler", "genus", "components", "boundary_loops", "boundary_edges",
        "nonmanifold_edges", "nonmanifold_vertices", "degenerate_faces", "duplicate_faces", "isolated_vertices", "orientable",
        "consistently_oriented", "closed", "valence_histogram", "valence_sum", "face_size_sum", "regular_vertices", "face_sizes",
        "bounds", "area", "volume", "morph_targets",
        "defects"}
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 2) for y in (0, 2) for z in (0, 2)) + """\
f 1 2 4 3
f 5 7 8 6
f 1 5 6 2
f 3 4 8 7
f 1 3 7 5
f 2 6 8 4
"""


class Info(Case):
    def test_schema(self):
        info = self.json("info", self.write("cube.obj", CUBE), "--json")
        self.assertLessEqual({"file", "meshes", "nodes", "materials", "images", "skeletons", "clips", "terrains", "warnings"}, info.keys())
        self.assertEqual(info["file"], str(self.folder / "cube.obj"))
        self.assertEqual(set(info["meshes"][0]), KEYS)

    def test_cube(self):
        m = self.mesh(self.write("cube.obj", CUBE))
        self.assertEqual((m["vertices"], m["edges"], m["faces"], m["triangles"], m["euler"], m["genus"]), (8, 12, 6, 12, 2, 0))
        self.assertEqual((m["valence_histogram"], m["face_sizes"], m["closed"]), ({"3": 8}, {"4": 6}, True))
        self.assertEqual((m["valence_sum"], m["face_size_sum"], m["regular_vertices"]), (2 * 12, 6 * 4, 0))
        self.assertAlmostEqual(m["area"], 24)
        self.assertAlmostEqual(m["volume"], 8)
        self.assertEqual(m["bounds"], {"min": [0, 0, 0], "max": [2, 2, 2]})

    def test_what_is_wrong_is_said(self):
        fan = self.write("fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 7 7 7\nf 1 2 3\nf 2 1 4\nf 1 2 5\nf 1 1 2\n")
        info = self.json("info", fan, "--json")
        codes = {w["code"] for w in info["warnings"]}
        self.assertLessEqual({"nonmanifold-edges", "degenerate-faces", "isolated-vertices"}, codes)
        edge = next(w for w in info["warnings"] if w["code"] == "nonmanifold-edges")
        self.assertEqual(edge["elements"], [0, 1])
        self.assertIsNone(info["meshes"][0]["genus"])
        text = self.ok("info", fan).out
        self.assertLess(text.index("more than two faces"), text.index("belongs to no face"))
        self.assertIn("Nothing is wrong", self.ok("info", self.write("cube.obj", CUBE)).out)

    def test_worklist_names_what_mends_it(self):
        open_cube = self.write("open.obj", "\n".join(CUBE.split("\n")[:-2]) + "\nv 7 7 7\n")
        defects = {d["id"]: d for d in self.mesh(open_cube)["defects"]}
        self.assertEqual(len(defects), 10)
        self.assertEqual(defects["holes"], {"id": "holes", "count": 1, "repair": "fill-holes"})
        self.assertEqual(defects["isolated-vertices"]["count"], 1)
        self.assertEqual(defects["self-intersections"], {"id": "self-intersections", "count": 0, "repair": None})
        text = self.ok("info", open_cube).out
        self.assertIn("1 hole with 4 edges", text)
        command = re.search(r"meshwright (process .*) -o OUT", text).group(1).split()
        self.assertEqual(command[2:], ["--op", "repair", "--op", "fill-holes"])
        mended = self.folder / "mended.ply"
        self.ok(*command, "-o", mended)
        self.assertIn("Nothing is wrong", self.ok("info", mended).out)
        self.assertAlmostEqual(self.mesh(mended)["volume"], 8)

    def test_self_intersections(self):
        crossing = self.write("x.obj", "v -1 0 0\nv 1 0 0\nv 0 2 0\nv 0 1 -1\nv 0 1 1\nv 0 3 0\nf 1 2 3\nf 4 5 6\n")
        defects = {d["id"]: d["count"] for d in self.mesh(crossing)["defects"]}
        self.assertEqual(defects["self-intersections"], 1)
        out = self.folder / "x.json"
        self.ok("process", crossing, "--op", "self-intersections", "-o", out)
        self.assertIn("[0,1]", out.read_text().replace(" ", "").replace("\n", ""))

    @needs_data
    def test_scans_are_mended_by_the_command_that_is_shown(self):
        for name, loops, isolated in (("boundary/stanford-bunny.obj", 5, 1113), ("large/dragon_871k.ply", 407, 0)):
            file = DATA / "meshes" / name
            defects = {d["id"]: d["count"] for d in self.mesh(file)["defects"]}
            self.assertEqual((defects["holes"], defects["isolated-vertices"]), (loops, isolated))
            text = self.ok("info", file).out
            command = re.search(r"meshwright (process .*) -o OUT", text).group(1).split()
            mended = self.folder / "mended.ply"
            self.ok(*command, "-o", mended)
            after = self.mesh(mended)
            self.assertTrue(after["closed"] and after["consistently_oriented"])
            self.assertEqual([d for d in after["defects"] if d["count"] and d["repair"]], [])

    def test_points_only(self):
        m = self.mesh(self.write("p.obj", "v 1 2 3\nv 4 5 6\n"))
        self.assertEqual((m["vertices"], m["faces"], m["components"], m["area"]), (2, 0, 0, 0))


BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0 5 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.5
0 0 0 0 0 0 0 0 0
1 0 0 0 0 0 0 0 0
2 0 0 0 0 0 0 0 0
"""


class Moving(Case):
    def test_skeleton_and_clip(self):
        file = self.write("walk.bvh", BVH)
        info = self.json("info", file, "--json")
        self.assertEqual(info["skeletons"], [{"root": "Hips", "joints": ["Hips", "Chest"]}])  # an end site is no joint
        clip, = info["clips"]
        self.assertEqual((clip["duration"], clip["channels"], clip["keys"]), (1.0, 9, 27))
        text = self.ok("info", file).out
        self.assertIn('skeleton "Hips": 2 joints (Hips, Chest)', text)
        self.assertIn("1 s, 9 channels, 27 keys, 2 frames a second", text)

    @needs_data
    def test_files_of_the_data_set(self):
        """Joints, clips and durations as their JSON states them."""
        for name, roots, joints, clips, duration in (("cesium_man.gltf", 1, 19, 1, 2.0), ("rigged_simple.gltf", 1, 2, 1, 2.08333),
                                                     ("simple_skin.gltf", 1, 2, 1, 5.5), ("robot.glb", 1, 43, 14, None)):
            info = self.json("info", DATA / "characters" / name, "--json")
            self.assertEqual((len(info["skeletons"]), sum(len(s["joints"]) for s in info["skeletons"]), len(info["clips"])), (roots, joints, clips))
            if duration:
                self.assertAlmostEqual(info["clips"][0]["duration"], duration, 4)
        self.assertEqual(info["clips"][10]["name"], "Robot_Walking")


@needs_data
class Measured(Case):
    """Every OBJ and PLY of the table: V, E, F, components, loops, genus, offenders."""

    def test_every_row(self):
        checked = 0
        for row in rows("Meshes"):
            file = row["file"]
            if not file.endswith((".obj", ".ply")) or not row["V"] or int(row["V"]) == 0:
                continue
            checked += 1
            with self.subTest(file):
                self.compare(self.mesh(DATA / file), row)
        self.assertGreater(checked, 40)

    def compare(self, m, row):
        notes = row["notes"].split("merged by position")[0]
        for key, column in (("vertices", "V"), ("edges", "E"), ("faces", "F"), ("components", "C")):
            self.assertEqual(m[key], int(row[column]), key)
        loops, edges = re.match(r"(\d+)(?: \((\d+) edges\))?", row["boundary loops"]).groups()
        self.assertEqual((m["boundary_loops"], m["boundary_edges"]), (int(loops), int(edges or 0)))
        if row["genus"][0] != "-":
            self.assertEqual(m["genus"], int(row["genus"].split()[0]))
        self.assertEqual(m["nonmanifold_edges"] + m["nonmanifold_vertices"] == 0, row["manifold"] == "yes")
        for key, pattern in (("nonmanifold_edges", r"(\d+) edges with >2 faces"), ("nonmanifold_vertices", r"(\d+) vertices with >1 fan"),
                             ("isolated_vertices", r"(\d+) unreferenced vertices")):
            if found := re.search(pattern, notes):
                self.assertEqual(m[key], int(found.group(1)), key)
        self.assertEqual(m["orientable"], "NOT orientable" not in notes)
        if "winding inconsistent" in notes:
            self.assertFalse(m["consistently_oriented"])


if __name__ == "__main__":
    main()
