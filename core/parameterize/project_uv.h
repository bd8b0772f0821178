// Texture coordinates by projection: the quick way to give some to a mesh that has none.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// Box: each face from the side of the bounding box it looks to, the six sides beside each other. X, Y, Z: all along that axis.
enum class UvProjection { Box, X, Y, Z };

/// "texcoord" of each corner, within 0 to 1, one scale for the whole mesh. A face seen from the front is never folded over. O(n).
Attribute projectedCoordinates(const Mesh& mesh, UvProjection from);

}  // namespace mw
