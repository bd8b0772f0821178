// Several meshes as one: geometry one after the other, attributes kept, materials merged into slots.
#pragma once
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace mw {

struct MeshPart {
    std::string name;                   ///< of the group that it becomes
    std::vector<MaterialId> materials;  ///< its slots
    glm::dmat4 place{1};                ///< into the common space
    Mesh mesh;
};
struct JoinedMeshes {
    Mesh mesh;
    std::vector<MaterialId> materials;  ///< each once
};
/// `groupByPart`: each part is a group of faces (NAME, or NAME/GROUP where it had groups); else only when some part had groups. One part alone
/// keeps its groups and slots. Throws Error when one mesh cannot hold so much.
JoinedMeshes joinedMeshes(std::vector<MeshPart> parts, bool groupByPart);

}  // namespace mw
