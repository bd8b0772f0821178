// Which triangle lies beyond each side: the neighbours of the face-based structure.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// For every side (named by the corner it starts at) of a mesh of triangles the side of another triangle that runs against it; none at the
/// boundary and in degenerate triangles. Where more than two triangles meet, sides that run opposite ways are paired in order. The neighbour
/// across side c of triangle c / 3 is triangle opposite[c] / 3. Linear time for any sensible mesh, never more than n log n.
Array<uint32_t> oppositeSidesOf(const Mesh& triangles);

}  // namespace mw
