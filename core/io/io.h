// Files in and out. Reading yields a usable scene and warnings, or throws Error naming file, place and remedy; memory stays a small
// multiple of the file's size whatever its header claims.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/scene/scene.h"
#include "core/steps/progress.h"

namespace mw {

class Evaluator;

enum class UpAxis { Y, Z, X };

/// How the numbers of a file are meant. Everything in a scene is metres, +Y up: what is read is turned and scaled at its roots.
struct Placement {
    double metresPerUnit = 1;
    UpAxis up = UpAxis::Y;
    bool operator==(const Placement&) const = default;
};

struct ImportOptions {
    std::optional<double> metresPerUnit = {};  ///< overrules the file; > 0
    std::optional<UpAxis> up = {};
};

struct Imported {
    Scene scene;
    std::vector<Warning> warnings;
    std::string format;              ///< "OBJ", "PLY (binary, little-endian)", ...
    std::string units;               ///< of the numbers in the file: "metres", "centimetres", ...; "unknown" when it does not say
    bool project = false;            ///< it carried MESHWRIGHT_project: opens as it was saved
    Placement placement = {};        ///< what was assumed, or asked for, or said by the file
    bool placementFromFile = false;  ///< the file said so
};

struct FileFormat {
    std::string name;                     ///< "Wavefront OBJ"
    std::vector<std::string> extensions;  ///< lower case, with dot
    bool reads = false, writes = false;
};
const std::vector<FileFormat>& fileFormats();

/// By content, then by ending; "sample:NAME" is a scene made by the program. Throws Error, Cancelled.
Imported readFile(const std::filesystem::path& file, Progress* progress = nullptr, const ImportOptions& options = {});
/// Roots of a scene that was read one way, as if it had been read the other way. A root that a clip moves gets a node above it.
void placeAgain(Scene& scene, const std::vector<NodeId>& roots, const Placement& from, const Placement& to);

struct WriteOptions {
    bool project = false;               ///< glTF only: add what is needed to go on editing
    bool binary = true;                 ///< PLY, STL, OFF
    bool bigEndian = false;             ///< PLY, binary
    Placement placement = {};           ///< the numbers in the file are meant so; glTF is always metres, +Y up
    Evaluator* evaluator = nullptr;     ///< one that may know results of the stacks already; null: they are computed
    size_t terrainTriangles = 200'000;  ///< most triangles of each terrain, which becomes a mesh in all formats but pictures
};
/// By ending. Writes the evaluated scene. All or nothing: to a temporary file, then renamed. Gives what the format could not hold.
std::vector<Warning> writeFile(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options = {}, Progress* progress = nullptr);

/// A scene of one node that shows one mesh.
Scene sceneOf(Mesh mesh, std::string name);
/// All visible nodes' evaluated meshes in world space as one mesh, materials merged into slots; for formats without a hierarchy. Numbers are
/// meant as `placement` says.
struct Flattened {
    Mesh mesh;
    std::vector<MaterialId> materials;
};
/// `evaluator` may know results of the stacks already; null: they are computed.
Flattened flattened(const Scene& scene, Progress* progress = nullptr, const Placement& placement = {}, Evaluator* evaluator = nullptr);
/// Nodes that show a terrain and no mesh show a mesh of it; for formats that know no terrains.
Scene withTerrainMeshes(const Scene& scene, size_t trianglesEach, Progress* progress = nullptr);

}  // namespace mw
