"""Formats that meshwright-import reads, and the samples that stand for files."""
import os
import random
import unittest

from harness import DATA, SANITIZED, Case, Ran, main, needs_data


@needs_data
class Foreign(Case):
    def test_info(self):
        arnaud = self.json("info", DATA / "characters/pab_arnaud.fbx", "--json")
        self.assertEqual([m["faces"] for m in arnaud["meshes"]], [6670])
        self.assertTrue(arnaud["meshes"][0]["closed"])  # split vertices are one again
        self.assertEqual(arnaud["meshes"][0]["genus"], 0)
        self.assertEqual(len(arnaud["skeletons"]), 1)
        walk = self.json("info", DATA / "characters/pab_walk.fbx", "--json")
        self.assertEqual([c["name"] for c in walk["clips"]], ["walk"])
        self.assertAlmostEqual(walk["clips"][0]["duration"], 4 / 3, 3)
        self.assertEqual(walk["meshes"], [])
        # The motion is for that character.
        self.assertGreater(len(set(walk["skeletons"][0]["joints"]) & set(arnaud["skeletons"][0]["joints"])), 25)
        self.assertIn("metres", self.ok("info", DATA / "characters/pab_arnaud.fbx").out)

    def test_convert(self):
        for name in ("pab_arnaud.fbx", "pab_walk.fbx", "animation_with_skeleton.fbx", "BCN_Epileptic.X", "Testwuson.X", "anim_test.x", "bob/Bob.md5mesh"):
            with self.subTest(name):
                out = self.folder / "out.glb"
                self.ok("convert", DATA / "characters" / name, out)
                before, after = (self.json("info", f, "--json") for f in (DATA / "characters" / name, out))
                self.assertEqual([(c["name"], round(c["duration"], 4)) for c in before["clips"]],
                                 [(c["name"], round(c["duration"], 4)) for c in after["clips"]])
                self.assertEqual(*([sum((int(k) - 2) * n for k, n in m["face_sizes"].items()) for m in i["meshes"]] for i in (before, after)))
                self.assertEqual((before["materials"], before["images"]), (after["materials"], after["images"]))

    def test_crash_is_a_message(self):
        file = DATA / "malformed/assimp/malformed_skinweights_oob.x"
        self.fails("info", file, says=f"{file}: the importer ended by a memory error")
        self.fails("convert", file, self.folder / "x.glb", says="open it in another program")
        self.assertEqual(os.listdir(self.folder), [])

    @unittest.skipIf(SANITIZED, "sanitizers need the address space")
    def test_limits_are_messages(self):
        ran = Ran(["info", DATA / "characters/BCN_Epileptic.X"], environment={**os.environ, "MESHWRIGHT_IMPORT_MEMORY": "1"})
        self.assertEqual(ran.code, 1, ran)
        self.assertTrue(ran.err.startswith("meshwright: "), ran)
        self.assertEqual(ran.err.count("\n"), 1, ran)

    def test_damage(self):
        chance = random.Random(11)
        for name in ("animation_with_skeleton.fbx", "anim_test.x", "bob/Bob.md5mesh", "bob/Bob.md5anim"):
            whole = (DATA / "characters" / name).read_bytes()
            damaged = self.folder / os.path.basename(name)
            for i in range(16):
                content = bytearray(whole[:chance.randrange(len(whole))] if i % 3 == 0 else whole)
                for _ in range(0 if i % 3 == 0 else 1 + i):
                    at = chance.randrange(min(2000, len(content)) if i % 2 else len(content))
                    content[at] = chance.choice((0, 255, 45, 57, chance.randrange(256)))
                damaged.write_bytes(content)
                ran = Ran(["info", damaged, "--json"], limit=90)
                with self.subTest(name, case=i):
                    self.assertIn(ran.code, (0, 1), ran)
                    self.assertLess(ran.seconds, 70, ran)
                    if ran.code == 1:
                        self.assertTrue(ran.err.startswith(f"meshwright: {damaged}"), ran)


class Bombs(Case):
    """Small files whose numbers are large, or that nest too deep for a stack."""

    def refused(self, name, text):
        ran = Ran(["info", self.write(name, text)], limit=60)
        self.assertEqual(ran.code, 1, ran)
        self.assertTrue(ran.err.startswith(f"meshwright: {self.folder / name}: "), ran)
        self.assertLess(ran.seconds, 20, ran)
        if not SANITIZED:
            self.assertLess(ran.peak, 1200e6, ran)

    def test_counts(self):
        point = "3; 0.0;0.0;0.0;, 1.0;0.0;0.0;, 1.0;1.0;0.0;; 1; 3;0,1,2;;"
        self.refused("vertices.x", "xof 0303txt 0032\nMesh m { 2000000000; 0.0;0.0;0.0;; }\n")
        self.refused("weights.x", "xof 0303txt 0032\nMesh m { %s XSkinMeshHeader {1;1;1;} SkinWeights { \"b\"; 2000000000; 0; 1.0; } }\n" % point)
        self.refused("frames.md5anim", 'MD5Version 10\ncommandline ""\nnumFrames 2000000000\nnumJoints 1\nframeRate 24\nnumAnimatedComponents 6\n')

    def test_depth(self):
        self.refused("deep.x", "xof 0303txt 0032\n" + "Frame a {" * 100000 + "}" * 100000)
        self.refused("deep.dae", '<COLLADA version="1.4.1"><library_visual_scenes><visual_scene id="s">' + "<node>" * 100000 + "</node>" * 100000 +
                     "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>")


class Samples(Case):
    def test_stand_for_files(self):
        info = self.json("info", "sample:mannequin", "--json")
        self.assertEqual(sorted(c["name"] for c in info["clips"]), ["Idle", "Walk"])
        self.assertIn("LeftUpperArm", info["skeletons"][0]["joints"])
        self.assertEqual(info["meshes"][0]["genus"], 0)
        self.ok("convert", "sample:mannequin", self.folder / "m.glb")
        after = self.json("info", self.folder / "m.glb", "--json")
        self.assertEqual(sorted(c["name"] for c in after["clips"]), ["Idle", "Walk"])
        self.ok("pose", "sample:mannequin", "--clip", "Walk", "--time", "0.3", "-o", self.folder / "p.obj")
        self.assertEqual(self.mesh(self.folder / "p.obj")["vertices"], info["meshes"][0]["vertices"])

    def test_unknown_name(self):
        self.fails("info", "sample:nobody", says="mannequin")


if __name__ == "__main__":
    main()
