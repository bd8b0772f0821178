// A filled hole made as dense and as smooth as what is round it (Liepa 2003, "Filling holes in meshes").
#pragma once
#include <functional>
#include <vector>

#include "core/repair/hole_triangulation.h"

namespace mw {

/// Points of the outline first, in its order; then new ones.
struct Patch {
    std::vector<glm::dvec3> points;
    std::vector<Triple> triangles;
    size_t outline = 0;  ///< how many points belong to the outline
};

/// Cuts triangles in three as long as they are larger than the spacing at their corners asks for, and turns edges so that angles stay wide.
/// `spacing`: mean length of the edges at each point of the outline. Stops beyond `most` new points. An edge between two points of the
/// outline is made only where `allowed`.
void refine(Patch& patch, const std::vector<double>& spacing, const std::function<bool(uint32_t, uint32_t)>& allowed, size_t most);

/// Moves the new points to where the squares of the umbrella vectors of all points are least, those of the outline included, so that the
/// surface goes on as it came. `beyond`: for each point of the outline its neighbours outside of the patch.
void fair(Patch& patch, const std::vector<std::vector<glm::dvec3>>& beyond);

}  // namespace mw
