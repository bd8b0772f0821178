#include "core/io/io.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <new>
#include <set>

#include "core/io/bvh.h"
#include "core/io/file.h"
#include "core/io/foreign.h"
#include "core/io/gltf.h"
#include "core/io/height_picture.h"
#include "core/io/obj.h"
#include "core/io/off.h"
#include "core/io/placement.h"
#include "core/io/ply.h"
#include "core/io/stl.h"
#include "core/mesh/reorder.h"
#include "core/scene/samples.h"

namespace mw {

namespace fs = std::filesystem;

namespace {

enum class Type { Unknown, Obj, Off, Ply, Stl, Gltf, Bvh, HeightPicture, Foreign };

std::string ending(const fs::path& file)
{
    std::string e = file.extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

Type byEnding(const fs::path& file)
{
    const std::string e = ending(file);
    if (e == ".obj") return Type::Obj;
    if (e == ".off") return Type::Off;
    if (e == ".ply") return Type::Ply;
    if (e == ".stl") return Type::Stl;
    if (e == ".gltf" || e == ".glb") return Type::Gltf;
    if (e == ".bvh") return Type::Bvh;
    if (e == ".png" || e == ".tga" || e == ".pgm") return Type::HeightPicture;
    if (isForeign(e)) return Type::Foreign;
    return Type::Unknown;
}

/// Only what cannot be mistaken.
Type byContent(std::string_view start, uint64_t size)
{
    if (start.starts_with("ply\n") || start.starts_with("ply\r")) return Type::Ply;
    if (start.starts_with("glTF")) return Type::Gltf;
    if (start.starts_with("HIERARCHY\n") || start.starts_with("HIERARCHY\r")) return Type::Bvh;
    if (isStl(start, size)) return Type::Stl;
    if (isOff(start)) return Type::Off;
    return Type::Unknown;
}

/// For files of an ending nobody knows: does a line look like an OBJ vertex?
bool looksLikeObj(std::string_view start)
{
    if (start.starts_with("v ")) return true;
    return start.find("\nv ") != std::string_view::npos && start.find('\0') == std::string_view::npos;
}

Type typeOf(const fs::path& file, std::string_view start)
{
    std::error_code e;
    const uint64_t size = fs::file_size(file, e);
    if (Type t = byContent(start, e ? start.size() : size); t != Type::Unknown) return t;
    if (Type t = byEnding(file); t != Type::Unknown) return t;
    if (looksLikeObj(start)) return Type::Obj;
    const size_t first = start.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && start[first] == '{' && start.find("\"asset\"") != std::string_view::npos) return Type::Gltf;
    return Type::Unknown;
}

std::string listOfFormats(bool FileFormat::*can)
{
    std::string list;
    for (const FileFormat& f : fileFormats())
        if (f.*can) {
            list += (list.empty() ? "" : ", ") + f.name + " (";
            for (size_t i = 0; i < f.extensions.size(); ++i) list += (i ? " " : "") + f.extensions[i];
            list += ")";
        }
    return list;
}

}  // namespace

const std::vector<FileFormat>& fileFormats()
{
    static const std::vector<FileFormat> formats{
        {"glTF 2.0", {".glb", ".gltf"}, true, true},
        {"Wavefront OBJ", {".obj"}, true, true},
        {"Stanford PLY", {".ply"}, true, true},
        {"Geomview OFF", {".off"}, true, true},
        {"STL", {".stl"}, true, true},
        {"Biovision BVH", {".bvh"}, true, true},
        {"Height map PNG", {".png"}, true, true},
        {"Height map TGA", {".tga"}, true, false},
        {"Height map PGM", {".pgm"}, true, false},
        {"Autodesk FBX", {".fbx"}, true, false},
        {"DirectX X", {".x"}, true, false},
        {"id Software MD5", {".md5mesh", ".md5anim"}, true, false},
        {"COLLADA", {".dae"}, true, false},
        {"3D Studio", {".3ds"}, true, false},
    };
    return formats;
}

namespace {

Imported read(const fs::path& file, Progress* progress)
{
    constexpr std::string_view sample = "sample:";
    if (const std::string name = file.string(); name.starts_with(sample))
        return {sampleScene(std::string_view(name).substr(sample.size())), {}, "made by the program", "metres", false, {}, true};
    try {
        switch (typeOf(file, readStart(file, size_t(1) << 16))) {
            case Type::Obj:
                return readObj(file, progress);
            case Type::Off:
                return readOff(file, progress);
            case Type::Ply:
                return readPly(file, progress);
            case Type::Stl:
                return readStl(file, progress);
            case Type::Gltf:
                return readGltf(file, progress);
            case Type::Bvh:
                return readBvh(file, progress);
            case Type::HeightPicture:
                return readHeightPicture(file, progress);
            case Type::Foreign:
                return readForeign(file, progress);
            case Type::Unknown:
                break;
        }
    } catch (const std::bad_alloc&) {
        throw Error(file.string(), "there is not enough memory to read it");
    }
    throw Error(file.string(), "its kind is not known; these can be read: " + listOfFormats(&FileFormat::reads));
}

}  // namespace

namespace {

/// Its motion replaces what a node's transform says.
bool isMoved(const Scene& scene, NodeId id)
{
    for (const ClipId clip : scene.clips())
        for (const auto& channel : scene.find(clip)->channels)
            if (channel->node == id && channel->path != Channel::Path::Weights) return true;
    return false;
}

/// The node that carries a root's placement: itself, or one above it.
NodeId carrierOf(Scene& scene, NodeId root)
{
    while (scene.node(root).parent) root = scene.node(root).parent;
    if (!isMoved(scene, root)) return root;
    Node above;
    above.name = scene.node(root).name + " placement";
    const NodeId id = scene.add(std::move(above));
    scene.reparent(root, id);
    return id;
}

/// As large as the scene's meshes, in metres.
double sizeOf(const Scene& scene)
{
    Bounds all;
    for (const NodeId id : scene.nodes()) {
        const MeshObject* object = scene.find(scene.node(id).mesh);
        if (!object || object->base.vertexCount() == 0) continue;
        const Bounds b = object->base.bounds();
        const glm::dmat4 world = scene.worldFromLocal(id);
        for (int i = 0; i < 8; ++i)
            all.add(glm::dvec3(world * glm::dvec4(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1)));
    }
    return all.empty ? 0 : all.diagonal();
}

/// Where the file does not say its unit and metres give an unlikely size.
void doubtUnit(Imported& in)
{
    const double size = sizeOf(in.scene);
    if (!(size > 100) && !(size > 0 && size < 0.001)) return;
    char text[32];
    const std::string number(text, std::to_chars(text, text + sizeof text, size, std::chars_format::general, 3).ptr);
    in.warnings.push_back({"unit-guess",
                           "the file does not say its unit; taken as metres it is " + number + " m across: " +
                               (size > 100 ? "very large, perhaps its numbers are millimetres?" : "very small, perhaps its unit is longer?") +
                               " Say the unit when you import it",
                           {}});
}

/// Indices are the file's own, so that the mesh stays as it came; but whoever works on it may want to know. Small meshes fit into caches anyway.
void noticeShuffledOrder(Imported& in)
{
    constexpr size_t large = 200'000;
    for (const MeshId id : in.scene.meshes()) {
        const MeshObject& object = *in.scene.find(id);
        if (object.base.faceCount() < large || scatterOf(object.base) <= mostScatterInOrder) continue;
        in.warnings.push_back({"shuffled-order",
                               "the vertices of \"" + object.name +
                                   "\" are numbered at random, which makes work on it slow; \"Put in order\" (reorder) numbers them as they lie on "
                                   "the surface",
                               {}});
    }
}

}  // namespace

void placeAgain(Scene& scene, const std::vector<NodeId>& roots, const Placement& from, const Placement& to)
{
    if (from == to) return;
    const glm::dmat4 change = sceneFromFile(to) * fileFromScene(from);
    std::set<NodeId> carriers;
    for (const NodeId id : std::vector<NodeId>(roots)) carriers.insert(carrierOf(scene, id));
    for (const NodeId id : carriers) {
        Node n = scene.node(id);
        n.local = transformOf(change * n.local.matrix());
        scene.set(id, std::move(n));
    }
}

Imported readFile(const fs::path& file, Progress* progress, const ImportOptions& options)
{
    if (options.metresPerUnit && !(*options.metresPerUnit >= 1e-12 && *options.metresPerUnit <= 1e12))
        throw Error(file.string(), "a unit must be between 1e-12 and 1e12 metres long");
    Imported in = read(file, progress);
    const Placement wanted{options.metresPerUnit.value_or(in.placement.metresPerUnit), options.up.value_or(in.placement.up)};
    placeAgain(in.scene, in.scene.roots(), in.placement, wanted);
    in.placementFromFile = in.placementFromFile && wanted == in.placement;
    in.placement = wanted;
    if (options.metresPerUnit) in.units = unitText(*options.metresPerUnit);
    if (!options.metresPerUnit && !in.placementFromFile) doubtUnit(in);
    if (!in.project) noticeShuffledOrder(in);
    return in;
}

namespace {

/// For formats whose numbers mean one thing only.
std::vector<Warning> withFixedPlacement(std::vector<Warning> warnings, const Placement& asked, const char* fixed)
{
    if (asked != Placement{}) warnings.push_back({"placement-fixed", std::string(fixed) + ": the unit and axis asked for are not used", {}});
    return warnings;
}

}  // namespace

std::vector<Warning> writeFile(const Scene& scene, const fs::path& file, const WriteOptions& options, Progress* progress)
{
    if (!(options.placement.metresPerUnit >= 1e-12 && options.placement.metresPerUnit <= 1e12))
        throw Error(file.string(), "a unit must be between 1e-12 and 1e12 metres long");
    switch (byEnding(file)) {
        case Type::Obj:
            return writeObj(withTerrainMeshes(scene, options.terrainTriangles, progress), file, options, progress);
        case Type::Ply:
            return writePly(withTerrainMeshes(scene, options.terrainTriangles, progress), file, options, progress);
        case Type::Gltf:
            return withFixedPlacement(writeGltf(scene, file, options, progress), options.placement, "glTF is always in metres with +Y up");
        case Type::Bvh:
            return withFixedPlacement(writeBvh(scene, file, progress), options.placement, "BVH is written in metres with +Y up");
        case Type::HeightPicture:
            if (ending(file) == ".png") return writeHeightPicture(scene, file, progress);
            break;
        case Type::Off:
            return writeOff(withTerrainMeshes(scene, options.terrainTriangles, progress), file, options, progress);
        case Type::Stl:
            return writeStl(withTerrainMeshes(scene, options.terrainTriangles, progress), file, options, progress);
        case Type::Foreign:
        case Type::Unknown:
            break;
    }
    throw Error(file.string(), "its ending says no kind that can be written; these can: " + listOfFormats(&FileFormat::writes));
}

Scene sceneOf(Mesh mesh, std::string name)
{
    Scene scene;
    Node node;
    node.name = name;
    node.mesh = scene.add(MeshObject{std::move(name), std::move(mesh), {}, {}});
    scene.add(std::move(node));
    return scene;
}

}  // namespace mw
