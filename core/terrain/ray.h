// Where a ray first meets the surface of bilinear cells over a grid of heights.
#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "core/terrain/height_map.h"

namespace mw {

/// Ray and result in grid space: x and z count samples, y is height times `scale`. Gives the parameter of the first point
/// origin + t * direction, t >= 0, on the surface, from either side.
std::optional<double> meetGrid(const HeightMap& map, double scale, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace mw
