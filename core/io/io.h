// Files in and out. Reading yields a usable scene and warnings, or throws Error naming file, place and remedy; memory stays a small
// multiple of the file's size whatever its header claims.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/scene/scene.h"
#include "core/steps/progress.h"

namespace mw {

class Evaluator;

struct Imported {
    Scene scene;
    std::vector<Warning> warnings;
    std::string format;    ///< "OBJ", "PLY (binary, little-endian)", ...
    std::string units;     ///< "metres", or "unknown" when the format does not say
    bool project = false;  ///< it carried MESHWRIGHT_project: opens as it was saved
};

struct FileFormat {
    std::string name;                     ///< "Wavefront OBJ"
    std::vector<std::string> extensions;  ///< lower case, with dot
    bool reads = false, writes = false;
};
const std::vector<FileFormat>& fileFormats();

/// By content, then by ending; "sample:NAME" is a scene made by the program. Throws Error, Cancelled.
Imported readFile(const std::filesystem::path& file, Progress* progress = nullptr);

struct WriteOptions {
    bool project = false;               ///< glTF only: add what is needed to go on editing
    bool binary = true;                 ///< PLY
    bool bigEndian = false;             ///< PLY, binary
    Evaluator* evaluator = nullptr;     ///< glTF: one that may know results of the stacks already; null: they are computed
    size_t terrainTriangles = 200'000;  ///< most triangles of each terrain, which becomes a mesh in all formats but pictures
};
/// By ending. Writes the evaluated scene. All or nothing: to a temporary file, then renamed. Gives what the format could not hold.
std::vector<Warning> writeFile(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options = {}, Progress* progress = nullptr);

/// A scene of one node that shows one mesh.
Scene sceneOf(Mesh mesh, std::string name);
/// All visible nodes' evaluated meshes in world space as one mesh, materials merged into slots; for formats without a hierarchy.
struct Flattened {
    Mesh mesh;
    std::vector<MaterialId> materials;
};
Flattened flattened(const Scene& scene, Progress* progress = nullptr);
/// Nodes that show a terrain and no mesh show a mesh of it; for formats that know no terrains.
Scene withTerrainMeshes(const Scene& scene, size_t trianglesEach, Progress* progress = nullptr);

}  // namespace mw
