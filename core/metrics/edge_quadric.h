// Query: what it costs to collapse each edge to its best point, by the quadric error metric. Book 3.1.1, (3.14).
#pragma once
#include "core/mesh/table.h"
#include "core/metrics/vertex_quadrics.h"
#include "core/steps/stage.h"

namespace mw {

struct EdgeQuadric {
    PlaneWeight weight = PlaneWeight::Plain;
    template <class V>
    void describe(V& v)
    {
        v.choice("weight", weight, {"plain", "area"},
                 {.title = "Planes count", .help = "Each the same, as in the book, or by the area of its face."});
    }
};

/// Where an edge would go and what that costs.
struct QuadricPoint {
    glm::dvec3 place{0};
    double cost = 0;
    bool solved = false;  ///< by A p = -b; else the best of the two ends and the middle
};
/// Of the sum of two quadrics, between their vertices a and b. A solution farther from both than a few lengths of the edge is not taken: there A is
/// near singular, and the planes leave p free along some direction.
QuadricPoint bestPoint(const Quadric& sum, const glm::dvec3& a, const glm::dvec3& b);

/// A row an edge, in the order of Mesh::edges(): "cost" = QEM(p; v) + QEM(p; w) at the optimal p, its "x", "y", "z", and "solved": 1 where p comes
/// from A p = -b, 0 where it is the best of v, w and the middle.
Generator edgeQuadric(Mesh input, EdgeQuadric parameters, Stage<Table>& stage);

}  // namespace mw
