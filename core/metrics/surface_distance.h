// How far two surfaces are apart: of each vertex of one, and of points spread over both (Hausdorff and root mean square).
#pragma once
#include <functional>

#include "core/mesh/mesh.h"
#include "core/mesh/other_mesh.h"
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

/// Points over a surface, evenly by area: as many in each triangle as its area asks for, the remainders carried on; within it by a sequence that
/// leaves no gaps (Roberts 2018, R2). The same on every run. None where there is no area.
std::vector<glm::dvec3> spreadPoints(const Mesh& mesh, size_t count);

struct SurfaceDistance {
    OtherMesh other;
    int64_t samples = 200000;
    template <class V>
    void describe(V& v)
    {
        v.object("other", other, {.title = "Other", .help = "The mesh to measure the distance to: a node, a file, or a source."});
        v.integer("samples", samples,
                  {.title = "Points",
                   .help = "How many points are spread over each of the two surfaces, beside their vertices.",
                   .min = 0,
                   .max = 1e7,
                   .softMin = 1000,
                   .softMax = 1e6,
                   .logarithmic = true});
    }
};

/// A row a vertex: "distance" to the other surface in % of the diagonal of the other mesh's box, and "d" as it is. The summary, absolute and (names
/// ending in " %") as that share: "hausdorff", the greatest distance found in either direction, "rms" and "mean", the greater of both directions;
/// each also "to other" and "from other". The greatest is sought among the vertices and the points; what lies between them may be farther by no
/// more than about "spacing", the root of area by point. Means are over the points alone, that is, by area (over the vertices where there are no
/// points). Both meshes are taken as they are in their own spaces. Throws Error when one of them has no face.
Generator surfaceDistance(Mesh input, SurfaceDistance parameters, Stage<Table>& stage);

}  // namespace mw
