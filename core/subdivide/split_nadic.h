// n-adic split: every edge in n parts, the surface as it was. Book 3.2: n = 4 gives what two dyadic splits give.
//
// A triangle gives n^2 triangles, a quad n^2 quads (bilinear inside). Faces of five corners and more are cut into triangles first; faces of fewer
// than three are left out. Attributes of vertices and corners are linear in a triangle, bilinear in a quad; sharp edges stay sharp in all their
// parts. Vertex v stays v; edge e gives n - 1 vertices from V + e (n - 1) on; then those inside. Any number of faces may share an edge. Linear in the
// result; at most 100 million faces, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct SplitNadic {
    int64_t n = 3, levels = 1;

    template <class V>
    void describe(V& v)
    {
        v.integer("n", n,
                  {.title = "Parts", .help = "Into how many parts every edge is cut; a face gives their square.", .min = 2, .max = 64, .softMax = 8});
        v.integer("levels", levels, {.title = "Levels", .help = "How often that is done.", .min = 1, .max = 6, .softMax = 3});
    }
};

Generator splitNadic(Mesh input, SplitNadic parameters, Stage<Mesh>& stage);

}  // namespace mw
