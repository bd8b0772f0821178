"""Words on the command line: help, wrong usage, exit statuses, no display."""
import os
import subprocess

from harness import PROGRAM, SANITIZED, Case, Ran, main

VERBS = ["info", "algorithms", "edits", "process", "step", "convert", "lessons"] + ([] if SANITIZED else ["render", "gallery"])


class Usage(Case):
    def test_overview_names_every_verb(self):
        out = self.ok("--help").out
        for verb in VERBS:
            self.assertIn(f"\n  {verb} ", out)

    def test_every_verb_has_help(self):
        for verb in VERBS:
            ran = self.ok(verb, "--help")
            self.assertTrue(ran.out.startswith(f"usage: meshwright {verb}"), ran)
            self.assertEqual(ran.err, "")

    def test_wrong_usage_is_2(self):
        for verb in VERBS:
            ran = self.fails(verb, "--no-such-option", code=2, says="usage: ")
            self.assertIn(verb, ran.err)
        self.fails("--no-such-option", code=2)
        self.fails("inof", code=2, says="neither a verb nor a file")
        self.fails("info", code=2, says="FILE is missing")
        self.fails("info", "a.obj", "b.obj", code=2, says="one argument too many")
        self.fails("convert", "a.obj", code=2, says="OUT is missing")
        self.fails("process", "a.obj", "--op", "weld", code=2, says="-o OUT is missing")
        self.fails("process", "a.obj", "-o", code=2, says="-o wants a value")
        self.fails("step", "a.obj", code=2, says="--op ID is missing")
        self.fails("step", "a.obj", "--op", "weld", "--until", "soon", code=2, says="--until wants a whole number")

    def test_version(self):
        self.assertRegex(self.ok("--version").out, r"^meshwright \d+\.\d+\.\d+\n$")

    def test_unreadable_files_are_1(self):
        self.fails("info", self.folder / "missing.obj", says="missing.obj: ")
        self.fails("info", self.folder, says=f"{self.folder}: ")
        self.fails("info", self.write("notes.txt", "dear diary"), says="notes.txt: ")
        self.fails("convert", self.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), self.folder / "t.xyz", says="t.xyz: ")
        self.fails("convert", self.folder / "t.obj", self.folder / "no" / "such" / "folder.ply", says="folder.ply: ")

    def test_names_of_files_may_hold_anything(self):
        self.write("a b=c,d:é.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertEqual(self.mesh(self.folder / "a b=c,d:é.obj")["faces"], 1)
        self.write("--json", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        cwd = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, cwd)
        self.assertIn("1 face", self.ok("info", "--", "--json").out)

    def test_without_a_display_the_window_says_so(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
        ran = Ran([], environment=environment)
        self.assertEqual(ran.code, 1, ran)
        self.assertIn("display" if "no window" not in ran.err else "window", ran.err)
        self.assertIn("process", ran.err)

    def test_algorithms_json(self):
        algorithms = self.json("algorithms", "--json")["algorithms"]
        ids = [a["id"] for a in algorithms]
        self.assertEqual(len(ids), len(set(ids)))
        for wanted in ("decimate-quadric", "subdivide-loop", "weld", "icosphere", "vertex-valence", "stripify"):
            self.assertIn(wanted, ids)
        for a in algorithms:
            self.assertLessEqual({"id", "title", "section", "accepts", "yields", "steps", "params"}, a.keys())
            for p in a["params"]:
                self.assertLessEqual({"name", "unit", "type", "min", "max", "default", "help"}, p.keys(), a["id"])
                self.assertTrue(p["help"], (a["id"], p["name"]))

    def test_algorithms_text_names_all(self):
        out = self.ok("algorithms").out
        for a in self.json("algorithms", "--json")["algorithms"]:
            self.assertIn(f"\n{a['id']} - ", out)

    def test_edits(self):
        edits = self.json("edits", "--json")["edits"]
        ids = [e["id"] for e in edits]
        self.assertEqual(len(ids), len(set(ids)))
        for wanted in ("add", "import", "delete", "duplicate", "join", "separate", "modify", "transform", "stroke"):
            self.assertIn(wanted, ids)
        out = self.ok("edits").out
        for e in edits:
            self.assertIn(f"\n{e['id']} - {e['title']}\n", out)
            for p in e["params"]:
                self.assertTrue(p["help"], (e["id"], p["name"]))

    def test_lessons(self):
        lessons = self.json("lessons", "--json")["lessons"]
        steps = [a["id"] for a in self.json("algorithms", "--json")["algorithms"] if a["steps"]]
        self.assertLessEqual(set(steps), {lesson["id"] for lesson in lessons})
        self.assertTrue(self.ok("lessons").out)

    def test_a_reader_that_stops_early_ends_the_program(self):
        process = subprocess.Popen([PROGRAM, "step", "-", "--op", "icosphere:subdivisions=7"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        process.stdout.readline()
        process.stdout.close()
        process.wait(timeout=30)

    def test_a_full_disk_is_no_success(self):
        with open("/dev/full", "w") as full:
            process = subprocess.run([PROGRAM, "algorithms"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.returncode, 1)
        self.assertIn("standard output", process.stderr)


if __name__ == "__main__":
    main()
