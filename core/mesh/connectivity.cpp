// Edges of polygons gathered by sorting. A counting sort by the lower vertex, then a small sort at each vertex: near-linear, and no input
// makes it slower than n log n.
#include "core/mesh/connectivity.h"

#include <algorithm>
#include <memory>

namespace mw {

namespace {

/// body(corner, its vertex, the vertex of the next corner) for every side.
template <class Body>
void forSides(const Mesh& mesh, std::span<const uint8_t> leftOut, const Body& body)
{
    const uint32_t *start = mesh.faceStart().data(), *v = mesh.cornerVertex().data();
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t first = start[f], end = start[f + 1];
        if (first == end || (!leftOut.empty() && leftOut[f])) continue;
        for (uint32_t c = first; c + 1 < end; ++c) body(c, v[c], v[c + 1]);
        body(end - 1, v[end - 1], v[first]);
    }
}

/// Turns counts at [i + 1] into starts.
void accumulate(Array<uint32_t>& counts)
{
    for (size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
}

void sortSmall(uint64_t* first, uint64_t* last)
{
    if (last - first > 24) {
        std::sort(first, last);
        return;
    }
    if (first == last) return;  // perhaps null
    for (uint64_t* i = first + 1; i < last; ++i) {
        const uint64_t x = *i;
        uint64_t* j = i;
        for (; j > first && j[-1] > x; --j) *j = j[-1];
        *j = x;
    }
}

/// All sides as (other vertex, corner), by lower vertex; `start` says where the sides of a vertex begin.
Array<uint64_t> sidesByLowerVertex(const Mesh& mesh, std::span<const uint8_t> leftOut, Array<uint32_t>& start)
{
    start.assign(mesh.vertexCount() + 2, 0);
    forSides(mesh, leftOut, [&](uint32_t, uint32_t a, uint32_t b) { start[std::min(a, b) + 2] += a != b; });
    accumulate(start);
    Array<uint64_t> sides(start.back());
    forSides(mesh, leftOut, [&](uint32_t c, uint32_t a, uint32_t b) {
        if (a != b) sides[start[std::min(a, b) + 1]++] = uint64_t(std::max(a, b)) << 32 | c;
    });
    start.pop_back();
    return sides;
}

/// Sides still open hang in a list at one end of theirs, the home. A side that runs the other way closes the oldest one, which leaves the list, so
/// that lists stay about one long. False when it took more than `budget` steps through them.
template <class HomeIsFirst>
bool pairSides(const Mesh& mesh, std::span<const uint8_t> leftOut, int64_t budget, const HomeIsFirst& homeIsFirst, Array<uint32_t>& opposite)
{
    struct Open {
        uint32_t key, next;  // the other end, and in the lowest bit the direction still wanted
    };
    const auto open = std::make_unique_for_overwrite<Open[]>(mesh.cornerCount());  // pages never touched cost nothing
    std::vector<uint32_t> head(mesh.vertexCount(), none);
    uint32_t* out = opposite.data();
    forSides(mesh, leftOut, [&](uint32_t c, uint32_t a, uint32_t b) {
        if (budget <= 0) return;
        out[c] = none;
        if (a == b) return;
        const bool homeIsA = homeIsFirst(a, b);
        const uint32_t key = (homeIsA ? b : a) * 2 + homeIsA;
        uint32_t* link = &head[homeIsA ? a : b];
        while (*link != none && open[*link].key != key) {
            link = &open[*link].next;
            --budget;
        }
        if (const uint32_t d = *link; d != none) {
            out[c] = d;
            out[d] = c;
            *link = open[d].next;
        } else {
            *link = c;  // at the end of the list: the oldest is found first
            open[c] = {key ^ 1, none};
        }
    });
    return budget > 0;
}

}  // namespace

// Should the lists grow long (a cone whose tip has a low index), it starts again with the end of lower degree as home, which bounds the search for
// any input; the pairs come out the same.
Array<uint32_t> oppositeCornersOf(const Mesh& mesh, std::span<const uint8_t> leftOut)
{
    Array<uint32_t> opposite(mesh.cornerCount());
    if (!leftOut.empty()) std::fill(opposite.begin(), opposite.end(), none);
    if (pairSides(
            mesh, leftOut, 64 + 8 * int64_t(mesh.cornerCount()), [](uint32_t a, uint32_t b) { return a < b; }, opposite))
        return opposite;
    std::vector<uint32_t> degree(mesh.vertexCount(), 0);
    forSides(mesh, leftOut, [&](uint32_t, uint32_t a, uint32_t) { ++degree[a]; });
    pairSides(
        mesh, leftOut, INT64_MAX, [&](uint32_t a, uint32_t b) { return degree[a] < degree[b] || (degree[a] == degree[b] && a < b); }, opposite);
    return opposite;
}

EdgeSides edgeSidesOf(const Mesh& mesh, std::span<const uint8_t> leftOut)
{
    Array<uint32_t> first;
    Array<uint64_t> sides = sidesByLowerVertex(mesh, leftOut, first);
    EdgeSides out;
    out.corner.resize(sides.size());
    out.start.reserve(sides.size() / 2 + 2);
    out.ends.reserve(sides.size() + 2);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        sortSmall(sides.data() + first[v], sides.data() + first[v + 1]);
        uint32_t last = none;
        for (uint32_t i = first[v]; i < first[v + 1]; ++i) {
            const uint32_t other = uint32_t(sides[i] >> 32);
            if (other != last) {
                if (i > 0) out.start.push_back(i);  // the first edge starts at 0 already
                out.ends.push_back(v);
                out.ends.push_back(other);
                last = other;
            }
            out.corner[i] = uint32_t(sides[i]);
        }
    }
    if (!out.ends.empty()) out.start.push_back(uint32_t(sides.size()));
    return out;
}

Array<uint32_t> edgesOf(const Mesh& mesh)
{
    const EdgeSides edges = edgeSidesOf(mesh);
    std::vector<uint8_t> isFirst(mesh.cornerCount(), 0);
    for (size_t e = 0; e < edges.size(); ++e) isFirst[edges.corner[edges.start[e]]] = 1;
    Array<uint32_t> pairs(2 * edges.size());
    uint32_t* out = pairs.data();
    forSides(mesh, {}, [&](uint32_t c, uint32_t a, uint32_t b) {
        if (!isFirst[c]) return;
        *out++ = std::min(a, b);
        *out++ = std::max(a, b);
    });
    return pairs;
}

Rings ringsOf(const Mesh& mesh, std::span<const uint8_t> leftOut)
{
    const size_t n = mesh.vertexCount();
    Rings out;
    out.start.assign(n + 2, 0);
    forSides(mesh, leftOut, [&](uint32_t, uint32_t v, uint32_t) { ++out.start[v + 2]; });
    accumulate(out.start);
    out.corner.resize(out.start.back());
    forSides(mesh, leftOut, [&](uint32_t c, uint32_t v, uint32_t) { out.corner[out.start[v + 1]++] = c; });
    out.start.pop_back();

    const EdgeSides edges = edgeSidesOf(mesh, leftOut);
    out.neighbourStart.assign(n + 2, 0);
    for (const uint32_t v : edges.ends) ++out.neighbourStart[v + 2];
    accumulate(out.neighbourStart);
    out.neighbour.resize(edges.ends.size());
    out.sides.resize(edges.ends.size());
    // Edges come by lower vertex, so a vertex meets its lower neighbours before its higher ones: each list ascends.
    for (size_t e = 0; e < edges.size(); ++e) {
        const uint32_t a = edges.ends[2 * e], b = edges.ends[2 * e + 1];
        const uint32_t atA = out.neighbourStart[a + 1]++, atB = out.neighbourStart[b + 1]++;
        out.neighbour[atA] = b;
        out.neighbour[atB] = a;
        out.sides[atA] = out.sides[atB] = uint8_t(std::min<size_t>(edges.sides(e).size(), 255));
    }
    out.neighbourStart.pop_back();
    return out;
}

const Rings& ringsOfGoodFaces(const Mesh& mesh, Rings& own)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    if (degenerate.empty()) return mesh.rings();
    own = ringsOf(mesh, degenerate);
    return own;
}

std::vector<uint8_t> degenerateFacesOf(const Mesh& mesh)
{
    std::vector<uint8_t> out;
    std::vector<uint32_t> stamp;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        bool bad = face.size() < 3;
        if (face.size() == 3) {
            bad = face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
        } else if (!bad) {
            if (stamp.empty()) stamp.assign(mesh.vertexCount(), none);
            for (const uint32_t v : face) {
                bad = bad || stamp[v] == f;
                stamp[v] = uint32_t(f);
            }
        }
        if (!bad) continue;
        if (out.empty()) out.assign(mesh.faceCount(), 0);
        out[f] = 1;
    }
    return out;
}

Array<uint32_t> cornerFacesOf(const Mesh& mesh)
{
    Array<uint32_t> out(mesh.cornerCount());
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) out[c] = uint32_t(f);
    return out;
}

}  // namespace mw
