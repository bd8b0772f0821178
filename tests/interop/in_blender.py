"""Starts Blender on a script of ours: blender_test.py, meshes_blender_test.py and blender_render.py share it."""
import json
import os
import pathlib
import shutil
import subprocess
import sys


def program():
    """Where Blender is; None when it is not installed."""
    return shutil.which("blender")


def words():
    """Inside Blender: what `ran` was given."""
    return sys.argv[sys.argv.index("--") + 1:]


def ran(script, arguments, result):
    """Runs the script inside Blender, which is to write the file `result`, and returns that as JSON. Ends the test when there is none."""
    blender = program()
    command = [blender, "-b", "--factory-startup", "--python-exit-code", "3", "--python", script, "--", *map(str, arguments)]
    # It takes the libraries of the first Python on the path: that has to be the one beside it.
    path = f"{pathlib.Path(blender).resolve().parent}{os.pathsep}{os.environ.get('PATH', '')}"
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", env={**os.environ, "PATH": path})
    if not result.exists():
        sys.exit(f"Blender ended with {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return json.loads(result.read_text())


def mend_names():
    """Inside Blender 3.4 of Debian 12 with its newer numpy: names that its add-ons use and that are gone."""
    import builtins

    import numpy
    for name in ("bool", "object", "int", "float"):
        if name not in numpy.__dict__:
            setattr(numpy, name, getattr(builtins, name))
