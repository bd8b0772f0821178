// Simplification by removing vertices: the one that matters least goes with its faces, and the hole it leaves is closed by fewer triangles. Book
// 3.1.2; Schroeder, Zarge and Lorensen 1992.
//
// Takes any mesh; polygons are cut into triangles first. Inner vertices are measured against the average plane of their faces (3.3), (3.4), those of
// the border against the line between their neighbours there (3.5). A vertex is kept where it cannot go: on seams of corner values, creases, borders
// of materials and groups, on what is no surface; where its ring is no star in the average plane; where the triangles would repeat an edge, turn
// over or fold. Vertices that stay do not move and keep their values, corners and faces take those of the faces they replace. Euler characteristic
// and border loops stay. Time grows as n log n.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct DecimateVertices {
    enum class Metric { Relative, Distance };
    Metric metric = Metric::Relative;
    double threshold = 0.1;
    int64_t faces = 0;
    bool border = true;
    double turn = 78;

    template <class V>
    void describe(V& v)
    {
        v.choice("metric", metric, {"relative", "distance"},
                 {.title = "Metric",
                  .help = "relative: distance from the average plane, or from the line along the border, as a share of the longest edge there (3.4). "
                          "distance: as a share of the diagonal of the box."});
        v.number(
            "threshold", threshold,
            {.title = "Threshold", .help = "Vertices that cost more stay.", .min = 0, .max = 10, .softMin = 1e-5, .softMax = 1, .logarithmic = true});
        v.integer(
            "faces", faces,
            {.title = "Faces", .help = "Stop at this number of triangles; at 0 only the threshold stops.", .min = 0, .max = 1e9, .softMax = 1e6});
        v.flag("border", border, {.title = "Border too", .help = "Also remove vertices of the border; otherwise the outline stays as it is."});
        v.number("turn", turn,
                 {.title = "Normal turn",
                  .help = "No new triangle may lean more against the average plane.",
                  .unit = "\u00b0",
                  .min = 1,
                  .max = 90,
                  .advanced = true});
    }
};

Generator decimateVertices(Mesh input, DecimateVertices parameters, Stage<Mesh>& stage);

}  // namespace mw
