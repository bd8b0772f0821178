// Query: what it costs to collapse each edge to its best point.
#include "core/metrics/edge_quadric.h"

#include <algorithm>

namespace mw {

QuadricPoint bestPoint(const Quadric& sum, const glm::dvec3& a, const glm::dvec3& b)
{
    const double reach = 4 * glm::dot(b - a, b - a);
    QuadricPoint best;
    if (sum.least(best.place) && glm::dot(best.place - a, best.place - a) < reach && glm::dot(best.place - b, best.place - b) < reach) {
        best.cost = std::max(0.0, sum.at(best.place));
        best.solved = true;
        return best;
    }
    best = {0.5 * (a + b), sum.at(0.5 * (a + b)), false};
    for (const glm::dvec3& p : {a, b}) {
        const double cost = sum.at(p);
        if (cost < best.cost) best = {p, cost, false};
    }
    best.cost = std::max(0.0, best.cost);
    return best;
}

Generator edgeQuadric(Mesh input, EdgeQuadric parameters, Stage<Table>& stage)
{
    co_yield Step("gather").number("vertices", double(input.vertexCount())).progress(0);
    const VertexQuadrics q = vertexQuadricsOf(input, faceMeasuresOf(input), parameters.weight);
    if (!stage.watched()) co_yield Step("gather").progress(0);
    const Shared<uint32_t>& ends = input.edges();
    if (!stage.watched()) co_yield Step("gather").progress(0);
    const size_t n = ends.size() / 2;
    Table table;
    table.rows = ElementKind::Edge;
    table.edges.assign(ends.begin(), ends.end());
    for (const char* name : {"cost", "x", "y", "z", "solved"}) addColumn(table, name, "", n);
    stage.show([&table] { return table; });
    double sum = 0, greatest = 0, solved = 0;
    for (size_t e = 0; e < n; ++e) {
        if (!stage.watched() && (e & 8191) == 0) co_yield Step("measure").progress(double(e) / double(n));
        const uint32_t v = ends[2 * e], w = ends[2 * e + 1];
        const Quadric both = q.quadric[v] + q.quadric[w];
        const QuadricPoint best = bestPoint(both, q.local(input.positions()[v]), q.local(input.positions()[w]));
        const glm::dvec3 place = best.place + q.centre;
        table.columns[0].values[e] = best.cost;
        for (int k = 0; k < 3; ++k) table.columns[size_t(k) + 1].values[e] = place[k];
        table.columns[4].values[e] = best.solved;
        sum += best.cost;
        greatest = std::max(greatest, best.cost);
        solved += best.solved;
        if (stage.watched())
            co_yield Step("measure")
                .edge(v, w, Role::Current, "e")
                .vertex(v, Role::Current, "v")
                .vertex(w, Role::Current, "w")
                .point(glm::vec3(place), Role::New, "p")
                .number("planes", double(q.planes[v] + q.planes[w]))
                .number("solved", double(best.solved))
                .number("condition", both.condition())
                .number("cost v", std::max(0.0, both.at(q.local(input.positions()[v]))))
                .number("cost w", std::max(0.0, both.at(q.local(input.positions()[w]))))
                .number("x", place.x)
                .number("y", place.y)
                .number("z", place.z)
                .number("cost", best.cost)
                .progress(double(e) / double(n));
    }
    table.summary = {{"edges", double(n)}, {"mean", n > 0 ? sum / double(n) : 0}, {"greatest", greatest}, {"solved", solved}};
    stage.finish(std::move(table));
}

}  // namespace mw
