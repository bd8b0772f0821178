// Modifier: mends what makes a mesh no clean manifold, and changes nothing else.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Repair {
    bool splitEdges = true, splitVertices = true, dropDegenerate = true, dropDuplicates = true, dropIsolated = true;
    bool weld = false;
    double weldDistance = 0;
    bool dropTiny = false;
    double tinyShare = 0.01;

    template <class V>
    void describe(V& v)
    {
        v.flag(
            "split-edges", splitEdges,
            {.title = "Split non-manifold edges", .help = "Where more than two faces meet at an edge, the further ones get an edge of their own."});
        v.flag("split-vertices", splitVertices,
               {.title = "Split non-manifold vertices", .help = "Where several fans of faces meet at a vertex, each gets a vertex of its own."});
        v.flag("drop-degenerate", dropDegenerate,
               {.title = "Tidy degenerate faces",
                .help = "Repeated corners go. A face with fewer than three left is removed; one that visits a vertex twice is cut into triangles."});
        v.flag("drop-duplicates", dropDuplicates, {.title = "Drop duplicate faces", .help = "Of faces with the same vertices the first one stays."});
        v.flag("drop-isolated", dropIsolated, {.title = "Drop isolated vertices", .help = "Remove vertices that no face and no line uses."});
        v.flag("weld", weld,
               {.title = "Join coincident vertices", .help = "Vertices at the same place become one, where the surface stays a manifold."});
        v.number("weld-distance", weldDistance,
                 {.title = "Distance",
                  .help = "Vertices no further apart than this are joined; 0: only those at exactly the same place.",
                  .unit = "m",
                  .min = 0,
                  .softMax = 0.01,
                  .when = "weld=true"});
        v.flag("drop-tiny", dropTiny,
               {.title = "Drop tiny components", .help = "Remove pieces much smaller than the whole, such as crumbs of a scan."});
        v.number("tiny-share", tinyShare,
                 {.title = "Tiny below",
                  .help = "Box diagonal of a piece, as a share of that of the whole. The largest piece always stays.",
                  .min = 0,
                  .max = 1,
                  .softMax = 0.1,
                  .when = "drop-tiny=true"});
    }
};

/// In this order: faces are tidied and duplicates dropped, vertices joined (see weld.h) and what collapsed or doubled by that tidied, non-manifold
/// edges and vertices split (see fans.h), tiny components and isolated vertices removed. Afterwards the topology report has no offender of these
/// kinds. No other face is lost, no vertex moves, and a second run changes nothing. Every new element takes the attributes of the old one it was;
/// welding may move texture coordinates, normals and colours from vertices to corners. A mesh without faces keeps its points. O(n log n). A face that
/// visits a vertex twice, such as an outline with a bridge to its hole, keeps its area: it becomes triangles.
Generator repair(Mesh input, Repair parameters, Stage<Mesh>& stage);

}  // namespace mw
