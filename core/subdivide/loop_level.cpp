// Refinement by formula, and the masks.
#include "core/subdivide/loop_level.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mw {

namespace {

constexpr uint32_t nextCorner(uint32_t c)
{
    return c % 3 == 2 ? c - 2 : c + 1;
}

/// Corners in lists by the lower end of the side they begin; in a list sorted by the other end, then by corner.
struct SideLists {
    std::vector<uint32_t> start;
    std::vector<uint64_t> sides;  // other end << 32 | corner

    SideLists(std::span<const uint32_t> vertex, size_t vertices) : start(vertices + 2, 0), sides(vertex.size())
    {
        const auto low = [&](uint32_t c) { return std::min(vertex[c], vertex[nextCorner(c)]); };
        for (uint32_t c = 0; c < vertex.size(); ++c) ++start[low(c) + 2];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (uint32_t c = 0; c < vertex.size(); ++c) sides[start[low(c) + 1]++] = uint64_t(std::max(vertex[c], vertex[nextCorner(c)])) << 32 | c;
        for (size_t v = 0; v < vertices; ++v) std::sort(sides.begin() + start[v], sides.begin() + start[v + 1]);
    }
};

}  // namespace

LoopLevel LoopLevel::of(const Mesh& mesh, std::span<const float> crease, SubdivideLoop::Corners corners)
{
    LoopLevel l;
    l.vertices = mesh.vertexCount();
    l.vertex.assign(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    l.half.resize(l.vertex.size());
    const SideLists lists(l.vertex, l.vertices);
    std::vector<uint32_t> valence(l.vertices, 0), facesAt(l.vertices, 0);
    for (size_t i = 0, end; i < lists.sides.size(); i = end) {
        const uint32_t first = uint32_t(lists.sides[i]), a = l.vertex[first], b = l.vertex[nextCorner(first)], e = uint32_t(l.edges.size());
        const auto sameEdge = [&](uint64_t side) {
            const uint32_t c = uint32_t(side), p = l.vertex[c], q = l.vertex[nextCorner(c)];
            return (p == a && q == b) || (p == b && q == a);
        };
        for (end = i + 1; end < lists.sides.size() && sameEdge(lists.sides[end]);) ++end;
        Edge edge{a, b, l.vertex[nextCorner(nextCorner(first))], 0};
        edge.d = edge.c;
        bool sharp = end - i != 2 || a == b;
        for (size_t k = i; k < end; ++k) {
            const uint32_t c = uint32_t(lists.sides[k]), side = l.vertex[c] == a ? 0 : 1;
            l.half[c] = 2 * e + side;
            if (side == 1) edge.d = l.vertex[nextCorner(nextCorner(c))];
            sharp = sharp || (k > i && side == 0) || (!crease.empty() && crease[c] >= 0.5f);
        }
        if (sharp) l.sharp.push_back(e);
        l.edges.push_back(edge);
        ++valence[a], ++valence[b];
    }
    for (const uint32_t v : l.vertex) ++facesAt[v];
    for (uint32_t v = 0; v < l.vertices; ++v) {
        if (valence[v] != 6) l.irregular.emplace_back(v, valence[v]);
        if (facesAt[v] == 1 && corners == SubdivideLoop::Corners::Sharp) l.fixed.push_back(v);
    }
    return l;
}

LoopLevel LoopLevel::refined(bool last) const
{
    LoopLevel n;
    const uint32_t v = uint32_t(vertices), e2 = 2 * uint32_t(edges.size());
    n.vertices = vertices + edges.size();
    n.vertex.resize(4 * vertex.size());
    if (!last) {
        n.half.resize(4 * vertex.size());
        n.edges.resize(2 * edges.size() + vertex.size());
        n.irregular = irregular;
        n.fixed = fixed;
        for (const uint32_t s : sharp) n.sharp.insert(n.sharp.end(), {2 * s, 2 * s + 1});
        for (size_t e = 0; e < edges.size(); ++e) {
            const uint32_t middle = v + uint32_t(e);
            n.edges[2 * e] = {edges[e].a, middle, 0, 0};
            n.edges[2 * e + 1] = {middle, edges[e].b, 0, 0};
        }
    }
    const auto firstPart = [](uint32_t h) { return 2 * h + (h & 1); };
    const auto secondPart = [](uint32_t h) { return 2 * (h ^ 1) + (h & 1); };
    for (uint32_t f = 0; f < faces(); ++f) {
        const uint32_t* h = half.data() + 3 * f;
        const uint32_t m[3] = {v + (h[0] >> 1), v + (h[1] >> 1), v + (h[2] >> 1)};
        uint32_t* out = n.vertex.data() + 12 * size_t(f);
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t before = k == 0 ? 2 : k - 1, after = k == 2 ? 0 : k + 1, own = vertex[3 * f + k];
            out[3 * k] = own, out[3 * k + 1] = m[k], out[3 * k + 2] = m[before];
            out[9 + k] = m[k];
            if (last) continue;
            uint32_t* halves = n.half.data() + 12 * size_t(f);
            const uint32_t inner = e2 + 3 * f + k;
            halves[3 * k] = firstPart(h[k]), halves[3 * k + 1] = 2 * inner, halves[3 * k + 2] = secondPart(h[before]);
            halves[9 + before] = 2 * inner + 1;  // the middle runs m_k-1 to m_k
            n.edges[inner] = {m[k], m[before], own, m[after]};
            // What lies opposite to the two parts of side k.
            const uint32_t one = firstPart(h[k]), two = secondPart(h[k]);
            (one & 1 ? n.edges[one >> 1].d : n.edges[one >> 1].c) = m[before];
            (two & 1 ? n.edges[two >> 1].d : n.edges[two >> 1].c) = m[after];
        }
    }
    return n;
}

LoopPoints::LoopPoints(const LoopLevel& level, const std::vector<glm::dvec3>& old, SubdivideLoop::Weights weights)
    : points(level.vertices + level.edges.size()), level_(level), old_(old), weights_(weights), ring_(level.vertices, glm::dvec3(0))
{}

void LoopPoints::edges(size_t first, size_t end)
{
    glm::dvec3* out = points.data() + level_.vertices;
    for (size_t e = first; e < end; ++e) {
        const LoopLevel::Edge& k = level_.edges[e];
        const glm::dvec3 &a = old_[k.a], &b = old_[k.b];
        out[e] = 0.375 * (a + b) + 0.125 * (old_[k.c] + old_[k.d]);
        ring_[k.a] += b;
        ring_[k.b] += a;
    }
}

// All by the regular mask, without a branch; the few that differ are done over.
void LoopPoints::vertices()
{
    for (size_t v = 0; v < level_.vertices; ++v) points[v] = 0.625 * old_[v] + 0.0625 * ring_[v];
    for (const auto& [v, n] : level_.irregular) {
        const double w = loopWeight(weights_, n);
        points[v] = (1 - double(n) * w) * old_[v] + w * ring_[v];
    }
    applySharp();
}

void LoopPoints::applySharp()
{
    std::vector<uint8_t> count(level_.sharp.empty() ? 0 : level_.vertices, 0);
    for (const uint32_t e : level_.sharp) {
        const LoopLevel::Edge& k = level_.edges[e];
        points[level_.vertices + e] = 0.5 * (old_[k.a] + old_[k.b]);
        ring_[k.a] = ring_[k.b] = glm::dvec3(0);
    }
    for (const uint32_t e : level_.sharp) {
        const LoopLevel::Edge& k = level_.edges[e];
        ring_[k.a] += old_[k.b];
        ring_[k.b] += old_[k.a];
        count[k.a] = uint8_t(std::min(count[k.a] + 1, 3));
        count[k.b] = uint8_t(std::min(count[k.b] + 1, 3));
    }
    for (const uint32_t e : level_.sharp)
        for (const uint32_t v : {level_.edges[e].a, level_.edges[e].b}) {
            if (count[v] == 2) points[v] = 0.75 * old_[v] + 0.125 * ring_[v];
            if (count[v] == 3) points[v] = old_[v];
        }
    for (const uint32_t v : level_.fixed) points[v] = old_[v];
}

double loopWeight(SubdivideLoop::Weights weights, size_t n)
{
    if (n == 0) return 0;
    const double d = double(n);
    if (weights == SubdivideLoop::Weights::Warren) return n == 3 ? 3.0 / 16 : 3 / (8 * d);
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / d);
    return (0.625 - c * c) / d;
}

Stencils loopVertexRows(const LoopLevel& l, SubdivideLoop::Weights weights)
{
    std::vector<uint32_t> start(l.vertices + 2, 0), neighbour(2 * l.edges.size());
    std::vector<uint8_t> sharpEdge(l.edges.size(), 0), fixed(l.vertices, 0);
    for (const uint32_t e : l.sharp) sharpEdge[e] = 1;
    for (const uint32_t v : l.fixed) fixed[v] = 1;
    for (const auto& k : l.edges) ++start[k.a + 2], ++start[k.b + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (uint32_t e = 0; e < l.edges.size(); ++e) {
        neighbour[start[l.edges[e].a + 1]++] = e;
        neighbour[start[l.edges[e].b + 1]++] = e;
    }
    Stencils rows;
    std::vector<uint32_t> sharp;
    for (uint32_t v = 0; v < l.vertices; ++v) {
        const auto other = [&](uint32_t e) { return l.edges[e].a == v ? l.edges[e].b : l.edges[e].a; };
        const uint32_t n = start[v + 1] - start[v];
        sharp.clear();
        for (uint32_t i = start[v]; i < start[v + 1]; ++i)
            if (sharpEdge[neighbour[i]]) sharp.push_back(other(neighbour[i]));
        if (n == 0 || fixed[v] || sharp.size() > 2) {
            rows.add(v, 1);
        } else if (sharp.size() == 2) {
            rows.add(v, 0.75);
            for (const uint32_t s : sharp) rows.add(s, 0.125);
        } else {
            const double w = loopWeight(weights, n);
            rows.add(v, 1 - n * w);
            for (uint32_t i = start[v]; i < start[v + 1]; ++i) rows.add(other(neighbour[i]), w);
        }
        rows.endRow();
    }
    for (uint32_t e = 0; e < l.edges.size(); ++e) {
        const LoopLevel::Edge& k = l.edges[e];
        rows.add(k.a, sharpEdge[e] ? 0.5 : 0.375);
        rows.add(k.b, sharpEdge[e] ? 0.5 : 0.375);
        if (!sharpEdge[e]) {
            rows.add(k.c, 0.125);
            rows.add(k.d, 0.125);
        }
        rows.endRow();
    }
    return rows;
}

Stencils loopCornerRows(size_t faces)
{
    Stencils rows;
    for (uint32_t c = 0; c < 3 * faces; c += 3) {
        const auto middle = [&](uint32_t k) {
            rows.add(c + k, 0.5);
            rows.add(c + (k + 1) % 3, 0.5);
            rows.endRow();
        };
        for (uint32_t k = 0; k < 3; ++k) {
            rows.add(c + k, 1);
            rows.endRow();
            middle(k);
            middle((k + 2) % 3);
        }
        for (uint32_t k = 0; k < 3; ++k) middle(k);
    }
    return rows;
}

}  // namespace mw
