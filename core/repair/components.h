// Pieces of a mesh that hang together by common vertices.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Faces of each component whose box diagonal is below `share` of that of all faces, smallest first. The largest component is never tiny.
std::vector<std::vector<uint32_t>> tinyComponents(const Mesh& mesh, double share);

}  // namespace mw
