"""Broken files: a message that names file, place and remedy, or a usable mesh and warnings; never a crash, 5 s, or much memory."""
import json
import os
import random

from harness import DATA, SANITIZED, Case, Ran, main, needs_data, rows

ENDINGS = (".obj", ".ply", ".off", ".stl", ".gltf", ".glb", ".x", ".fbx", ".md5mesh", ".md5anim", ".tga")


@needs_data
class Malformed(Case):
    def test_every_file(self):
        described = {row["file"]: row["acceptable behaviour"] for row in rows("Malformed input")}
        files = sorted(f for f in (DATA / "malformed").rglob("*") if f.suffix in ENDINGS)
        self.assertGreater(len(files), 40)
        for file in files:
            with self.subTest(file.name):
                self.check(file, described.get(file.relative_to(DATA).as_posix(), "reject or report"))

    def check(self, file, acceptable):
        ran = Ran(["info", file, "--json"], limit=20)
        self.assertIn(ran.code, (0, 1), ran)
        self.assertLess(ran.seconds, 5 * (4 if SANITIZED else 1), ran)
        if not SANITIZED:
            self.assertLess(ran.peak, 10 * os.path.getsize(file) + 300e6, ran)
        if ran.code == 1:
            self.assertNotIn(acceptable.split()[0], ("load", "load,"), f"should load: {ran}")
            self.assertTrue(ran.err.startswith(f"meshwright: {file}: "), ran)
            self.assertEqual(ran.err.count("\n"), 1, ran)
            self.assertEqual(ran.out, "", ran)
            self.assertGreater(len(ran.err), len(f"meshwright: {file}: ") + 20, "says too little")
            return
        self.assertFalse(acceptable.startswith("reject with"), f"should be rejected: {ran}")
        warnings = json.loads(ran.out)["warnings"]
        if not acceptable.startswith("load") or "mention" in acceptable:
            self.assertTrue(warnings, f"loads without a word: {ran}")

    def test_convert_leaves_no_file_behind(self):
        for name in ("truncated.glb", "truncated_binary.ply", "faces_only.obj"):
            out = self.folder / "out.glb"
            self.assertEqual(Ran(["convert", DATA / "malformed" / name, out]).code, 1)
            self.assertEqual(os.listdir(self.folder), [])


class Bombs(Case):
    """Small files whose numbers are large."""

    def refused(self, name, text):
        file = self.write(name, text)
        ran = Ran(["info", file], limit=20)
        self.assertEqual(ran.code, 1, ran)
        self.assertTrue(ran.err.startswith(f"meshwright: {file}: "), ran)
        if not SANITIZED:
            self.assertLess(ran.peak, 300e6, ran)

    def test_counts(self):
        header = "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
        for kind in ("ascii", "binary_little_endian", "binary_big_endian"):
            for count in (10**6, 4 * 10**9, 10**18, 10**30, -1):
                self.refused("bomb.ply", header.format(kind, count))
        for count in (10**6, 4 * 10**9, 10**18):
            accessor = {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}
            self.refused("bomb.gltf", json.dumps({
                "asset": {"version": "2.0"}, "accessors": [accessor], "bufferViews": [{"buffer": 0, "byteLength": 36}],
                "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + "A" * 48}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}))

    def test_pictures(self):
        self.refused("bomb.pgm", "P5\n16000 16000\n255\nxyz")
        self.refused("bomb.pgm", "P2\n16000 16000\n255\n1 2 3")
        self.refused("bomb.tga", "\0\0\13" + "\0" * 9 + "\x7f\x3e\x7f\x3e\x08\0" + "\x7f" * 100)

    def test_deep_json(self):
        self.refused("deep.gltf", '{"asset":{"version":"2.0"},"extras":' + "[" * 200000 + "]" * 200000 + "}")


class Damaged(Case):
    """Sound files of every format, cut off or with a few bytes changed: always an answer, never a crash."""

    def test_damage(self):
        chance = random.Random(7)
        for name in ("s.obj", "a.ply", "b.ply", "s.glb", "s.gltf"):
            sound = self.folder / name
            self.ok("process", "-", "--op", "icosphere:subdivisions=1", "-o", sound, *(["--ascii"] if name == "a.ply" else []))
            whole = sound.read_bytes()
            for i in range(24):
                damaged = bytearray(whole[:chance.randrange(len(whole))] if i % 3 == 0 else whole)
                for _ in range(0 if i % 3 == 0 else 1 + i % 5):
                    # Near the beginning, where the counts are, as often as anywhere.
                    at = chance.randrange(min(400, len(damaged)) if i % 2 else len(damaged))
                    damaged[at] = chance.choice((0, 255, 45, 57, chance.randrange(256)))
                sound.write_bytes(damaged)
                ran = Ran(["info", sound, "--json"], limit=20)
                with self.subTest(name, case=i):
                    self.assertIn(ran.code, (0, 1), ran)
                    self.assertLess(ran.seconds, 10, ran)
                    if ran.code == 1:
                        self.assertTrue(ran.err.startswith(f"meshwright: {sound}"), ran)


if __name__ == "__main__":
    main()
