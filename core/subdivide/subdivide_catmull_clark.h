// Catmull-Clark subdivision of any polygons. Book 3.2; Catmull and Clark 1978, "Recursively generated B-spline surfaces on arbitrary topological
// meshes"; creases that fade as DeRose and others 1998, "Subdivision surfaces in character animation".
//
// Takes any mesh; faces of fewer than three corners are left out. Every corner of a face gives a quad. Edges with one face, more than two, or two
// that run the same way are sharp, and so are those whose corner attribute `crease` is 1 or more: they become smooth curves of their own; below 1
// they are partly sharp on the first level. If creases fade, `crease` counts the levels for which an edge is sharp. A vertex with three or more sharp
// edges stays; one with a single sharp edge moves as if it had none. Vertex attributes, skins and morphs are mixed with the weights of the positions;
// corner attributes linearly within each face, so that seams stay where they are. Vertex v stays vertex v, corner c gives face c, and that takes the
// attributes of the face of c. Time and memory are linear in the result; at most 100 million faces, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"
#include "core/subdivide/corner_surface.h"

namespace mw {

struct SubdivideCatmullClark {
    enum class Corners { Smooth, Sharp };

    int64_t levels = 1;
    Corners corners = Corners::Smooth;
    bool fading = false;
    Texturing uv = Texturing::Linear;

    template <class V>
    void describe(V& v)
    {
        v.integer("levels", levels, {.title = "Levels", .help = "How often every corner of a face becomes a quad.", .min = 1, .max = 6});
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

Generator subdivideCatmullClark(Mesh input, SubdivideCatmullClark parameters, Stage<Mesh>& stage);

}  // namespace mw
