// Query: how far each vertex is off the average plane of its fan. Book 3.1.1, Listing 3.1.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct VertexPlanarity {
    template <class V>
    void describe(V&)
    {}
};

/// A row a vertex: "d / longest edge" (3.4), the same whatever the scale, and "d" (3.3). NaN on the border, where there is no closed fan, and
/// where there is no area. Faces may be polygons; non-manifold vertices take all faces that they have.
Generator vertexPlanarity(Mesh input, VertexPlanarity parameters, Stage<Table>& stage);

}  // namespace mw
