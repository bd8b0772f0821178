// Refinement by formula, and the masks.
#include "core/subdivide/catmull_level.h"

#include <algorithm>

#include "core/subdivide/edge_rings.h"

namespace mw {

namespace {

Array<uint32_t> facesOfCorners(const Mesh& mesh)
{
    Array<uint32_t> out(mesh.cornerCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f)
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) out[c] = f;
    return out;
}

bool allQuads(const Mesh& mesh)
{
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        if (mesh.face(f).size() != 4) return false;
    return true;
}

constexpr uint32_t firstPart(uint32_t half)
{
    return 2 * half + (half & 1);
}

constexpr uint32_t secondPart(uint32_t half)
{
    return 2 * (half ^ 1) + (half & 1);
}

/// (1 - (n + m)/n^2) v + (sum of n neighbours + sum of m face points)/n^2: (Q + 2R + (n-3) v)/n where n = m.
double ringWeight(const CatmullLevel::Irregular& i)
{
    return i.edges ? 1.0 / (double(i.edges) * double(i.edges)) : 0;
}

}  // namespace

CatmullLevel CatmullLevel::of(const Mesh& mesh, std::span<const float> crease, bool sharpCorners, float lasting)
{
    FaceEdges found = faceEdgesOf(mesh, crease, lasting);
    CatmullLevel l;
    l.vertices = mesh.vertexCount();
    if (!allQuads(mesh)) l.faceStart.assign(mesh.faceStart().begin(), mesh.faceStart().end());
    l.vertex.assign(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    l.half = std::move(found.half);
    l.edges.resize(found.size());
    const Array<uint32_t> face = facesOfCorners(mesh);
    for (size_t e = 0; e < found.size(); ++e) l.edges[e] = {found.ends[e].a, found.ends[e].b, face[found.corner[e].a], face[found.corner[e].b]};
    l.sharp = std::move(found.sharp);
    for (uint32_t v = 0; v < l.vertices; ++v) {
        if (found.valence[v] != 4 || found.facesAt[v] != 4) l.irregular.push_back({v, found.valence[v], found.facesAt[v]});
        if (found.facesAt[v] == 1 && sharpCorners) l.fixed.push_back(v);
    }
    l.creases = sharpVerticesOf(l.sharp, endsOf(l.sharp, l.edges), l.fixed);
    return l;
}

CatmullLevel CatmullLevel::refined(bool last) const
{
    CatmullLevel n;
    const uint32_t v = uint32_t(vertices), e2 = 2 * uint32_t(edges.size()), centre = v + uint32_t(edges.size());
    n.vertices = vertices + edges.size() + faces();
    n.vertex.resize(4 * vertex.size());
    if (!last) {
        n.half.resize(4 * vertex.size());
        n.edges.resize(2 * edges.size() + vertex.size());
        for (size_t e = 0; e < edges.size(); ++e) {
            const uint32_t middle = v + uint32_t(e);
            n.edges[2 * e] = {edges[e].a, middle, 0, 0};
            n.edges[2 * e + 1] = {middle, edges[e].b, 0, 0};
        }
    }
    const auto quad = [&](uint32_t c, uint32_t before, uint32_t after, uint32_t f) {
        const uint32_t h = half[c], g = half[before], middle = v + (h >> 1);
        uint32_t* out = n.vertex.data() + 4 * size_t(c);
        out[0] = vertex[c], out[1] = middle, out[2] = centre + f, out[3] = v + (g >> 1);
        if (last) return;
        uint32_t* halves = n.half.data() + 4 * size_t(c);
        const uint32_t one = firstPart(h), two = secondPart(h);
        halves[0] = one, halves[1] = 2 * (e2 + c), halves[2] = 2 * (e2 + before) + 1, halves[3] = secondPart(g);
        n.edges[e2 + c] = {middle, centre + f, c, after};
        (one & 1 ? n.edges[one >> 1].g : n.edges[one >> 1].f) = c;
        (two & 1 ? n.edges[two >> 1].g : n.edges[two >> 1].f) = after;
    };
    for (uint32_t f = 0; f < faces(); ++f) {
        const uint32_t first = firstCorner(f), end = firstCorner(f + 1);
        for (uint32_t c = first; c < end; ++c) quad(c, c == first ? end - 1 : c - 1, c + 1 == end ? first : c + 1, f);
    }
    if (last) return n;
    n.irregular = irregular;
    for (uint32_t f = 0; f < faces() && !faceStart.empty(); ++f)
        if (const uint32_t corners = firstCorner(f + 1) - firstCorner(f); corners != 4) n.irregular.push_back({centre + f, corners, corners});
    n.fixed = fixed;
    n.sharp = faded(sharp);
    for (const SharpEdge& s : sharp)
        if (edges[s.edge].f == edges[s.edge].g)
            for (const uint32_t e : {2 * s.edge, 2 * s.edge + 1}) n.edges[e].g = n.edges[e].f;
    n.creases = sharpVerticesOf(n.sharp, endsOf(n.sharp, n.edges), n.fixed);
    return n;
}

CatmullPoints::CatmullPoints(const CatmullLevel& level, const Array<glm::vec3>& old)
    : points(level.vertices + level.edges.size() + level.faces()), level_(level), old_(old), ring_(level.vertices, glm::dvec3(0))
{}

void CatmullPoints::faces(size_t first, size_t end)
{
    glm::vec3* out = points.data() + level_.vertices + level_.edges.size();
    const auto polygon = [&](size_t f, const uint32_t* v, size_t n) {
        glm::dvec3 sum(0);
        for (size_t k = 0; k < n; ++k) sum += glm::dvec3(old_[v[k]]);
        sum /= double(n);
        out[f] = glm::vec3(sum);
        for (size_t k = 0; k < n; ++k) ring_[v[k]] += sum;
    };
    const uint32_t* v = level_.vertex.data();
    if (level_.faceStart.empty())
        for (size_t f = first; f < end; ++f) polygon(f, v + 4 * f, 4);
    else
        for (size_t f = first; f < end; ++f) polygon(f, v + level_.faceStart[f], level_.faceStart[f + 1] - level_.faceStart[f]);
}

void CatmullPoints::edges(size_t first, size_t end)
{
    glm::vec3* out = points.data() + level_.vertices;
    const glm::vec3* centre = out + level_.edges.size();
    for (size_t e = first; e < end; ++e) {
        const CatmullLevel::Edge& k = level_.edges[e];
        const glm::dvec3 a(old_[k.a]), b(old_[k.b]);
        out[e] = glm::vec3(0.25 * (a + b + glm::dvec3(centre[k.f]) + glm::dvec3(centre[k.g])));
        ring_[k.a] += b;
        ring_[k.b] += a;
    }
}

// All by the regular mask, without a branch; the few that differ are done over.
void CatmullPoints::vertices()
{
    for (size_t v = 0; v < level_.vertices; ++v) points[v] = glm::vec3(0.5 * glm::dvec3(old_[v]) + 0.0625 * ring_[v]);
    for (const CatmullLevel::Irregular& i : level_.irregular) {
        const double w = ringWeight(i);
        points[i.vertex] = glm::vec3((1 - double(i.edges + i.faces) * w) * glm::dvec3(old_[i.vertex]) + w * ring_[i.vertex]);
    }
    for (const SharpEdge& s : level_.sharp) {
        const CatmullLevel::Edge& k = level_.edges[s.edge];
        applySharp(s.sharpness, {k.a, k.b}, old_, points[level_.vertices + s.edge]);
    }
    for (const SharpVertex& s : level_.creases) applySharp(s, old_, points[s.vertex]);
}

namespace {

/// Faces at every vertex, once for each corner.
struct FacesAt {
    Array<uint32_t> start, face;

    explicit FacesAt(const CatmullLevel& l) : start(l.vertices + 2, 0), face(l.vertex.size())
    {
        for (const uint32_t v : l.vertex) ++start[v + 2];
        for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        for (uint32_t f = 0; f < l.faces(); ++f)
            for (uint32_t c = l.firstCorner(f); c < l.firstCorner(f + 1); ++c) face[start[l.vertex[c] + 1]++] = f;
    }
};

}  // namespace

Stencils catmullVertexRows(const CatmullLevel& l)
{
    const EdgeRings rings(l.vertices, l.edges);
    const FacesAt facesAt(l);
    const CreaseRows creases(l.vertices, l.edges.size(), l.creases, l.sharp);
    Stencils rows;
    const auto addFace = [&](uint32_t f, double w) {
        const uint32_t first = l.firstCorner(f), end = l.firstCorner(f + 1);
        for (uint32_t c = first; c < end; ++c) rows.add(l.vertex[c], w / double(end - first));
    };
    for (uint32_t v = 0; v < l.vertices; ++v) {
        const auto ring = rings.of(v);
        const uint32_t first = facesAt.start[v], end = facesAt.start[v + 1];
        const CatmullLevel::Irregular i{v, uint32_t(ring.size()), end - first};
        const double w = ringWeight(i), smooth = creases.smoothShare(v);
        rows.add(v, smooth * (1 - double(i.edges + i.faces) * w) + creases.own(v));
        if (smooth > 0) {
            for (const uint32_t e : ring) rows.add(otherEnd(l.edges[e], v), smooth * w);
            for (uint32_t k = first; k < end; ++k) addFace(facesAt.face[k], smooth * w);
        }
        creases.addSides(v, rows);
        rows.endRow();
    }
    for (uint32_t e = 0; e < l.edges.size(); ++e) {
        const CatmullLevel::Edge& k = l.edges[e];
        const double smooth = creases.smoothShareOfEdge(e);
        rows.add(k.a, 0.5 - 0.25 * smooth);
        rows.add(k.b, 0.5 - 0.25 * smooth);
        if (smooth > 0) addFace(k.f, 0.25 * smooth), addFace(k.g, 0.25 * smooth);
        rows.endRow();
    }
    for (uint32_t f = 0; f < l.faces(); ++f) {
        addFace(f, 1);
        rows.endRow();
    }
    return rows;
}

}  // namespace mw
