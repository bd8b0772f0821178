// Query: how many edges meet at each vertex.
#include "core/metrics/valence.h"

#include <algorithm>

#include "core/mesh/connectivity.h"

namespace mw {

Generator vertexValence(Mesh input, VertexValence, Stage<Table>& stage)
{
    co_yield Step("count edges").number("vertices", double(input.vertexCount())).progress(0);
    Rings own;
    const Rings& rings = ringsOfGoodFaces(input, own);
    Array<double> valence(input.vertexCount());
    const double inner = input.isTriangles() ? 6 : 4, outer = input.isTriangles() ? 4 : 3;
    double used = 0, regular = 0, sum = 0, least = 0, greatest = 0;
    for (uint32_t v = 0; v < valence.size(); ++v) {
        const auto sides = rings.sidesAt(v);
        const bool onBoundary = std::find(sides.begin(), sides.end(), 1) != sides.end();
        valence[v] = double(sides.size());
        if (valence[v] == 0) continue;
        least = used == 0 ? valence[v] : std::min(least, valence[v]);
        greatest = std::max(greatest, valence[v]);
        sum += valence[v];
        used += 1;
        regular += valence[v] == (onBoundary ? outer : inner);
    }
    Table table;
    table.rows = ElementKind::Vertex;
    table.columns.push_back({"valence", "", std::move(valence), false});
    table.summary = {{"mean", used > 0 ? sum / used : 0},
                     {"least", least},
                     {"greatest", greatest},
                     {"regular share", used > 0 ? regular / used : 0},
                     {"sum of valences", sum},
                     {"edges", sum / 2}};
    stage.finish(std::move(table));
}

}  // namespace mw
