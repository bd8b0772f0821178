// Corners are joined across all edges that are not cut; what hangs together at a vertex is a fan.
#include "core/mesh/cut_open.h"

#include <algorithm>

#include "core/mesh/connectivity.h"
#include "core/mesh/rings.h"
#include "core/mesh/union_find.h"

namespace mw {
namespace {

Mesh withVertices(const Mesh& mesh, const Array<uint32_t>& from, Array<uint32_t> corners)
{
    Array<glm::vec3> positions;
    positions.reserve(from.size());
    for (const uint32_t v : from) positions.push_back(mesh.positions()[v]);
    Mesh out = Mesh(std::move(positions), mesh.faceStart(), std::move(corners)).withGroupNames(mesh.groupNames()).withLines(mesh.lines());
    for (const Attribute& a : mesh.attributes()) out = out.with(a.domain == Domain::Vertex ? gathered(a, from) : a);
    return out;
}

}  // namespace

Mesh cutOpen(const Mesh& mesh, std::span<const uint32_t> edges)
{
    std::vector<std::pair<uint32_t, uint32_t>> cuts;
    std::vector<uint8_t> touched(mesh.vertexCount(), 0);
    for (size_t i = 0; i + 1 < edges.size(); i += 2) {
        if (std::max(edges[i], edges[i + 1]) >= mesh.vertexCount()) continue;
        cuts.push_back(std::minmax(edges[i], edges[i + 1]));
        touched[edges[i]] = touched[edges[i + 1]] = 1;
    }
    std::sort(cuts.begin(), cuts.end());

    const EdgeSides sides = edgeSidesOf(mesh);
    const Array<uint32_t> faceOf = cornerFacesOf(mesh);
    const auto next = [&](uint32_t c) { return c + 1 < mesh.faceStart()[faceOf[c] + 1] ? c + 1 : mesh.faceStart()[faceOf[c]]; };
    UnionFind fans(mesh.cornerCount());
    for (size_t e = 0; e < sides.size(); ++e) {
        const uint32_t a = sides.ends[2 * e], b = sides.ends[2 * e + 1];
        if (!touched[a] && !touched[b]) continue;
        if (std::binary_search(cuts.begin(), cuts.end(), std::pair(a, b))) continue;
        const auto cornerAt = [&](uint32_t side, uint32_t v) { return mesh.cornerVertex()[side] == v ? side : next(side); };
        for (const uint32_t side : sides.sides(e))
            for (const uint32_t v : {a, b}) fans.join(cornerAt(sides.sides(e)[0], v), cornerAt(side, v));
    }

    Array<uint32_t> from(mesh.vertexCount()), corners(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    for (uint32_t v = 0; v < from.size(); ++v) from[v] = v;
    std::vector<std::pair<uint32_t, uint32_t>> own;  // of a vertex: fan and the vertex it gets
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        if (!touched[v]) continue;
        own.clear();
        for (const uint32_t c : mesh.rings().cornersOf(v)) {
            const uint32_t fan = fans.root(c);
            auto known = std::find_if(own.begin(), own.end(), [&](const auto& f) { return f.first == fan; });
            if (known == own.end()) {
                own.emplace_back(fan, own.empty() ? v : uint32_t(from.size()));
                known = own.end() - 1;
                if (own.size() > 1) from.push_back(v);
            }
            corners[c] = known->second;
        }
    }
    return from.size() == mesh.vertexCount() ? mesh : withVertices(mesh, from, std::move(corners));
}

}  // namespace mw
