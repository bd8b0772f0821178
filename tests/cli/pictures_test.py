"""render and gallery make pictures without a display."""
import os
import struct
import zlib

from harness import DATA, Case, main, needs_data

NO_DISPLAY = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}


def pixels(file):
    """Width, height and the number of distinct colours of an 8-bit PNG."""
    data = file.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    width, height, depth, colour = struct.unpack(">IIBB", data[16:26])
    assert depth == 8 and colour in (2, 6)
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    raw = zlib.decompress(packed)
    assert len(raw) == height * (1 + width * (3 if colour == 2 else 4))
    return width, height, len(set(raw))


class Pictures(Case):
    def picture(self, file, *options):
        out = self.folder / "p.png"
        self.ok("render", file, "-o", out, "--size", "320x200", *options, environment=NO_DISPLAY)
        width, height, colours = pixels(out)
        self.assertEqual((width, height), (320, 200))
        self.assertGreater(colours, 8, "an empty picture")
        return out.read_bytes()

    def test_styles(self):
        sphere = self.source("s.glb", "icosphere:subdivisions=2")
        seen = {style: self.picture(sphere, "--style", style) for style in ("shaded", "flat", "wire", "heat:vertex-valence")}
        self.assertEqual(len(set(seen.values())), len(seen), "two styles look the same")

    def test_two_results_side_by_side(self):
        sphere = self.source("s.glb", "icosphere:subdivisions=1")
        alone = self.picture(sphere, "--style", "flat")
        both = self.picture(sphere, "--style", "flat", "--compare", "as-is", "--compare", "subdivide-loop:levels=1")
        heat = self.picture(sphere, "--style", "heat:vertex-valence", "--compare", "as-is", "--compare", "subdivide-loop:levels=1")
        self.assertEqual(len({alone, both, heat}), 3)
        self.fails("render", sphere, "-o", self.folder / "x.png", "--compare", "as-is", code=2, says="twice")
        self.fails("render", sphere, "-o", self.folder / "x.png", "--compare", "as-is", "--compare", "stripify", code=2, says="stripify")

    def test_the_same_twice(self):
        sphere = self.source("s.glb", "icosphere:subdivisions=2")
        self.assertEqual(self.picture(sphere), self.picture(sphere))

    def test_refusals(self):
        sphere = self.source("s.glb", "icosphere:subdivisions=1")
        self.fails("render", sphere, code=2)
        self.fails("render", sphere, "-o", self.folder / "x.png", "--size", "0x0", code=2)
        self.fails("render", sphere, "-o", self.folder / "x.png", "--size", "99999999x99999999", code=2)
        self.fails("render", sphere, "-o", self.folder / "x.png", "--style", "heat:nothing")
        self.fails("render", self.folder / "none.glb", "-o", self.folder / "x.png", says="none.glb: ")

    @needs_data
    def test_a_scan(self):
        self.picture(DATA / "meshes/boundary/stanford-bunny.obj", "--view", "front")


if __name__ == "__main__":
    main()
