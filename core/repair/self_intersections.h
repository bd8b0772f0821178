// Faces that pass through each other, or lie on each other.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/table.h"
#include "core/steps/progress.h"
#include "core/steps/stage.h"

namespace mw {

struct SelfIntersections {
    bool byPlace = true;
    template <class V>
    void describe(V& v)
    {
        v.flag("by-place", byPlace,
               {.title = "Join by place",
                .help = "Vertices at exactly the same place count as one, so that faces along a seam do not intersect each other."});
    }
};

using FacePair = std::pair<uint32_t, uint32_t>;  ///< the lower one first

/// All pairs of faces that have a point in common beyond their common corners and sides, ascending. Exact (core/math/predicates.h): touching
/// counts, so does lying on each other in one plane. Polygons are taken as their triangles; triangles without area are left out, as are
/// pairs within one face. No more than `most` pairs: which ones then is the same on every run. O(n log n + pairs), on all cores.
/// Throws Cancelled.
struct IntersectionOptions {
    bool byPlace = true;  ///< see SelfIntersections
    size_t most = 1000000;
};
std::vector<FacePair> selfIntersectionsOf(const Mesh& mesh, const IntersectionOptions& options = {}, Progress* progress = nullptr);

/// Query: how many others each face intersects.
Generator selfIntersections(Mesh input, SelfIntersections parameters, Stage<Table>& stage);

}  // namespace mw
