// Edges by a counting sort over the lower vertex, then a small sort at each vertex.
#include "core/subdivide/face_edges.h"

#include <algorithm>
#include <numeric>

namespace mw {

namespace {

/// body(corner, its vertex, the vertex of the next corner) for every side.
template <class Body>
void forSides(const Mesh& mesh, const Body& body)
{
    const uint32_t *start = mesh.faceStart().data(), *v = mesh.cornerVertex().data();
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t end = start[f + 1];
        for (uint32_t c = start[f]; c < end; ++c) body(c, v[c], v[c + 1 == end ? start[f] : c + 1]);
    }
}

/// Corners in lists by the lower end of the side they begin; in a list sorted by the other end, then by corner.
struct SideLists {
    Array<uint32_t> start;
    Array<uint64_t> sides;  // other end << 32 | corner

    explicit SideLists(const Mesh& mesh) : start(mesh.vertexCount() + 2, 0), sides(mesh.cornerCount())
    {
        forSides(mesh, [&](uint32_t, uint32_t a, uint32_t b) { ++start[std::min(a, b) + 2]; });
        for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        forSides(mesh, [&](uint32_t c, uint32_t a, uint32_t b) { sides[start[std::min(a, b) + 1]++] = uint64_t(std::max(a, b)) << 32 | c; });
    }
    static void sort(uint64_t* first, uint64_t* last)
    {
        if (last - first > 24) {
            std::sort(first, last);
            return;
        }
        for (uint64_t* i = first; i != last; ++i) {
            const uint64_t x = *i;
            uint64_t* j = i;
            for (; j > first && j[-1] > x; --j) *j = j[-1];
            *j = x;
        }
    }
};

/// One edge: all sides between `low` and the same other end.
void addEdge(FaceEdges& out, const Mesh& mesh, uint32_t low, std::span<const uint64_t> sides, std::span<const float> crease, float lasting)
{
    const uint32_t first = uint32_t(sides[0]), high = uint32_t(sides[0] >> 32), a = mesh.cornerVertex()[first], b = a == low ? high : low;
    const uint32_t e = uint32_t(out.size());
    Ends corner{first, first};
    float sharpness = sides.size() != 2 || a == b ? alwaysSharp : 0;
    for (const uint64_t entry : sides) {
        const uint32_t c = uint32_t(entry), side = mesh.cornerVertex()[c] == a ? 0 : 1;
        out.half[c] = 2 * e + side;
        if (side == 1) corner.b = c;
        if (side == 0 && c != first) sharpness = alwaysSharp;
        if (!crease.empty() && crease[c] > sharpness) sharpness = crease[c] >= lasting ? alwaysSharp : crease[c];
    }
    if (sharpness > 0) out.sharp.push_back({e, sharpness});
    out.ends.push_back({a, b});
    out.corner.push_back(corner);
    ++out.valence[a], ++out.valence[b];
}

/// A sharp edge as seen from one of its ends.
struct Spoke {
    uint32_t vertex, other;
    float sharpness;
};

/// The rule for so many sharp edges; `a` and `b` are the other ends of the first two.
SharpVertex ruleOf(uint32_t v, size_t edges, uint32_t a, uint32_t b)
{
    if (edges < 2) return {v, v, v, 0, 0};
    if (edges == 2) return {v, a, b, 1, 0.125f};
    return {v, v, v, 1, 0};
}

/// Mixes the rule of a level with that of the next by how much is left of what fades now.
SharpVertex mixedRule(uint32_t v, std::span<const Spoke> now)
{
    uint32_t lasting[2] = {v, v};
    size_t later = 0;
    double left = 0, fading = 0;
    for (const Spoke& s : now) {
        if (s.sharpness <= 1)
            left += double(s.sharpness), ++fading;
        else if (later++ < 2)
            lasting[later - 1] = s.other;
    }
    const SharpVertex rule = ruleOf(v, now.size(), now[0].other, now.back().other);
    const size_t kind = std::min<size_t>(now.size(), 3);
    later = std::min<size_t>(later, 3);
    if (fading == 0 || kind == later || (kind < 2 && later < 2)) return rule;
    const float share = float(std::min(1.0, left / fading));
    const SharpVertex then = ruleOf(v, later, lasting[0], lasting[1]);
    if (then.share == 0) return {v, rule.a, rule.b, share * rule.share, rule.side};
    return {v, then.a, then.b, 1, (1 - share) * then.side};  // a corner that becomes a crease
}

}  // namespace

FaceEdges faceEdgesOf(const Mesh& mesh, std::span<const float> crease, float lasting)
{
    FaceEdges out;
    SideLists lists(mesh);
    out.half.resize(mesh.cornerCount());
    out.ends.reserve(mesh.cornerCount() / 2 + 8);
    out.corner.reserve(mesh.cornerCount() / 2 + 8);
    out.valence.assign(mesh.vertexCount(), 0);
    out.facesAt.assign(mesh.vertexCount(), 0);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        const uint32_t end = lists.start[v + 1];
        SideLists::sort(lists.sides.data() + lists.start[v], lists.sides.data() + end);
        for (uint32_t i = lists.start[v], j; i < end; i = j) {
            for (j = i + 1; j < end && lists.sides[j] >> 32 == lists.sides[i] >> 32;) ++j;
            addEdge(out, mesh, v, {lists.sides.data() + i, j - i}, crease, lasting);
        }
    }
    for (const uint32_t v : mesh.cornerVertex()) ++out.facesAt[v];
    return out;
}

std::vector<SharpEdge> faded(const std::vector<SharpEdge>& sharp)
{
    std::vector<SharpEdge> out;
    out.reserve(2 * sharp.size());
    for (const SharpEdge& s : sharp) {
        if (!(s.sharpness > 1)) continue;
        out.push_back({2 * s.edge, s.sharpness - 1});
        out.push_back({2 * s.edge + 1, s.sharpness - 1});
    }
    return out;
}

std::vector<SharpVertex> sharpVerticesOf(const std::vector<SharpEdge>& sharp, const std::vector<Ends>& ends, const std::vector<uint32_t>& fixed)
{
    uint32_t vertices = 0;
    for (const Ends& e : ends) vertices = std::max({vertices, e.a + 1, e.b + 1});
    Array<uint32_t> start(sharp.empty() ? 0 : vertices + 2, 0);
    for (const Ends& e : ends) ++start[e.a + 2], ++start[e.b + 2];
    for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    Array<Spoke> spokes(2 * sharp.size());
    for (size_t i = 0; i < sharp.size(); ++i) {
        spokes[start[ends[i].a + 1]++] = {ends[i].a, ends[i].b, sharp[i].sharpness};
        spokes[start[ends[i].b + 1]++] = {ends[i].b, ends[i].a, sharp[i].sharpness};
    }
    std::vector<SharpVertex> out;
    out.reserve(sharp.size() + fixed.size());
    for (size_t i = 0, end; i < spokes.size(); i = end) {
        const uint32_t v = spokes[i].vertex;
        end = start[v + 1];
        const SharpVertex rule = mixedRule(v, {spokes.data() + i, end - i});
        if (rule.share > 0 && (fixed.empty() || !std::binary_search(fixed.begin(), fixed.end(), v))) out.push_back(rule);
    }
    if (fixed.empty()) return out;
    for (const uint32_t v : fixed) out.push_back({v, v, v, 1, 0});
    std::stable_sort(out.begin(), out.end(), [](const SharpVertex& x, const SharpVertex& y) { return x.vertex < y.vertex; });
    return out;
}

}  // namespace mw
