// What the parts of the conversion from Assimp's structures share.
#pragma once
#include <assimp/matrix4x4.h>
#include <assimp/quaternion.h>
#include <assimp/types.h>
#include <assimp/vector3.h>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/io/findings.h"
#include "core/io/io.h"

struct aiMaterial;
struct aiNode;
struct aiScene;

namespace mw {

struct Conversion {
    Conversion(const aiScene& in_, std::filesystem::path file_, std::string ending_) : in(in_), file(std::move(file_)), ending(std::move(ending_)) {}

    const aiScene& in;
    const std::filesystem::path file;
    const std::string ending;  ///< lower case with dot
    Scene::Parts parts;
    Findings findings;
    std::vector<Warning> warnings;
    std::unordered_map<const aiNode*, NodeId> nodeOf;
    std::map<std::string, NodeId> byName;  ///< as the file says it; the first of that name
    std::set<NodeId> driven;               ///< by motions
    std::set<NodeId> bones;                ///< some mesh names them
    std::map<std::string, ImageId> imageOf;
    std::map<unsigned, MaterialId> materialOf;

    template <class Id, class T>
    Id keep(std::map<Id, T>& in_, T value)
    {
        const Id id{next++};
        in_.emplace(id, std::move(value));
        return id;
    }
    void warn(const char* code, std::string text) { warnings.push_back({code, std::move(text), {}}); }
    NodeId addNode(Node node, NodeId parent);  ///< last of the parent's children

    uint32_t next = 1;
};

/// As UTF-8 without control characters; older programs write names as Latin-1.
std::string text(const aiString& s);

inline glm::dvec3 vector(const aiVector3D& v)
{
    return {double(v.x), double(v.y), double(v.z)};
}
inline bool finite(const aiVector3D& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline glm::dmat4 matrix(const aiMatrix4x4& m)
{
    glm::dmat4 out;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) out[column][row] = double(m[unsigned(row)][unsigned(column)]);
    return out;
}

void addNodes(Conversion& c);
/// How the file's numbers were meant before they were made metres; nothing for formats that do not say.
std::optional<Placement> statedPlacement(const Conversion& c);
/// Names that several nodes have and that bones or motions go by; nodes without a name.
void makeNamesUnique(Conversion& c);
void addMeshes(Conversion& c);
MaterialId materialOf(Conversion& c, unsigned index);
void addClips(Conversion& c);
/// Which nodes are joints: after meshes and clips.
void markJoints(Conversion& c);

/// Counts and indices of an MD5 text; throws Error where Assimp would crash or read nonsense.
void checkMd5(std::string_view content, bool animation);

}  // namespace mw
