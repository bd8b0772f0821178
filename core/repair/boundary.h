// Boundary loops as something to fill: simple, walked with the hole on the left.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Edge i runs from vertex i to vertex i + 1 (cyclic); a face that runs along it the other way would fit.
struct BoundaryLoop {
    std::vector<uint32_t> vertices;  ///< each once, at least three
    std::vector<uint32_t> faces;     ///< the face on the other side of edge i
    std::vector<uint32_t> corners;   ///< the corner of faces[i] at vertex i
};

/// All of them, in the order of their lowest side. A walk that meets a vertex twice (holes that touch) is taken apart there. What is no closed
/// walk, next to edges of more than two faces, is left out. Where faces disagree about the direction, most of them decide.
std::vector<BoundaryLoop> boundaryLoopsOf(const Mesh& mesh);

}  // namespace mw
