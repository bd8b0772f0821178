// Query: how many edges meet at each vertex.
#include "core/metrics/valence.h"

#include <algorithm>

#include "core/mesh/connectivity.h"

namespace mw {

Generator vertexValence(Mesh input, VertexValence, Stage<Table>& stage)
{
    co_yield Step("count edges").number("vertices", double(input.vertexCount())).progress(0);
    const std::vector<uint8_t> degenerate = degenerateFacesOf(input);
    const EdgeSides edges = edgeSidesOf(input, degenerate);
    Array<double> valence(input.vertexCount(), 0.);
    std::vector<uint8_t> onBoundary(input.vertexCount(), 0);
    for (size_t e = 0; e < edges.size(); ++e)
        for (const uint32_t v : {edges.ends[2 * e], edges.ends[2 * e + 1]}) {
            ++valence[v];
            if (edges.sides(e).size() == 1) onBoundary[v] = 1;
        }

    const double inner = input.isTriangles() ? 6 : 4, outer = input.isTriangles() ? 4 : 3;
    double used = 0, regular = 0, sum = 0, least = 0, greatest = 0;
    for (size_t v = 0; v < valence.size(); ++v) {
        if (valence[v] == 0) continue;
        least = used == 0 ? valence[v] : std::min(least, valence[v]);
        greatest = std::max(greatest, valence[v]);
        sum += valence[v];
        used += 1;
        regular += valence[v] == (onBoundary[v] ? outer : inner);
    }
    Table table;
    table.rows = ElementKind::Vertex;
    table.columns.push_back({"valence", "", std::move(valence), false});
    table.summary = {{"mean", used > 0 ? sum / used : 0},
                     {"least", least},
                     {"greatest", greatest},
                     {"regular share", used > 0 ? regular / used : 0},
                     {"sum of valences", sum},
                     {"edges", double(edges.size())}};
    stage.finish(std::move(table));
}

}  // namespace mw
