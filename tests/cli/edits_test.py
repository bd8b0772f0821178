"""process --do: edits and operations in turn; the lines that the window copies."""
import shlex
import signal
import subprocess

from harness import PROGRAM, Case, main


class Edits(Case):
    def nodes(self, file):
        return sorted(n["name"] for n in self.json("info", file, "--json")["nodes"])

    def test_edits_and_operations_in_turn(self):
        out = self.folder / "o.glb"
        ran = self.ok("process", "-", "--do", "add:op=icosphere,with=subdivisions=2,name=left", "--do", "duplicate:nodes=left",
                      "--do", "transform:node=left 2,position=5/0/0", "--op", "subdivide-loop", "--do", "join:nodes=left 2+left", "-o", out)
        self.assertIn("1 node, 1 mesh of", ran.out)
        m = self.mesh(out)
        self.assertEqual((m["faces"], m["components"], m["euler"]), (2 * 4 * 320, 2, 4))

    def test_a_source_and_edits_of_it(self):
        out = self.folder / "o.glb"
        self.ok("process", "-", "--op", "icosphere:subdivisions=1", "--do", "delete-elements:node=icosphere,elements=0;5", "-o", out)
        m = self.mesh(out)
        self.assertEqual((m["faces"], m["closed"]), (78, False))

    def test_modifiers_as_edits_are_modifiers_and_operations_alike(self):
        sphere = self.source("s.glb", "icosphere:subdivisions=3")
        a, b, c = (self.folder / n for n in ("a.ply", "b.ply", "c.ply"))
        self.ok("process", sphere, "--op", "decimate-quadric:stop=faces,faces=200", "--op", "smooth", "-o", a)
        self.ok("process", sphere, "--do", 'modify:node=icosphere,op=decimate-quadric,with="stop=faces,faces=200"', "--do",
                "modify:node=icosphere,op=smooth", "-o", b)
        self.ok("process", sphere, "--op", "decimate-quadric:stop=faces,faces=200", "--do", "modify:node=icosphere,op=smooth", "-o", c)
        self.assertEqual(a.read_bytes(), b.read_bytes())
        self.assertEqual(a.read_bytes(), c.read_bytes())

    def test_in_one_go_as_one_by_one(self):
        edits = ["add:op=icosphere,with=subdivisions=1,name=it's a \"ball\"", "new-terrain:with=size=33", "stroke:node=Terrain,radius=90,points=-10/5;70/80.5",
                 "new-material:node=#2,name=red,color=1/0/0,faces=0-9", "separate:node=#2,by=materials", "group:nodes=#2,name=Set"]
        whole = self.folder / "whole.glb"
        self.ok("process", "-", *[w for e in edits for w in ("--do", e)], "--project", "-o", whole)
        last = "-"
        for i, e in enumerate(edits):
            part = self.folder / f"{i}.glb"
            self.ok("process", last, "--do", e, "--project", "-o", part)
            last = part
        self.assertEqual(whole.read_bytes(), last.read_bytes())

    def test_words_of_a_shell(self):
        line = "process - --do 'add:name=two words' --do 'rename:node=two words,name=\"a, b\"' --project -o"
        out = self.folder / "o.glb"
        self.ok(*shlex.split(line), out)
        self.assertEqual(self.mesh(out)["faces"] > 0, True)

    def test_what_takes_long_is_told_before_it_begins(self):
        sphere = self.source("s.ply", "icosphere:subdivisions=6")
        process = subprocess.Popen([PROGRAM, "process", sphere, "--op", "smooth:iterations=10000", "-o", self.folder / "o.ply"], stderr=subprocess.PIPE,
                                   text=True)
        line = process.stderr.readline()
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), 130)
        process.stderr.close()
        self.assertRegex(line, r"^meshwright: smooth on 81920 faces: about \d+ (s|min) expected; Ctrl\+C ends it$")
        self.assertFalse((self.folder / "o.ply").exists())
        self.assertNotIn("expected", self.ok("process", sphere, "--op", "smooth", "-o", self.folder / "o.ply").err)

    def test_refusals(self):
        out = self.folder / "o.glb"

        def refused(*words, says):
            self.fails("process", *words, "-o", out, says=says)
            self.assertFalse(out.exists())

        refused("-", "--do", "explode:node=a", says='there is no edit "explode"')
        refused("-", "--do", "delete:nodes=lamp", says='delete:nodes=lamp: there is no node "lamp"')
        refused("-", "--do", "delete:lamps=lamp", says="there is no parameter")
        refused("-", "--do", "add", "--op", "vertex-valence", says="cannot stand beside --do")
        refused("-", "--do", "add", "--do", "modify:node=Icosphere,op=subdivide-loop,with=levels=99", says="levels=99")
        refused(self.folder / "no.obj", "--do", "add", says="no.obj")


if __name__ == "__main__":
    main()
