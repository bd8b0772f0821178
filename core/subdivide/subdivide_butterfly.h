// Butterfly subdivision: goes through the vertices of a triangle mesh. Book 3.2; Dyn, Levin and Gregory 1990, "A butterfly subdivision scheme for
// surface interpolation with tension control"; modified at extraordinary vertices as Zorin, Schroeder and Sweldens 1996.
//
// Takes any mesh; polygons are cut into triangles first, faces of fewer than three corners are left out. The point on an edge AB is
// 1/2 (A + B) + 2w (C + D) - w (E + F + G + H). Beyond a sharp edge (one face, more than two, two that run the same way, or `crease` of 1 and more) a
// missing wing is the reflection that keeps planes planar, and the sharp edge itself takes the four-point rule -1/16, 9/16, 9/16, -1/16 along its
// line. Vertex attributes are mixed with the weights of the positions; corner attributes linearly within each face, so that seams stay. Old vertices
// keep all they have. Vertex v stays v, edge e gives V + e, triangle f gives 4f .. 4f+3, the last one in the middle. Linear in the result; at most
// 100 million triangles, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct SubdivideButterfly {
    enum class Weights { Sixteenth, Eighth };

    int64_t levels = 1;
    Weights weights = Weights::Sixteenth;
    bool modified = true;

    template <class V>
    void describe(V& v)
    {
        v.integer("levels", levels, {.title = "Levels", .help = "How often every triangle becomes four.", .min = 1, .max = 6});
        v.choice(
            "weights", weights, {"sixteenth", "eighth"},
            {.title = "Weights",
             .help =
                 "Of the outer corners: 1/16 (with 1/8 for the sides) repeats cubics on a regular mesh; 1/8 (with 1/4) is tenser and less smooth."});
        v.flag("modified", modified,
               {.title = "Modified at extraordinary vertices",
                .help = "Edges at a vertex whose valence is not 6 take the weights of its ring, which is smooth there."});
    }
};

Generator subdivideButterfly(Mesh input, SubdivideButterfly parameters, Stage<Mesh>& stage);

}  // namespace mw
