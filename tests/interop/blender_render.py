"""The same file from the same camera under the same light, drawn by Blender (Cycles) and by us: how much the pictures are alike (SSIM, own
code), with a floor for each. With --keep FOLDER the pictures stay there, ours and Blender's side by side."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))  # Blender does not
import in_blender

SKIP = 77
SIZE = (320, 240)

# name, file of the data set or of our generator, light, eye, target, vertical angle, seconds into the clip, least SSIM.
# Even light comes without shadows in both; the studio is our own environment, given to Blender as a picture.
SCENES = [
    ("box", "gltf/BoxTextured.glb", "even", (1.6, 1.2, 2.0), (0, 0, 0), 32, None, 0.96),
    ("cesium man", "characters/cesium_man.gltf", "even", (1.6, 1.2, 2.6), (0, 0.75, 0), 36, 0.5, 0.97),
    ("morph cube", "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf", "studio", (3, 2.5, 4.5), (0, 0, 0), 36, None, 0.95),
    ("robot", "characters/robot.glb", "studio", (4, 4, 9), (0, 2.4, 0), 36, None, 0.96),
    ("spider", "meshes/nonmanifold/spider.obj", "even", (120, 110, 190), (-15, -5, -10), 36, None, 0.94),
    ("spheres", "spheres.glb", "studio", (0, 0, 16), (0, 0, 0), 34, None, 0.91),
]


def up(v):
    """From y up to Blender's z up."""
    return (v[0], -v[2], v[1])


def gaussian_filtered(a):
    import numpy as np
    x = np.arange(-5, 6)
    w = np.exp(-x * x / (2 * 1.5**2))
    w /= w.sum()
    for axis in (0, 1):
        a = sum(k * np.roll(a, int(s), axis) for k, s in zip(w, x))
    return a[5:-5, 5:-5]


def ssim(a, b):
    """Wang, Bovik, Sheikh and Simoncelli 2004: Gaussian window of 11, sigma 1.5, values from 0 to 1."""
    c1, c2 = 0.01**2, 0.03**2
    ma, mb = gaussian_filtered(a), gaussian_filtered(b)
    va, vb = gaussian_filtered(a * a) - ma * ma, gaussian_filtered(b * b) - mb * mb
    cov = gaussian_filtered(a * b) - ma * mb
    return float((((2 * ma * mb + c1) * (2 * cov + c2)) / ((ma * ma + mb * mb + c1) * (va + vb + c2))).mean())


def inside():
    """Runs in Blender: JOB; draws each scene of it, compares, writes the numbers beside it."""
    import bpy
    import mathutils
    import numpy as np

    in_blender.mend_names()

    def world(light, folder):
        w = bpy.data.worlds.new("light")
        bpy.context.scene.world = w
        w.use_nodes = True
        background = w.node_tree.nodes["Background"]
        background.inputs["Color"].default_value = (1, 1, 1, 1)
        if light == "studio":
            picture = w.node_tree.nodes.new("ShaderNodeTexEnvironment")
            picture.image = bpy.data.images.load(str(pathlib.Path(folder, "studio.hdr")))
            w.node_tree.links.new(picture.outputs["Color"], background.inputs["Color"])

    def load(file, seconds):
        if file.endswith(".obj"):
            bpy.ops.import_scene.obj(filepath=file, use_split_objects=False)
        else:
            bpy.ops.import_scene.gltf(filepath=file)
        scene = bpy.context.scene
        scene.frame_set(0 if seconds is None else round(seconds * scene.render.fps))
        for o in scene.objects:
            if o.type != "MESH":
                continue
            # Light reaches everything, as with us, and what is rough loses nothing among its facets.
            o.visible_diffuse = o.visible_glossy = o.visible_shadow = o.visible_transmission = False
            if seconds is None and o.data.shape_keys:
                o.data.shape_keys.animation_data_clear()
                for k in o.data.shape_keys.key_blocks[1:]:
                    k.value = 0
        for m in bpy.data.materials:
            if m.use_nodes:
                for n in m.node_tree.nodes:
                    if n.type == "BSDF_PRINCIPLED":
                        n.distribution = "MULTI_GGX"
                        if file.endswith(".obj"):  # its importer guesses these from Ns; we take what our reader made of the file
                            n.inputs["Specular"].default_value = 0.5
        if seconds is None:
            for a in [o for o in scene.objects if o.type == "ARMATURE"]:
                a.animation_data_clear()
                for bone in a.pose.bones:
                    bone.matrix_basis = mathutils.Matrix()

    def camera(eye, target, angle):
        data = bpy.data.cameras.new("camera")
        data.sensor_fit = "VERTICAL"
        data.angle = np.radians(angle)
        distance = mathutils.Vector(up(target)) - mathutils.Vector(up(eye))
        data.clip_start, data.clip_end = distance.length * 0.01, distance.length * 10
        o = bpy.data.objects.new("camera", data)
        o.location = up(eye)
        o.rotation_mode = "QUATERNION"
        o.rotation_quaternion = distance.to_track_quat("-Z", "Y")
        bpy.context.scene.collection.objects.link(o)
        bpy.context.scene.camera = o

    def draw(file):
        scene = bpy.context.scene
        scene.render.engine = "CYCLES"
        scene.cycles.device = "CPU"
        scene.cycles.samples = 96
        scene.cycles.use_denoising = False
        scene.cycles.max_bounces = 0
        scene.render.film_transparent = True
        scene.render.resolution_x, scene.render.resolution_y = SIZE
        scene.render.resolution_percentage = 100
        scene.render.image_settings.file_format = "PNG"
        scene.render.image_settings.color_mode = "RGBA"
        scene.view_settings.view_transform = "Standard"
        scene.render.filepath = str(file)
        bpy.ops.render.render(write_still=True)

    def pixels(file):
        image = bpy.data.images.load(str(file))
        image.colorspace_settings.name = "Raw"  # as stored: what is seen
        a = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)
        return a[..., :3] * a[..., 3:] + 0.25 * (1 - a[..., 3:]), a[..., 3]

    def side_by_side(a, b, file):
        both = np.concatenate([a, b], axis=1)
        image = bpy.data.images.new("both", both.shape[1], both.shape[0])
        image.colorspace_settings.name = "Raw"
        image.pixels = np.concatenate([both, np.ones(both.shape[:2] + (1,))], axis=2).ravel()
        image.filepath_raw = str(file)
        image.file_format = "PNG"
        image.save()

    job = json.loads(pathlib.Path(in_blender.words()[0]).read_text())
    found = {}
    for s in job["scenes"]:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        world(s["light"], job["folder"])
        load(s["file"], s["seconds"])
        camera(s["eye"], s["target"], s["angle"])
        theirs = pathlib.Path(job["folder"], s["name"] + " blender.png")
        draw(theirs)
        (a, ca), (b, cb) = pixels(s["ours"]), pixels(theirs)
        side_by_side(a, b, pathlib.Path(job["folder"], s["name"] + " both.png"))
        luma = np.array([0.2126, 0.7152, 0.0722])
        found[s["name"]] = {
            "ssim": ssim(a @ luma, b @ luma),
            "difference": float(np.abs(a - b)[(ca > 0.5) & (cb > 0.5)].mean()),
            "outline": float(((ca > 0.5) & (cb > 0.5)).sum() / max(((ca > 0.5) | (cb > 0.5)).sum(), 1)),
        }
    pathlib.Path(job["folder"], "found.json").write_text(json.dumps(found))


def ours(meshwright, scene, file, folder):
    name, _, light, eye, target, angle, seconds, _ = scene
    out = pathlib.Path(folder, name + " ours.png")
    camera = "/".join([",".join(map(str, eye)), ",".join(map(str, target)), str(angle)])
    clip = [] if seconds is None else ["--clip", "#0", "--time", str(seconds)]
    subprocess.run([meshwright, "render", file, "-o", str(out), "--size", "%dx%d" % SIZE, "--light", light, "--transparent",
                    "--camera", camera, *clip], check=True, stderr=subprocess.DEVNULL)
    return {"name": name, "file": str(file), "light": light, "eye": eye, "target": target, "angle": angle, "seconds": seconds, "ours": str(out)}


def compare(meshwright, generator, data, folder):
    subprocess.run([generator, folder], check=True)
    scenes = []
    for scene in SCENES:
        file = pathlib.Path(folder, scene[1])
        if not file.exists():
            file = pathlib.Path(data, scene[1])
        if data and file.exists() or file.parent == pathlib.Path(folder):
            scenes.append(ours(meshwright, scene, str(file), folder))
    job = pathlib.Path(folder, "job.json")
    job.write_text(json.dumps({"folder": folder, "scenes": scenes}))
    found = in_blender.ran(__file__, [job], pathlib.Path(folder, "found.json"))
    failed = 0
    floors = {s[0]: s[7] for s in SCENES}
    for name, n in found.items():
        low = n["ssim"] < floors[name] or n["outline"] < 0.97
        failed += low
        print(f"{name:12} SSIM {n['ssim']:.4f} (at least {floors[name]}), mean difference {255 * n['difference']:.1f} of 255, "
              f"outlines agree {100 * n['outline']:.1f} %{'  TOO LOW' if low else ''}")
    return 1 if failed else 0


def main():
    if not in_blender.program():
        print("skipped: Blender is not installed")
        return SKIP
    data = os.environ.get("MESHWRIGHT_DATA", "")
    if "--keep" in sys.argv:
        folder = sys.argv[sys.argv.index("--keep") + 1]
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        return compare(sys.argv[1], sys.argv[2], data, folder)
    with tempfile.TemporaryDirectory() as folder:
        return compare(sys.argv[1], sys.argv[2], data, folder)


if __name__ == "__main__":
    if "--" in sys.argv:
        inside()
    else:
        sys.exit(main())
