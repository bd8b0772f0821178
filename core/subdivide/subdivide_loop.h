// Loop subdivision of triangle meshes. Book 3.2; Loop 1987, "Smooth subdivision surfaces based on triangles"; borders and creases as Hoppe and others
// 1994; weights of Warren 1995 on request.
//
// Takes any mesh; polygons are cut into triangles first, faces of fewer than three corners are left out. Edges with one face, more than two, or two
// that run the same way are sharp, and so are those whose corner attribute `crease` is 1 or more: they become smooth curves of their own; below 1
// they are partly sharp on the first level. If creases fade, `crease` counts the levels for which an edge is sharp. A vertex with three or more sharp
// edges stays; one with a single sharp edge (the end of a crease) moves as if it had none. Vertex attributes, skins and morphs are mixed with the
// weights of the positions. Corner attributes (texture coordinates) are interpolated linearly within each face, so that seams stay where they are.
// Faces take the attributes of the face they are cut from. Vertex v stays vertex v; triangle f gives 4f .. 4f+3, the last one in the middle. Time and
// memory are linear in the result; at most 100 million triangles, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"
#include "core/subdivide/corner_surface.h"

namespace mw {

struct SubdivideLoop {
    enum class Weights { Loop, Warren };
    enum class Corners { Smooth, Sharp };

    int64_t levels = 1;
    Weights weights = Weights::Loop;
    Corners corners = Corners::Smooth;
    bool fading = false;
    Texturing uv = Texturing::Linear;

    template <class V>
    void describe(V& v)
    {
        v.integer("levels", levels, {.title = "Levels", .help = "How often every triangle becomes four.", .min = 1, .max = 6});
        v.choice(
            "weights", weights, {"loop", "warren"},
            {.title = "Weights", .help = "loop: (5/8 - (3/8 + cos(2 pi/n)/4)^2)/n for each of n neighbours (1987). warren: 3/(8n), 3/16 for n = 3."});
        v.choice("corners", corners, {"smooth", "sharp"},
                 {.title = "Border corners",
                  .help = "Whether a vertex of a single face stays (sharp) or is rounded like the rest of the border.",
                  .advanced = true});
        v.choice("uv", uv, {"linear", "smooth"},
                 {.title = "Texture coordinates",
                  .help = "linear: within every face as they were. smooth: subdivided as the places are, which bends the texture less; seams stay."});
        v.flag("fading", fading,
               {.title = "Creases fade",
                .help = "The crease of an edge is the number of levels it stays sharp for. Else 1 or more is sharp for ever.",
                .advanced = true});
    }
};

/// The weight of each of n neighbours of a vertex inside; the vertex keeps 1 - n times that.
double loopWeight(SubdivideLoop::Weights weights, size_t n);

Generator subdivideLoop(Mesh input, SubdivideLoop parameters, Stage<Mesh>& stage);

}  // namespace mw
