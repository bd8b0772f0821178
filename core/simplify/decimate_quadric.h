// Simplification by edge collapse with the quadric error metric. Book 3.1; Garland and Heckbert 1997. Where this departs from the paper:
// planes are weighed with the area of their faces; the quadric of a new vertex is, unless `memory` says sum, made anew from the faces it has then
// (as Lindstrom and Turk 1998 keep no memory either), which follows the surface more closely; a small pull to the old places makes flat regions
// well-conditioned; collapses that would change the topology, turn faces over or fold the surface are refused.
//
// Takes any mesh; polygons are cut into triangles first, faces of fewer than three corners are left out. What is no surface (an edge of three faces,
// several fans at a vertex, a vertex twice in a face, ends of loose lines) stays as it is. Manifolds stay manifold, genus and border loops stay.
// Edges where corner values, materials or groups part, and creases, are kept as curves: only collapsed along themselves.
// Attributes of vertices and corners are read off the old surface; faces keep theirs. Time grows as n log n; memory about 350 bytes a triangle.
#pragma once
#include "core/mesh/mesh.h"
#include "core/simplify/kept_triangles.h"
#include "core/steps/stage.h"

namespace mw {

struct DecimateQuadric {
    enum class Quality { Textbook, Fast, Balanced, Best };
    enum class Stop { Ratio, Faces, Error };
    enum class Memory { None, Sum };

    Quality quality = Quality::Balanced;
    Stop stop = Stop::Ratio;
    double ratio = 0.5;
    int64_t faces = 1000;
    double error = 0.001;
    bool optimal = true;
    Memory memory = Memory::None;
    double border = 10;
    double feature = 180;
    double turn = 78;

    template <class V>
    void describe(V& v)
    {
        v.choice("quality", quality, {"textbook", "fast", "balanced", "best"},
                 {.title = "Quality",
                  .help = "textbook: a heap, the cheapest edge of all at each step. fast, balanced: buckets of about equal cost, many times quicker. "
                          "best: afterwards vertices are moved to where the old surface is, twice the time of balanced."});
        v.choice("stop", stop, {"ratio", "faces", "error"}, {.title = "Stop at", .help = "What ends the simplification."});
        describeKept(v, ratio, faces);
        v.number(
            "error", error,
            {.title = "Error",
             .help =
                 "How far the surface may move away, as a share of the diagonal of the bounding box; summed over the collapses at a place, so that "
                 "the true distance is smaller.",
             .min = 0,
             .max = 1,
             .softMin = 1e-5,
             .softMax = 0.05,
             .logarithmic = true,
             .when = "stop=error"});
        v.flag("optimal", optimal,
               {.title = "Optimal point", .help = "Move the new vertex to the best place; otherwise one of the two ends is kept."});
        v.choice("memory", memory, {"none", "sum"},
                 {.title = "Memory",
                  .help = "none: distances to the surface as it stands (closer result). sum: quadrics are added up, as in the paper.",
                  .advanced = true,
                  .when = "quality=textbook"});
        v.number("border", border,
                 {.title = "Border weight",
                  .help = "How strongly borders, seams and features hold their place, against faces.",
                  .min = 0,
                  .max = 1e6,
                  .softMax = 1000,
                  .advanced = true});
        v.number("feature", feature,
                 {.title = "Feature angle",
                  .help = "Edges whose faces meet at a greater angle are weighed like borders; 180: none are.",
                  .unit = "°",
                  .min = 0,
                  .max = 180,
                  .advanced = true});
        v.number("turn", turn,
                 {.title = "Normal turn", .help = "No face may turn by more in one collapse.", .unit = "°", .min = 1, .max = 90, .advanced = true});
    }
};

Generator decimateQuadric(Mesh input, DecimateQuadric parameters, Stage<Mesh>& stage);

}  // namespace mw
