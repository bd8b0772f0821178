// Refinement by formula, and the masks.
#include "core/subdivide/loop_level.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/subdivide/edge_rings.h"

namespace mw {

namespace {

constexpr uint32_t nextCorner(uint32_t c)
{
    return c % 3 == 2 ? c - 2 : c + 1;
}

}  // namespace

LoopLevel LoopLevel::of(const Mesh& mesh, std::span<const float> crease, SubdivideLoop::Corners corners, float lasting)
{
    FaceEdges found = faceEdgesOf(mesh, crease, lasting);
    LoopLevel l;
    l.vertices = mesh.vertexCount();
    l.vertex.assign(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    l.half = std::move(found.half);
    l.edges.resize(found.size());
    const auto opposite = [&](uint32_t c) { return l.vertex[nextCorner(nextCorner(c))]; };
    for (size_t e = 0; e < found.size(); ++e)
        l.edges[e] = {found.ends[e].a, found.ends[e].b, opposite(found.corner[e].a), opposite(found.corner[e].b)};
    l.sharp = std::move(found.sharp);
    for (uint32_t v = 0; v < l.vertices; ++v) {
        if (found.valence[v] != 6) l.irregular.emplace_back(v, found.valence[v]);
        if (found.facesAt[v] == 1 && corners == SubdivideLoop::Corners::Sharp) l.fixed.push_back(v);
    }
    l.creases = sharpVerticesOf(l.sharp, endsOf(l.sharp, l.edges), l.fixed);
    return l;
}

LoopLevel LoopLevel::refined(bool last) const
{
    LoopLevel n;
    const uint32_t v = uint32_t(vertices), e2 = 2 * uint32_t(edges.size());
    n.vertices = vertices + edges.size();
    n.vertex = largeArray<uint32_t>(4 * vertex.size());
    if (!last) {
        n.half = largeArray<uint32_t>(4 * vertex.size());
        n.edges = largeArray<Edge>(2 * edges.size() + vertex.size());
        n.irregular = irregular;
        n.fixed = fixed;
        n.sharp = faded(sharp);
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
    if (!last) n.creases = sharpVerticesOf(n.sharp, endsOf(n.sharp, n.edges), n.fixed);
    return n;
}

void LoopLevel::keepForPoints()
{
    vertex = half = {};
}

size_t LoopLevel::bytes() const
{
    return edges.size() * sizeof(Edge) + 4 * (vertex.size() + half.size()) + creases.size() * sizeof(SharpVertex) + sharp.size() * sizeof(SharpEdge) +
           irregular.size() * sizeof(irregular[0]) + 4 * fixed.size();
}

namespace {

MW_LOOP_FOR_EACH_MACHINE
void edgePoints(const LoopLevel::Edge* edge, const LoopLevel::Edge* end, const glm::vec3* old, glm::vec3* out, lanes::Sum* ring)
{
    for (; edge != end; ++edge, ++out) {
        MW_LANES(a, old[edge->a])
        MW_LANES(b, old[edge->b])
        MW_LANES(c, old[edge->c])
        MW_LANES(d, old[edge->d])
        MW_PUT_POINT(*out, 0.375 * (MW_DOUBLES(a) + MW_DOUBLES(b)) + 0.125 * (MW_DOUBLES(c) + MW_DOUBLES(d)))
        ring[edge->a].v += b;
        ring[edge->b].v += a;
    }
}

MW_LOOP_FOR_EACH_MACHINE
void regularVertices(size_t n, const glm::vec3* old, const lanes::Sum* ring, glm::vec3* out)
{
    for (size_t v = 0; v < n; ++v) {
        MW_LANES(p, old[v])
        MW_PUT_POINT(out[v], 0.625 * MW_DOUBLES(p) + 0.0625 * MW_DOUBLES(ring[v].v))
    }
}

}  // namespace

LoopPoints::LoopPoints(const LoopLevel& level, const Array<glm::vec3>& old, SubdivideLoop::Weights weights)
    : points(lanes::paddedPoints(level.vertices + level.edges.size())),
      level_(level),
      old_(old),
      weights_(weights),
      ring_(lanes::zeroSums(level.vertices))
{}

void LoopPoints::edges(size_t first, size_t end)
{
    edgePoints(level_.edges.data() + first, level_.edges.data() + end, old_.data(), points.data() + level_.vertices + first, ring_.data());
}

// All by the regular mask, without a branch; the few that differ are done over.
void LoopPoints::vertices()
{
    const Array<glm::vec3>& old = old_.points();
    regularVertices(level_.vertices, old_.data(), ring_.data(), points.data());
    for (const auto& [v, n] : level_.irregular) {
        const double w = loopWeight(weights_, n);
        points[v] = glm::vec3((1 - double(n) * w) * glm::dvec3(old[v]) + w * ring_[v].point());
    }
    for (const SharpEdge& s : level_.sharp) {
        const LoopLevel::Edge& k = level_.edges[s.edge];
        applySharp(s.sharpness, {k.a, k.b}, old, points[level_.vertices + s.edge]);
    }
    for (const SharpVertex& s : level_.creases) applySharp(s, old, points[s.vertex]);
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
    const EdgeRings rings(l.vertices, l.edges);
    const CreaseRows creases(l.vertices, l.edges.size(), l.creases, l.sharp);
    Stencils rows;
    for (uint32_t v = 0; v < l.vertices; ++v) {
        const auto ring = rings.of(v);
        const double w = loopWeight(weights, ring.size()), smooth = creases.smoothShare(v);
        rows.add(v, smooth * (1 - double(ring.size()) * w) + creases.own(v));
        if (smooth > 0)
            for (const uint32_t e : ring) rows.add(otherEnd(l.edges[e], v), smooth * w);
        creases.addSides(v, rows);
        rows.endRow();
    }
    for (uint32_t e = 0; e < l.edges.size(); ++e) {
        const LoopLevel::Edge& k = l.edges[e];
        const double smooth = creases.smoothShareOfEdge(e);
        rows.add(k.a, 0.5 - smooth * 0.125);
        rows.add(k.b, 0.5 - smooth * 0.125);
        if (smooth > 0) {
            rows.add(k.c, smooth * 0.125);
            rows.add(k.d, smooth * 0.125);
        }
        rows.endRow();
    }
    return rows;
}

}  // namespace mw
