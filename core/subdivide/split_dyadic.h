// Dyadic split: every edge in two, the surface as it was. Book 3.2, Fig. 3.13.
//
// A triangle gives four: 4f .. 4f+3 where all are triangles, the last one in the middle. Any other face gives a quad at each of its corners, around
// the mean of its vertices (which may lie outside of a face that is not convex). Faces of fewer than three corners are left out. Every attribute is
// linear along the edges and the mean in the centre; sharp edges stay sharp in both halves. Vertex v stays v, edge e gives V + e, faces come last.
// Any number of faces may share an edge. Linear in the result; at most 100 million faces, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct SplitDyadic {
    int64_t levels = 1;

    template <class V>
    void describe(V& v)
    {
        v.integer("levels", levels, {.title = "Levels", .help = "How often every edge becomes two.", .min = 1, .max = 8, .softMax = 4});
    }
};

Generator splitDyadic(Mesh input, SplitDyadic parameters, Stage<Mesh>& stage);

}  // namespace mw
