// Query: how far each vertex of the border is off the line between its neighbours there.
#include "core/metrics/boundary_distance.h"

#include <algorithm>

#include "core/metrics/fan.h"

namespace mw {

Generator boundaryDistance(Mesh input, BoundaryDistance, Stage<Table>& stage)
{
    co_yield Step("find border").number("vertices", double(input.vertexCount())).progress(0);
    const BorderNeighbours border = borderNeighboursOf(input);
    const Shared<glm::vec3>& at = input.positions();
    const size_t n = input.vertexCount();
    Table table;
    table.rows = ElementKind::Vertex;
    addColumn(table, "d", "", n);
    addColumn(table, "d / longest side", "", n);
    stage.show([&table] { return table; });
    double measured = 0, sum = 0, greatest = 0;
    for (uint32_t v = 0; v < n; ++v) {
        if (!stage.watched() && (v & 8191) == 0) co_yield Step("measure").progress(double(v) / double(n));
        if (border.place[v] != BorderNeighbours::Place::Border) continue;
        const uint32_t p = border.neighbour[2 * v], q = border.neighbour[2 * v + 1];
        if (q == none) continue;
        const glm::dvec3 a = at[v], b = at[p], c = at[q];
        const double d = distanceToLine(a, b, c), longest = std::max(glm::distance(a, b), glm::distance(a, c)), width = glm::distance(b, c);
        table.columns[0].values[v] = d;
        if (longest > 0) table.columns[1].values[v] = d / longest;
        measured += 1;
        sum += d;
        greatest = std::max(greatest, d);
        if (!stage.watched()) continue;
        const double along = width > 0 ? glm::dot(a - b, c - b) / (width * width) : 0;
        const glm::vec3 foot(b + along * (c - b));
        co_yield Step("measure")
            .vertex(v, Role::Current, "v")
            .vertex(p, Role::Neighbour, "p")
            .vertex(q, Role::Neighbour, "q")
            .segment(at[p], at[q], Role::Neighbour)
            .segment(at[v], foot, Role::New, "d")
            .number("d", d)
            .number("width", width)
            .number("longest", longest)
            .progress(double(v) / double(n));
    }
    table.summary = {{"measured", measured}, {"mean", measured > 0 ? sum / measured : 0}, {"greatest", greatest}};
    stage.finish(std::move(table));
}

}  // namespace mw
