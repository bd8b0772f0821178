"""Exports a set of scenes with the program named on the command line and runs the Khronos glTF validator on all of them."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
SKIP = 77


def main() -> int:
    node = shutil.which("node") or shutil.which("nodejs")
    if not node:
        print("skipped: node is not installed")
        return SKIP
    if not (here / "node_modules" / "gltf-validator").is_dir():
        print("skipped: the validator is not installed; run `npm ci` in tests/interop")
        return SKIP
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        files = sorted(str(f) for f in pathlib.Path(folder).iterdir() if f.suffix in (".glb", ".gltf"))
        print(len(files), "files", flush=True)
        return 1 if not files else subprocess.run([node, str(here / "validate.mjs"), *files]).returncode


if __name__ == "__main__":
    sys.exit(main())
