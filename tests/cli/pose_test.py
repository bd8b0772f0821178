"""pose: joints and meshes at a time of a clip, and what it says when there is no such clip or time."""
import csv
import json
import math
import struct

from harness import DATA, Case, main, needs_data

ARM = """HIERARCHY
ROOT shoulder
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT elbow, left
  {
    OFFSET 2 0 0
    CHANNELS 1 Zrotation
    End Site
    {
      OFFSET 1 0 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.5
0 1 0 0 0 0 0
0 1 0 0 0 0 90
0 5 0 90 0 0 90
"""


def gltf(file):
    """The JSON of a .glb."""
    data = file.read_bytes()
    return json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])


class Pose(Case):
    def joints(self, file, time, *options):
        table = self.folder / "joints.csv"
        self.ok("pose", file, "--time", time, "-o", table, *options)
        lines = list(csv.reader(table.read_text().splitlines()))
        self.assertEqual(lines[0], ["joint", "x", "y", "z"])
        return {line[0]: [float(v) for v in line[1:]] for line in lines[1:]}

    def near(self, a, b, tolerance=1e-6):
        self.assertEqual(len(a), len(b))
        for x, y in zip(a, b):
            self.assertLess(abs(x - y), tolerance, (a, b))

    def test_joints_of_an_arm(self):
        arm = self.write("arm.bvh", ARM)
        self.near(self.joints(arm, 0)["elbow, left end"], (3, 1, 0))
        places = self.joints(arm, 0.5)
        self.assertEqual(list(places), ["shoulder", "elbow, left", "elbow, left end"])
        self.near(places["elbow, left"], (2, 1, 0))
        self.near(places["elbow, left end"], (2, 2, 0))
        self.near(self.joints(arm, 0.25)["elbow, left end"], (2 + math.sqrt(0.5), 1 + math.sqrt(0.5), 0))
        self.near(self.joints(arm, 1)["elbow, left end"], (-1, 7, 0))

    def test_json_names_clip_time_and_parents(self):
        out = self.folder / "joints.json"
        self.ok("pose", self.write("arm.bvh", ARM), "--clip", "#0", "--time", 1, "-o", out)
        whole = json.loads(out.read_text())
        self.assertEqual((whole["clip"], whole["time"]), ("arm", 1))
        self.assertEqual([j["parent"] for j in whole["joints"]], [None, 0, 1])
        self.assertEqual([j["end"] for j in whole["joints"]], [False, False, True])
        self.near([whole["joints"][2][k] for k in "xyz"], (-1, 7, 0))

    def test_bones_as_lines(self):
        arm = self.write("arm.bvh", ARM)
        out = self.folder / "arm.obj"
        self.ok("pose", arm, "--time", 1, "-o", out)
        text = out.read_text().splitlines()
        self.assertEqual([line for line in text if line.startswith("l ")], ["l 1 2", "l 2 3"])
        self.near([float(v) for v in [line for line in text if line.startswith("v ")][2].split()[1:]], (-1, 7, 0))
        for name in ("arm.glb", "arm.ply"):
            self.ok("pose", arm, "--time", 0, "-o", self.folder / name)
            self.assertEqual(self.mesh(self.folder / name)["vertices"], 3)

    def test_times_and_clips_that_are_not_there(self):
        arm = self.write("arm.bvh", ARM)
        out = self.folder / "j.csv"
        for time, pose in ((-1, "first"), (99, "last")):
            said = self.ok("pose", arm, "--time", time, "-o", out).err
            self.assertIn(f"its {pose} pose is taken", said)
        self.fails("pose", arm, "--time", 0, "--clip", "run", "-o", out, says='#0 "arm"')
        self.fails("pose", arm, "--time", 0, "--clip", "#1", "-o", out, says='#0 "arm"')
        self.fails("pose", arm, "-o", out, code=2, says="--time")
        self.fails("pose", arm, "--time", "soon", "-o", out, code=2, says="seconds")
        self.fails("pose", arm, "--time", "nan", "-o", out, code=2, says="seconds")
        self.fails("pose", arm, "--time", 0, code=2, says="-o")
        self.fails("pose", arm, "--time", 0, "-o", self.folder / "a.bvh", says="no motion")
        sphere = self.source("s.obj", "icosphere:subdivisions=1")
        self.fails("pose", sphere, "--time", 0, "-o", out, says="no skeleton")
        self.fails("pose", sphere, "--time", 0, "--clip", "walk", "-o", self.folder / "t.obj", says="no clip")
        self.assertIn("at rest", self.ok("pose", sphere, "--time", 0, "-o", self.folder / "t.obj").out)

    @needs_data
    def test_characters_keep_nothing_that_moves(self):
        for name in ("cesium_man.gltf", "rigged_simple.gltf", "robot.glb"):
            file = DATA / "characters" / name
            out = self.folder / "posed.glb"
            self.ok("pose", file, "--time", 0.3, "-o", out)
            self.assertFalse({"skins", "animations"} & set(gltf(out)), name)
            before, after = self.json("info", file, "--json"), self.json("info", out, "--json")
            self.assertEqual(sum(m["faces"] for m in before["meshes"]), sum(m["faces"] for m in after["meshes"]), name)
            self.assertGreater(len(self.joints(file, 0.3)), 1)


if __name__ == "__main__":
    main()
