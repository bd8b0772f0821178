// Opposite sides by lists of open sides at the lower vertex of each edge; by sorting where such a list grows long.
#include "core/mesh/opposite_sides.h"

#include <algorithm>
#include <memory>

#include "core/mesh/connectivity.h"

namespace mw {

namespace {

Array<uint32_t> bySorting(const Mesh& mesh, std::span<const uint8_t> degenerate)
{
    const EdgeSides edges = edgeSidesOf(mesh, degenerate);
    Array<uint32_t> opposite(mesh.cornerCount(), none);
    std::vector<uint32_t> up, down;
    for (size_t e = 0; e < edges.size(); ++e) {
        up.clear();
        down.clear();
        for (const uint32_t c : edges.sides(e)) (mesh.cornerVertex()[c] == edges.ends[2 * e] ? up : down).push_back(c);
        for (size_t i = 0; i < std::min(up.size(), down.size()); ++i) {
            opposite[up[i]] = down[i];
            opposite[down[i]] = up[i];
        }
    }
    return opposite;
}

}  // namespace

Array<uint32_t> oppositeSidesOf(const Mesh& mesh)
{
    struct Open {
        uint32_t key, next;  // the other end, and in the lowest bit the direction still wanted; the next open side at the same vertex
    };
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    const uint32_t* at = mesh.cornerVertex().data();
    const uint32_t corners = uint32_t(mesh.cornerCount());
    const auto open = std::make_unique_for_overwrite<Open[]>(corners);
    Array<uint32_t> opposite(corners, none), head(mesh.vertexCount(), none);
    int64_t budget = 64 + 8 * int64_t(corners);  // a tip of low index with many sides would take the square
    for (uint32_t c = 0; c < corners; ++c) {
        if (!degenerate.empty() && degenerate[c / 3]) continue;
        const uint32_t a = at[c], b = at[c % 3 == 2 ? c - 2 : c + 1];
        const uint32_t key = std::max(a, b) * 2 + (a < b);
        uint32_t* link = &head[std::min(a, b)];
        while (*link != none && open[*link].key != key) {
            link = &open[*link].next;
            if (--budget < 0) return bySorting(mesh, degenerate);
        }
        if (*link == none) {
            *link = c;  // at the end: the oldest is found first
            open[c] = {key ^ 1, none};
        } else {
            opposite[c] = *link;
            opposite[*link] = c;
            *link = open[*link].next;
        }
    }
    return opposite;
}

}  // namespace mw
