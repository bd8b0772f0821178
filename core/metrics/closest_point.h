// Query: the point of a surface closest to a given one, by a walk through a tree of boxes; then distance, foot and inclusion. Book 3.4.1.
#pragma once
#include <glm/vec3.hpp>

#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct ClosestPointQuery {
    glm::dvec3 point{0.4, 1.2, 0.6};
    template <class V>
    void describe(V& v)
    {
        v.point("point", point, {.title = "Point", .help = "From which the closest point of the surface is sought.", .unit = "m"});
    }
};

/// A row a face: "distance" of those that were held against the point, NaN of those whose box was too far. The summary has the least distance,
/// "face", the closest point "x", "y", "z", and of the triangle it lies in: D (3.53), the foot Q, t1 t2 t3 (3.56), "inside" 1 or 0, and the
/// barycentric coordinates of the closest point; and how many boxes were opened and passed over, how many triangles tried. Throws Error without
/// faces.
Generator closestPointQuery(Mesh input, ClosestPointQuery parameters, Stage<Table>& stage);

}  // namespace mw
