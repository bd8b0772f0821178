// Query: what it costs to move each vertex to the middle of its ring, by the quadric error metric. Book 3.1.1, (3.10).
#pragma once
#include "core/mesh/table.h"
#include "core/metrics/vertex_quadrics.h"
#include "core/steps/stage.h"

namespace mw {

struct VertexQuadric {
    enum class At { Ring, Plane };
    At at = At::Ring;
    PlaneWeight weight = PlaneWeight::Plain;
    template <class V>
    void describe(V& v)
    {
        v.choice("at", at, {"ring", "plane"},
                 {.title = "Point", .help = "Where the cost is taken: the mean of the neighbours, or the mean point of the faces (3.1)."});
        v.choice("weight", weight, {"plain", "area"},
                 {.title = "Planes count", .help = "Each the same, as in the book, or by the area of its face."});
    }
};

/// A row a vertex: "QEM", the sum of squared distances from p to the planes of the faces at the vertex, and "distance", the root of its mean.
/// At the vertex itself it is 0, so p is the point that the vertex would move to. NaN without faces that have an area.
Generator vertexQuadric(Mesh input, VertexQuadric parameters, Stage<Table>& stage);

}  // namespace mw
