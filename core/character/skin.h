// Linear blend skinning and morphing on the CPU; the graphics card does the same from the same numbers (render/).
#pragma once
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/math/id.h"
#include "core/mesh/mesh.h"

namespace mw {

/// Binds the "joints" of a mesh to nodes: slot i is joints[i]. A skinned mesh stands in the world by its joints alone, its node's own
/// transform does not count (glTF 2.0).
struct Skin {
    std::string name;
    std::vector<NodeId> joints;
    std::vector<glm::dmat4> inverseBind;  ///< joint from mesh in the bind pose (7.7); as many as joints
    NodeId skeleton;                      ///< common root a file names; none: not said
};
uint64_t contentHash(const Skin& s);

/// What poses a mesh at one time.
struct MeshPose {
    std::vector<glm::mat4> joints;    ///< joint world matrix times inverse bind, by slot; empty: not skinned
    std::vector<float> morphWeights;  ///< in the order of the mesh's "morph:" attributes; missing ones are 0
};

/// Morphed, then skinned: v' = (sum w_j J_j) v (7.11); normals (vertex or corner attributes) by the inverse transpose of the blended matrix,
/// then unit; colours by their morphs. Attributes joints, weights and morph:* stay. Vertices without weights stay where the mesh has them.
Mesh posed(const Mesh& rest, const MeshPose& pose);
/// "color" plus the weights times "morph-color:NAME", 0 to 1; null when no target in use has one of the same kind.
std::optional<Attribute> posedColor(const Mesh& rest, const MeshPose& pose);
/// The positions of posed() alone: for picking and framing, which need no normals.
Shared<glm::vec3> posedPositions(const Mesh& rest, const MeshPose& pose);

}  // namespace mw
