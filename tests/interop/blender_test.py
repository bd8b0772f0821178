"""Exports a set of scenes with the program named on the command line and opens them in Blender. What was made from a file of the data set
must have the same counts there as the file itself: vertex groups, shape keys, bones, actions and what they drive, images, materials."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))  # Blender does not
import in_blender

SKIP = 77


def inside():
    """Runs in Blender: FILE... RESULT; writes the counts of each file, or the error, as JSON."""
    import builtins

    import bpy

    in_blender.mend_names()
    plain = builtins.open  # a mode that the add-ons use is gone from Python, too
    builtins.open = lambda file, mode="r", *a, **k: plain(file, mode.replace("U", "") if isinstance(mode, str) else mode, *a, **k)

    def counts():
        meshes = [o for o in bpy.data.objects if o.type == "MESH"]
        used = {m.name for o in meshes for m in o.data.materials if m}
        return {
            "meshes": len(meshes),
            "vertex groups": sorted(len(o.vertex_groups) for o in meshes),
            "shape keys": sorted(len(o.data.shape_keys.key_blocks) if o.data.shape_keys else 0 for o in meshes),
            "bones": sorted(len(a.bones) for a in bpy.data.armatures),
            "actions": len(bpy.data.actions),
            "curves": sorted(len(a.fcurves) for a in bpy.data.actions),
            "keys": sorted(sum(len(c.keyframe_points) for c in a.fcurves) for a in bpy.data.actions),
            "materials": len(used),
            "images": len([i for i in bpy.data.images if i.size[0]]),
            "faces": sorted(sum(p.area > 0 for p in o.data.polygons) for o in meshes),  # without area they may go when vertices are joined
        }

    *files, result = in_blender.words()
    found = {}
    for file in files:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        try:
            if file.endswith(".bvh"):
                bpy.ops.import_anim.bvh(filepath=file)
            else:
                bpy.ops.import_scene.gltf(filepath=file)
            found[file] = counts()
        except Exception as e:  # the test tells which file
            found[file] = str(e)
    with plain(result, "w") as out:
        json.dump(found, out)


def differences(source, original, export, simplified):
    """What Blender sees in an export otherwise than in the file it was made from."""
    ignored = {"faces"} if simplified else set()
    if source.suffix == ".bvh":  # the two importers differ in what they make of channels
        ignored = set(original) - {"bones", "actions"}
    return {k: (original[k], export[k]) for k in original if k not in ignored and original[k] != export[k]}


def main():
    if not in_blender.program():
        print("skipped: Blender is not installed")
        return SKIP
    data = os.environ.get("MESHWRIGHT_DATA", "")
    sources = sorted(f for sub in ("gltf", "characters", "bvh") for f in pathlib.Path(data, sub).rglob("*") if f.suffix in (".glb", ".gltf", ".bvh")) if data else []
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([sys.argv[1], name], check=True)
        exports = sorted(f for f in folder.iterdir() if f.suffix in (".glb", ".gltf") and not f.name.startswith("meshes_"))
        counted = folder / "counts.json"
        seen = in_blender.ran(__file__, [*exports, *sources, counted], counted)
        for file, counts in seen.items():
            if isinstance(counts, str):
                failed += 1
                print(f"{file}: Blender could not open it: {counts[-600:]}")
        for source in sources:
            for suffix in (".glb", "_simplified.glb"):
                export = folder / (str(source.relative_to(data)).replace("/", "_") + suffix)
                original, ours = seen[str(source)], seen.get(str(export))
                if not ours or isinstance(ours, str) or isinstance(original, str):
                    continue
                if wrong := differences(source, original, ours, suffix != ".glb"):
                    failed += 1
                    print(f"{export.name}: the file has, the export has: {wrong}")
        print(len(exports), "exports opened,", len(sources), "compared with their sources,", failed, "failed")
    return 1 if failed else 0


if __name__ == "__main__":
    if "--" in sys.argv:
        inside()
    else:
        sys.exit(main())
