// Modifier: closes boundary loops with triangles.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct FillHoles {
    enum class Method { Flat, Fair };

    int64_t maxEdges = 0;
    bool keepLargest = false;
    Method method = Method::Flat;

    template <class V>
    void describe(V& v)
    {
        v.integer("max-edges", maxEdges,
                  {.title = "Up to edges", .help = "Holes of more edges stay open; 0: all are filled.", .min = 0, .max = 100000000, .softMax = 500});
        v.flag("keep-largest", keepLargest,
               {.title = "Keep the largest open", .help = "The hole of the longest outline stays: the rim of a scan or of a flat piece."});
        v.choice("method", method, {"flat", "fair"},
                 {.title = "Surface",
                  .help = "Flat: triangles between the points of the outline. Fair: new vertices as dense as those around, placed so that the "
                          "surface goes on smoothly."});
    }
};

/// Every loop up to 300 edges gets the triangulation of least bend, then least area (Liepa 2003), larger ones ears cut off in the order of
/// their angle, so that time stays near n log n. A hole gets an edge only where there is none yet; if that leaves no way, triangles to a new
/// vertex in the middle. Loops that touch are filled one by one. So a manifold stays one, and each loop filled adds 1 to the Euler
/// characteristic. New triangles run as the faces round them: orient first. They take the attributes of the face next to the hole's first edge
/// and at their corners those of the corners beside the hole; a new vertex in the middle is the mean of the outline, those of a fair surface are
/// mixed from up to 64 points of the outline by the inverse square of the distance. Nothing else changes.
Generator fillHoles(Mesh input, FillHoles parameters, Stage<Mesh>& stage);

}  // namespace mw
