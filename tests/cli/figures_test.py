"""The book's figures: every picture shows something, no text is cut off or lies over another, and the numbers in them are those that must be.

What must hold of each figure's numbers stands in figure_numbers_*.py beside this file, one for a part of the book: CHECKS maps an id to a
function of the test case and the figure's numbers.
"""
import importlib
import json
import pathlib
import tempfile
import unittest

from harness import Ran, main
from pictures_test import NO_DISPLAY, pixels

CHECKS = {}
for file in sorted(pathlib.Path(__file__).parent.glob("figure_numbers_*.py")):
    CHECKS.update(importlib.import_module(file.stem).CHECKS)


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        # Figures begin with a chapter; the pictures of the operations are checked in pictures_test.py.
        cls.figures = []
        for chapter in "2345678":
            ran = Ran(["gallery", cls.folder, "--only", chapter + ".", "--scale", "0.75"], environment=NO_DISPLAY, limit=500)
            if ran.code == 1 and "there is no picture" in ran.err:
                continue
            assert ran.code == 0, ran
            cls.figures += json.loads((cls.folder / "gallery.json").read_text())["figures"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_list(self):
        ids = [f["id"] for f in self.figures]
        self.assertEqual(ids, sorted(set(ids)), "each once, in the order of the book")
        for f in self.figures:
            self.assertTrue(f["proves"], f["id"])
            self.assertTrue(f["title"], f["id"])
        self.assertEqual(set(ids) ^ set(CHECKS), set(), "every figure has its numbers checked, and no check is left without its figure")

    def test_pictures(self):
        for f in self.figures:
            with self.subTest(f["id"]):
                width, height, colours = pixels(self.folder / f["file"])
                self.assertEqual([width, height], f["size"])
                self.assertGreater(width, 200)
                self.assertGreater(height, 100)
                self.assertGreater(colours, 30, "something is drawn")

    def test_text(self):
        for f in self.figures:
            with self.subTest(f["id"]):
                self.assertEqual(f["text"]["outside"], [], "text that is cut off")
                self.assertEqual(f["text"]["covered"], [], "text over text")

    def test_numbers(self):
        for f in self.figures:
            with self.subTest(f["id"]):
                CHECKS[f["id"]](self, f["numbers"])


if __name__ == "__main__":
    main()
