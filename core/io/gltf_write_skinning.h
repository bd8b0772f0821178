// Joints and weights of vertices as glTF wants them.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Sets of four a vertex, one after the other. No joint twice at a vertex, joint 0 where the weight is 0, weights of a vertex summing to 1.
struct GltfSkinning {
    size_t sets = 0;  ///< 0: the mesh has no joints and weights
    std::vector<uint16_t> joints;
    std::vector<float> weights;
    size_t unbound = 0;  ///< vertices without any weight: given to the first joint
};

/// For a skin of so many joints; weights of others are left out.
GltfSkinning gltfSkinning(const Mesh& mesh, size_t joints);

}  // namespace mw
