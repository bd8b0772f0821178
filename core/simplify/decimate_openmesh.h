// OpenMesh's own decimater (halfedge collapses in the order of its quadric module), as a reference for decimate-quadric. Positions are kept, a vertex
// goes into its neighbour; polygons are cut into triangles; attributes and loose lines are left out. The mesh has to be a manifold. Time grows as n
// log n.
#pragma once
#include "core/mesh/mesh.h"
#include "core/simplify/kept_triangles.h"
#include "core/steps/stage.h"

namespace mw {

struct DecimateOpenMesh {
    enum class Stop { Ratio, Faces };

    Stop stop = Stop::Ratio;
    double ratio = 0.5;
    int64_t faces = 1000;
    double turn = 90;

    template <class V>
    void describe(V& v)
    {
        v.choice("stop", stop, {"ratio", "faces"}, {.title = "Stop at", .help = "What ends the simplification."});
        describeKept(v, ratio, faces);
        v.number("turn", turn,
                 {.title = "Normal turn",
                  .help = "No face may turn by more in one collapse; 180: any may (its module for flipped normals is left out).",
                  .unit = "°",
                  .min = 1,
                  .max = 180,
                  .advanced = true});
    }
};

Generator decimateOpenMesh(Mesh input, DecimateOpenMesh parameters, Stage<Mesh>& stage);

}  // namespace mw
