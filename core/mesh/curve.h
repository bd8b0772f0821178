// A polyline in space: what curve schemes refine, and labs draw. In the plane when z is 0.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/mesh/array.h"

namespace mw {

/// Segment i goes from point i to i+1; closed ones have one more, back to the first. `control` is the polygon it began as (drawn beneath).
struct Curve {
    Array<glm::dvec3> points;
    Array<glm::dvec3> control;
    bool closed = false;
};
size_t byteSize(const Curve& c);
uint64_t contentHash(const Curve& c);

}  // namespace mw
