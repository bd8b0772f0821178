// Query: how far each vertex of the border is off the line between its neighbours there. Book 3.1.1, (3.5).
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct BoundaryDistance {
    template <class V>
    void describe(V&)
    {}
};

/// A row a vertex: "d", the distance to the line through the two neighbours along the border, and "d / longest side" of the two border edges.
/// NaN inside, and where more than two border edges meet.
Generator boundaryDistance(Mesh input, BoundaryDistance parameters, Stage<Table>& stage);

}  // namespace mw
