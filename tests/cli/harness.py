"""Runs the program and says what it did. MESHWRIGHT names the binary, MESHWRIGHT_DATA the outside data (may be absent)."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.environ.get("MESHWRIGHT", str(pathlib.Path(__file__).resolve().parents[2] / "build/bin/meshwright"))
SANITIZED = os.environ.get("MESHWRIGHT_SANITIZED") == "1"
_data = os.environ.get("MESHWRIGHT_DATA", "")
DATA = pathlib.Path(_data) if _data and pathlib.Path(_data).is_dir() else None

needs_data = unittest.skipUnless(DATA, "MESHWRIGHT_DATA is not set")


class Ran:
    """What one run did: code (negative: the signal that ended it), out, err, seconds, peak (bytes of memory)."""

    def __init__(self, arguments, environment=None, limit=60, stdin=subprocess.DEVNULL):
        self.arguments = [str(a) for a in arguments]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            start = time.monotonic()
            process = subprocess.Popen([PROGRAM, *self.arguments], stdin=stdin, stdout=out, stderr=err, env=environment)
            status, usage = self._wait(process, start + limit)
            self.seconds = time.monotonic() - start
            self.code = os.waitstatus_to_exitcode(status)
            self.peak = usage.ru_maxrss * 1024
            out.seek(0), err.seek(0)
            self.out, self.err = out.read().decode("utf-8", "replace"), err.read().decode("utf-8", "replace")

    @staticmethod
    def _wait(process, deadline):
        # wait4, because it gives the peak memory of just this child.
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = 0
                return status, usage
            if time.monotonic() > deadline:
                process.kill()
                deadline += 60
            time.sleep(0.002)

    def __str__(self):
        return f"{' '.join(self.arguments)} -> {self.code} in {self.seconds:.1f} s\n{self.out[-2000:]}\n{self.err[-2000:]}"


class Case(unittest.TestCase):
    """A temporary folder and short ways to say what is expected."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def ok(self, *arguments, **options):
        ran = Ran(arguments, **options)
        self.assertEqual(ran.code, 0, ran)
        return ran

    def fails(self, *arguments, code=1, says=""):
        ran = Ran(arguments)
        self.assertEqual(ran.code, code, ran)
        self.assertRegex(ran.err, r"^meshwright: ", ran)
        self.assertIn(says, ran.err, ran)
        self.assertEqual(ran.out, "", ran)
        return ran

    def json(self, *arguments, **options):
        ran = self.ok(*arguments, **options)
        self.assertEqual(ran.out.count("\n"), 1, "one object on one line")
        return json.loads(ran.out)

    def mesh(self, file):
        """The only mesh of a file, as info has it."""
        meshes = self.json("info", file, "--json")["meshes"]
        self.assertEqual(len(meshes), 1)
        return meshes[0]

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text)
        return file

    def source(self, name, *operations):
        """A file made by sources and operations of the catalog."""
        file = self.folder / name
        self.ok("process", "-", *[word for op in operations for word in ("--op", op)], "-o", file)
        return file


def rows(heading):
    """The rows of the table under a heading of the data's README, as dictionaries."""
    text = (DATA / "README.md").read_text(encoding="utf-8")
    part = re.split(r"^## ", text.split(f"## {heading}\n")[1], flags=re.M)[0]
    lines = [[cell.strip() for cell in line.strip()[1:-1].split("|")] if line.startswith("|") else None for line in part.splitlines()]
    lines = [line for line in lines if line]
    return [dict(zip(lines[0], line)) for line in lines[1:] if not set(line[0]) <= set("-|: ")]


def main():
    """As unittest.main, but status 77 when every test skipped."""
    program = unittest.main(exit=False, verbosity=1)
    result = program.result
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(77 if result.testsRun == len(result.skipped) else 0)
