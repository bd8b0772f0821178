"""terrain: heights from a generator or a picture, out as picture, mesh or project."""
import struct
import zlib

from harness import DATA, Case, main, needs_data


def png16(file):
    """Width, height and samples of a 16-bit grey PNG, by the format's definition."""
    data = file.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, head = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    width, height, bits, colour, _, _, interlace = head
    assert (bits, colour, interlace) == (16, 0, 0)
    raw, stride, rows, before = zlib.decompress(packed), 2 * width, [], bytes(2 * width)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up, corner = (row[x - 2] if x > 1 else 0), before[x], (before[x - 2] if x > 1 else 0)
            nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
            row[x] = (row[x] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        rows.append(struct.unpack(f">{width}H", row))
        before = row
    return width, height, rows


class Terrain(Case):
    def test_every_source_to_every_format(self):
        sources = [a["id"] for a in self.json("algorithms", "--json")["algorithms"] if a.get("yields") == "height-map"]
        self.assertIn("perlin", sources)
        for source in sources:
            with self.subTest(source):
                out = self.folder / "m.png"
                ran = self.ok("terrain", "--source", f"{source}:size=65", "-o", out)
                self.assertIn("65 x 65 samples", ran.out)
                width, height, rows = png16(out)
                self.assertEqual((width, height), (65, 65))
                self.assertGreater(max(map(max, rows)) - min(map(min, rows)), 20000)
                for name in ("m.glb", "m.obj", "m.ply"):
                    self.ok("terrain", "--source", f"{source}:size=65", "--extent", "640", "--max-height", "50", "--triangles", "2000", "-o",
                            self.folder / name)
                    mesh = self.mesh(self.folder / name)
                    self.assertLessEqual(mesh["faces"], 2000)
                    self.assertGreater(mesh["faces"], 1800)
                    self.assertEqual((mesh["euler"], mesh["boundary_loops"], mesh["components"]), (1, 1, 1))
                    low, high = mesh["bounds"]["min"], mesh["bounds"]["max"]
                    self.assertEqual((low[0], high[0], low[2], high[2]), (-320, 320, -320, 320))
                    self.assertGreaterEqual(low[1], 0)
                    self.assertLessEqual(high[1], 50.001)

    def test_the_seed_decides(self):
        files = []
        for seed in (3, 3, 4):
            files.append(self.folder / f"{len(files)}.png")
            self.ok("terrain", "--source", f"diamond-square:size=65,seed={seed}", "-o", files[-1])
        self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
        self.assertNotEqual(files[0].read_bytes(), files[2].read_bytes())

    def test_water_is_level(self):
        out = self.folder / "m.ply"
        self.ok("terrain", "--source", "perlin:size=129", "--max-height", "100", "--water", "55", "-o", out)
        self.assertEqual(self.mesh(out)["bounds"]["min"][1], 55)

    def test_a_picture_survives_a_project(self):
        first, project, last = (self.folder / n for n in ("first.png", "p.glb", "last.png"))
        self.ok("terrain", "--source", "diamond-square:size=100", "-o", first)
        self.ok("terrain", "--from", first, "--project", "-o", project)
        self.ok("convert", project, last)
        self.assertEqual(png16(first), png16(last))

    def test_wrong_usage(self):
        out = self.folder / "m.png"
        self.fails("terrain", code=2, says="-o OUT is missing")
        self.fails("terrain", "-o", out, "--extent", "wide", code=2, says="--extent wants metres")
        self.fails("terrain", "-o", out, "--source", "perlin", "--from", "x.png", code=2, says="give one")
        self.fails("terrain", "-o", out, "--project", code=2, says="--project wants a .glb")
        self.fails("terrain", "-o", self.folder / "m.txt", says="a terrain is written as .png")
        self.fails("terrain", "-o", out, "--source", "icosphere", says="perlin")
        self.fails("terrain", "-o", out, "--source", "perlin:octaves=99", says="octaves")
        self.fails("terrain", "-o", out, "--from", self.folder / "none.png", says="none.png")
        self.assertEqual(list(self.folder.iterdir()), [])


@needs_data
class Pictures(Case):
    def test_convert(self):
        for name in ("MtCook.tga", "HeightMap1.tga", "heightmap.png"):
            with self.subTest(name):
                self.ok("convert", DATA / "terrain" / name, self.folder / "m.png")
                self.ok("convert", DATA / "terrain" / name, self.folder / "m.glb")
                mesh = self.mesh(self.folder / "m.glb")
                self.assertEqual((mesh["euler"], mesh["boundary_loops"]), (1, 1))
                self.assertEqual(mesh["bounds"]["max"][0], 500)

    def test_rows_of_a_plain_picture(self):
        # 18 bytes of header, then blue, green, red from the bottom row up.
        data = (DATA / "terrain" / "MtCook.tga").read_bytes()
        self.ok("terrain", "--from", DATA / "terrain" / "MtCook.tga", "-o", self.folder / "m.png")
        width, height, rows = png16(self.folder / "m.png")
        self.assertEqual((width, height), (1024, 1024))
        for y in (0, 1, 500, 1023):
            row = data[18 + (1023 - y) * 3072:18 + (1024 - y) * 3072]
            self.assertEqual(list(rows[y]), [257 * row[3 * x] for x in range(1024)])


if __name__ == "__main__":
    main()
