// Any bytes, read as OBJ, PLY, OFF, STL, GLB, glTF, BVH and height maps: the readers give a scene or throw Error, and nothing else ever happens.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

#include "core/error.h"
#include "core/io/gltf.h"
#include "core/mesh/topology.h"
#include "core/scene/scene_pose.h"

namespace {

// One file a format and process, in memory where the system has such a folder.
const std::string& fileOf(size_t format)
{
    static const std::string base =
        (std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp") + std::string("/meshwright-fuzz-") + std::to_string(getpid());
    static const std::string files[] = {base + ".obj", base + ".ply", base + ".glb", base + ".gltf", base + ".bvh",
                                        base + ".png", base + ".tga", base + ".pgm", base + ".off",  base + ".stl"};
    static const bool cleaning = [] {
        return std::atexit([] {
                   for (const std::string& f : files) std::remove(f.c_str());
               }) == 0;
    }();
    (void)cleaning;
    return files[format];
}

/// What was read is written and read again: as much comes back.
void writeBack(const mw::Imported& in)
{
    if (in.scene.meshes().size() != 1) return;
    const mw::Mesh& mesh = in.scene.find(in.scene.meshes()[0])->base;
    // Fewer things fit into these two, but what they write they must read.
    const bool off = in.format.find("OFF") != in.format.npos, stl = in.format.starts_with("STL") && !mesh.triangulation().faces.empty();
    if (off || stl)
        for (const bool binary : {false, true}) {
            mw::writeFile(in.scene, fileOf(off ? 8 : 9), {.binary = binary});
            const mw::Imported back = mw::readFile(fileOf(off ? 8 : 9));
            const mw::Mesh& again = back.scene.find(back.scene.meshes()[0])->base;
            if (off ? again.vertexCount() != mesh.vertexCount() || again.cornerCount() != mesh.cornerCount()
                    : again.faceCount() != mesh.triangulation().faces.size())
                std::abort();
        }
    if (!in.format.starts_with("PLY")) return;
    mw::writeFile(in.scene, fileOf(1));
    const mw::Imported back = mw::readFile(fileOf(1));
    const mw::Mesh& again = back.scene.find(back.scene.meshes()[0])->base;
    if (again.vertexCount() != mesh.vertexCount() || again.cornerCount() != mesh.cornerCount() ||
        again.attributes().size() != mesh.attributes().size())
        std::abort();
}

/// What moves is played and written as glTF.
void play(const mw::Scene& scene)
{
    for (const mw::ClipId id : scene.clips()) {
        const mw::Clip& clip = *scene.find(id);
        const mw::ScenePose pose = poseAt(scene, clip, duration(clip) / 2);
        const auto worlds = worldMatrices(scene, pose);
        for (const mw::NodeId n : scene.nodes()) {
            const mw::MeshObject* object = scene.find(scene.node(n).mesh);
            if (!object) continue;
            if (const auto meshPose = mw::meshPose(scene, n, object->base, pose, worlds)) mw::posed(object->base, *meshPose);
        }
    }
    if (!scene.clips().empty() || !scene.skins().empty()) mw::glbOf(scene);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    if (size == 0) return -1;
    // The first byte chooses the format ('0' OBJ, '1' PLY, '2' GLB, '3' glTF, '4' BVH, '5' PNG, '6' TGA, '7' PGM, '8' OFF, '9' STL), so that one
    // corpus serves all.
    const std::string& name = fileOf(uint8_t(bytes[0] - '0') % 10);
    if (FILE* f = std::fopen(name.c_str(), "wb")) {
        std::fwrite(bytes + 1, 1, size - 1, f);
        std::fclose(f);
    }
    try {
        const mw::Imported in = mw::readFile(name);
        for (mw::MeshId id : in.scene.meshes()) {
            const mw::Mesh& mesh = in.scene.find(id)->base;
            mw::topologyOf(mesh);
            mesh.triangulation();
            mesh.vertexNormals();
        }
        writeBack(in);
        play(in.scene);
    } catch (const mw::Error&) {
    }
    return 0;
}
