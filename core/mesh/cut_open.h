// A mesh cut open along edges.
#pragma once
#include <span>

#include "core/mesh/mesh.h"

namespace mw {

/// `edges`: pairs of vertices; those that the mesh does not have, or that are its border, change nothing. At every vertex of a cut edge each fan of
/// faces between two cuts (or border edges) gets a vertex of its own, at the same place with the same attributes; the fan of the lowest corner
/// keeps the old one, new ones follow all others. Corners, faces and lines stay. A single edge inside a surface opens nothing: its two sides meet
/// round both ends. Any mesh; where more than two faces meet at a cut edge, all come apart. O(n log n).
Mesh cutOpen(const Mesh& mesh, std::span<const uint32_t> edges);

}  // namespace mw
