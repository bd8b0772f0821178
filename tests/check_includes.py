#!/usr/bin/env python3
"""Checks the direction of includes: a folder may include itself and what stands above it, never what stands below.

core knows neither Qt nor OpenGL, render no Qt, the verbs no Qt. Project headers are named from the root of the repository.
"""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent

# From the top of the house down: each may include those before it, and its own.
LAYERS = [
    ["core/error.h"],
    ["core/math"],
    ["core/steps"],
    ["core/mesh"],
    ["core/metrics", "core/parameterize", "core/simplify", "core/subdivide", "core/repair", "core/morph"],
    ["core/surfaces", "core/terrain", "core/character"],
    ["core/catalog"],
    ["core/scene"],
    ["core/io"],
    ["render"],
    ["ui"],
    ["app"],
]
QT = re.compile(r"^(Q[A-Z]\w*|Qt\w*/.*|qcustomplot\.h)$")
GL = re.compile(r"^(epoxy|GL|EGL|GLES\d?)/")


def layer(path):
    """The number of the folder's layer, or None for what lies outside the house."""
    best = None
    for number, folders in enumerate(LAYERS):
        for folder in folders:
            if path == folder or path.startswith(folder + "/"):
                best = number
    return best


def problems(path):
    name = path.relative_to(root).as_posix()
    here = layer(name)
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        quoted, target = match.group(1) == '"', match.group(2)
        where = f"{name}:{number}: "
        is_project = target.split("/")[0] in ("core", "render", "ui", "app", "tests")
        if quoted and not is_project and not target.endswith(".moc") and not target.startswith("moc_"):
            yield where + f'"{target}": name it from the root of the repository'
        if is_project and target.split("/")[0] != "tests":
            there = layer(target)
            if there is None:
                yield where + f"{target} lies in no known folder"
            elif there > here:
                yield where + f"{name.rsplit('/', 1)[0]} must not include {target}, which stands below it"
        qt_free = name.startswith(("core/", "render/", "app/cli/", "app/figures/", "app/importer/")) or name == "app/main.cpp"
        if qt_free and QT.match(target):
            yield where + f"no Qt here ({target})"
        if name.startswith("core/") and GL.match(target):
            yield where + f"no OpenGL here ({target})"


def main():
    files = [f for folder in ("core", "render", "ui", "app") for f in sorted((root / folder).rglob("*")) if f.suffix in (".h", ".cpp")]
    found = [p for f in files for p in problems(f)]
    for p in found:
        print(p)
    print(f"{len(files)} files, {len(found)} wrong includes")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
