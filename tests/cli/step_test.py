"""step: one JSON object a line with what the step player shows."""
import json
import pathlib

from harness import DATA, Case, main, needs_data

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Step(Case):
    def lines(self, *arguments):
        return [json.loads(line) for line in self.ok("step", *arguments, "--json").out.splitlines()]

    def check(self, lines):
        self.assertEqual([s["step"] for s in lines], list(range(1, len(lines) + 1)))
        for s in lines:
            self.assertEqual(set(s), {"step", "phase", "focus", "numbers", "progress", "file", "line"})
            self.assertTrue(s["phase"])
            for f in s["focus"]:
                self.assertLessEqual({"kind", "index", "role"}, f.keys())
                self.assertIn(f["role"], ("current", "neighbour", "new", "removed", "rejected"))
            # The line is that of a pause in the project's own source: somewhere in the statement that yields.
            source = (ROOT / s["file"]).read_text().splitlines()[:s["line"]]
            statement = "\n".join(source).rsplit("co_yield", 1)
            self.assertEqual(len(statement), 2, s)
            self.assertLessEqual(statement[1].count(";"), 1, s)

    def test_decimation(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=1")
        lines = self.lines(sphere, "--op", "decimate-quadric:ratio=0.5")
        self.check(lines)
        self.assertGreater(len({s["phase"] for s in lines}), 2)
        self.assertTrue(any(s["numbers"] for s in lines))

    def test_every_operation_with_steps(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=1")
        particular = {"embed-planar", "morph"}  # not for any mesh: what their lessons use
        for a in self.json("algorithms", "--json")["algorithms"]:
            if a["steps"]:
                with self.subTest(a["id"]):
                    subject = sphere if a["accepts"] == "mesh" and a["id"] not in particular else "-"
                    self.check(self.lines(subject, "--op", a["id"], "--until", "50"))

    def test_every_kind(self):
        """Poses, curves and rotations are stepped; what they say is what the algorithm did."""
        for solver in ("ccd", "fabrik"):
            lines = self.lines("-", "--op", solver)
            self.check(lines)
            self.assertLess(lines[-1]["numbers"]["error"], 1e-3)
            self.assertTrue(any(f["kind"] == "joint" for s in lines for f in s["focus"]))
        errors = [s["numbers"]["error"] for s in self.lines("-", "--op", "ccd")]
        self.assertTrue(all(b <= a + 1e-12 for a, b in zip(errors, errors[1:])))
        polygon = self.write("p.csv", "x,y\n0,0\n1,2\n3,1\n4,0\n")
        lines = self.lines(polygon, "--op", "subdivide-curve:levels=2")
        self.check(lines)
        self.assertEqual([s["phase"] for s in lines].count("insert"), 3 + 6)
        lines = self.lines("-", "--op", "interpolate-rotation:samples=11")
        speeds = [s["numbers"]["speed"] for s in lines if s["phase"] == "slerp"]
        self.assertAlmostEqual(min(speeds), max(speeds), 4)
        self.check(self.lines("-", "--op", "diamond-square:size=9"))
        self.assertIn("from its target", self.ok("step", "-", "--op", "ccd").out)

    def test_until(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=2")
        self.assertEqual(len(self.lines(sphere, "--op", "decimate-quadric", "--until", "7")), 7)
        self.assertEqual(self.lines(sphere, "--op", "decimate-quadric", "--until", "0"), [])

    def test_text(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=1")
        out = self.ok("step", sphere, "--op", "subdivide-loop:levels=1").out
        self.assertIn("end after", out)
        self.assertIn("core/subdivide/", out)

    def test_refusals(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=1")
        self.fails("step", sphere, "--op", "subdivide-lop", says="subdivide-loop")
        self.fails("step", sphere, "--op", "subdivide-loop:levels=77", says="levels=77")
        self.fails("step", "-", "--op", "weld", says="source")
        self.fails("step", sphere, "--op", "fabrik", says="no skeleton")
        self.fails("step", sphere, "--op", "diamond-square", says="give - as input")
        self.fails("step", self.write("bad.csv", "1,2\n3,x\n"), "--op", "subdivide-curve", says="line 2")
        self.fails("step", self.write("none.csv", "x,y\n"), "--op", "subdivide-curve", says="no point")
        self.fails("step", "-", "--op", "fabrik:effector=nose", says="joint 0")


@needs_data
class RealFiles(Case):
    def test_first_steps_on_a_scan(self):
        ran = self.ok("step", DATA / "meshes/boundary/stanford-bunny.obj", "--op", "decimate-quadric:ratio=0.5", "--until", "100", "--json")
        self.assertEqual(ran.out.count("\n"), 100)

    def test_several_meshes_want_a_choice(self):
        robot = DATA / "characters/robot.glb"
        names = [m["name"] for m in self.json("info", robot, "--json")["meshes"]]
        if len(names) > 1:
            self.fails("step", robot, "--op", "weld", says="--object")
            self.ok("step", robot, "--op", "decimate-quadric", "--until", "3", "--object", names[0])


if __name__ == "__main__":
    main()
