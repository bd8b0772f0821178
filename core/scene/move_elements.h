// Moving vertices of a base mesh; faces stay as they are and are shared.
#pragma once
#include "core/scene/scene.h"

namespace mw {

/// The vertices of a set of elements, ascending, each once. Elements the mesh does not have are left out.
std::vector<uint32_t> verticesOf(const Mesh& mesh, const ElementSet& elements);
/// Each vertex goes to matrix * place, in the mesh's own space. Normals and tangents of a file no longer fit and are dropped. Throws Error
/// when the node has no mesh or a place is beyond what a float holds.
void moveVertices(Scene& scene, NodeId node, std::span<const uint32_t> vertices, const glm::dmat4& matrix);

}  // namespace mw
