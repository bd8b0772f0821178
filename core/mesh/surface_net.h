// The zero set of a field as quads: a surface net (Gibson 1998) has one vertex in each cell the surface passes, one quad around each grid
// edge it crosses.
#pragma once
#include <functional>
#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

namespace mw {

/// Negative inside; changes by no more than one moves (a distance, or less).
using DistanceField = std::function<double(const glm::dvec3&)>;

/// Coordinates of the grid's lines, ascending; the surface must lie inside.
struct NetLines {
    std::vector<double> x, y, z;
};

/// A field that is symmetric in x, on a grid that is symmetric, too: left and right of the mesh are the same to the last bit. Quads are evened
/// out along the surface. Outside anticlockwise.
Mesh mirroredSurfaceNet(NetLines lines, DistanceField field);

}  // namespace mw
