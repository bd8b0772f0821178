// The triangle-adjacency primitive: six vertices a triangle.
#include "core/mesh/triangle_adjacency.h"

#include <algorithm>

#include "core/mesh/opposite_sides.h"

namespace mw {

namespace {

/// Missing neighbours of a primitive.
unsigned missing(const uint32_t* v)
{
    return unsigned(v[1] == v[0]) + unsigned(v[3] == v[2]) + unsigned(v[5] == v[4]);
}

/// The third vertex of the triangle that a polygon has at its side from a to b; none where cutting it left no such triangle.
uint32_t beyondSide(const Mesh& mesh, uint32_t polygon, uint32_t a, uint32_t b)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    const auto [first, last] = std::equal_range(cut.faces.begin(), cut.faces.end(), polygon);
    for (auto t = first; t != last; ++t) {
        const uint32_t* v = cut.vertices.data() + 3 * (t - cut.faces.begin());
        for (int k = 0; k < 3; ++k)
            if (v[k] == a && v[(k + 1) % 3] == b) return v[(k + 2) % 3];
    }
    return none;
}

}  // namespace

Array<uint32_t> adjacencyIndices(const Mesh& mesh)
{
    const Mesh triangles = mesh.isTriangles() ? mesh : Mesh::triangles(mesh.positions(), mesh.triangulation().vertices);
    const Array<uint32_t> opposite = oppositeSidesOf(triangles);
    const uint32_t* at = triangles.cornerVertex().data();
    Array<uint32_t> six(2 * opposite.size());
    for (uint32_t c = 0; c < opposite.size(); ++c) {
        const uint32_t o = opposite[c];
        six[2 * size_t(c)] = at[c];
        six[2 * size_t(c) + 1] = o == none ? at[c] : at[o % 3 == 0 ? o + 2 : o - 1];
    }
    return six;
}

std::optional<std::array<uint32_t, 6>> adjacencyOf(const HalfedgeWalk& walk, const Mesh& mesh, uint32_t face)
{
    if (face == none || mesh.face(face).size() != 3) return {};
    uint32_t h = walk.ofFace(face);
    if (h == none) return {};
    std::array<uint32_t, 6> six{};
    for (size_t k = 0; k < 3; ++k) {
        h = walk.next(h);
        const uint32_t pair = walk.pair(h), other = walk.face(pair);
        six[2 * k] = six[2 * k + 1] = walk.source(h);
        if (other == none) continue;
        const uint32_t beyond =
            mesh.face(other).size() == 3 ? walk.target(walk.next(pair)) : beyondSide(mesh, other, walk.source(pair), walk.target(pair));
        if (beyond != none) six[2 * k + 1] = beyond;
    }
    return six;
}

Generator triangleAdjacency(Mesh input, TriangleAdjacency, Stage<Table>& stage)
{
    co_yield Step("neighbours").number("faces", double(input.faceCount())).progress(0);
    const Array<uint32_t> six = adjacencyIndices(input);
    co_yield Step("rows").number("triangles", double(six.size() / 6)).progress(0.5);
    const size_t n = six.size() / 6;
    Table table;
    table.rows = input.isTriangles() ? ElementKind::Face : ElementKind::Object;
    table.columns.push_back({"missing", "", Array<double>(n), false});
    for (const char* name : {"v0", "v1", "v2", "v3", "v4", "v5"}) table.columns.push_back({name, "", Array<double>(n), false});
    if (!input.isTriangles()) {
        const auto& faces = input.triangulation().faces;
        table.columns.push_back({"face", "", Array<double>(faces.begin(), faces.end()), false});
    }
    double absent = 0, border = 0;
    for (size_t t = 0; t < n; ++t) {
        const unsigned m = missing(&six[6 * t]);
        table.columns[0].values[t] = m;
        for (size_t k = 0; k < 6; ++k) table.columns[k + 1].values[t] = six[6 * t + k];
        absent += m;
        border += m > 0;
    }
    table.summary = {{"triangles", double(n)}, {"triangles at a border", border}, {"missing neighbours", absent}};
    stage.finish(std::move(table));
}

}  // namespace mw
