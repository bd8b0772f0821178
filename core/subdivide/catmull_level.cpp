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
    n.vertex = largeArray<uint32_t>(4 * vertex.size());
    if (!last) {
        n.half = largeArray<uint32_t>(4 * vertex.size());
        n.edges = largeArray<Edge>(2 * edges.size() + vertex.size());
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

size_t CatmullLevel::bytes() const
{
    return edges.size() * sizeof(Edge) + 4 * (faceStart.size() + vertex.size() + half.size()) + creases.size() * sizeof(SharpVertex) +
           sharp.size() * sizeof(SharpEdge) + irregular.size() * sizeof(Irregular) + 4 * fixed.size();
}

namespace {

MW_LOOP_FOR_EACH_MACHINE
void quadPoints(const uint32_t* corner, const uint32_t* end, const glm::vec3* old, glm::vec3* out, lanes::Sum* ring)
{
    for (; corner != end; corner += 4, ++out) {
        MW_LANES(a, old[corner[0]])
        MW_LANES(b, old[corner[1]])
        MW_LANES(c, old[corner[2]])
        MW_LANES(d, old[corner[3]])
        const lanes::Doubles p = 0.25 * ((MW_DOUBLES(a) + MW_DOUBLES(b)) + (MW_DOUBLES(c) + MW_DOUBLES(d)));
        const lanes::Floats rounded = MW_FLOATS(p);
        MW_PUT_POINT(*out, p)
        for (int k = 0; k < 4; ++k) ring[corner[k]].v += rounded;
    }
}

MW_LOOP_FOR_EACH_MACHINE
void edgePoints(const CatmullLevel::Edge* edge, const CatmullLevel::Edge* end, const glm::vec3* old, const glm::vec3* centre, glm::vec3* out,
                lanes::Sum* ring)
{
    for (; edge != end; ++edge, ++out) {
        MW_LANES(a, old[edge->a])
        MW_LANES(b, old[edge->b])
        MW_LANES(f, centre[edge->f])
        MW_LANES(g, centre[edge->g])
        MW_PUT_POINT(*out, 0.25 * ((MW_DOUBLES(a) + MW_DOUBLES(b)) + (MW_DOUBLES(f) + MW_DOUBLES(g))))
        ring[edge->a].v += b;
        ring[edge->b].v += a;
    }
}

MW_LOOP_FOR_EACH_MACHINE
void regularVertices(size_t n, const glm::vec3* old, const lanes::Sum* ring, glm::vec3* out)
{
    for (size_t v = 0; v < n; ++v) {
        MW_LANES(p, old[v])
        MW_PUT_POINT(out[v], 0.5 * MW_DOUBLES(p) + 0.0625 * MW_DOUBLES(ring[v].v))
    }
}

}  // namespace

CatmullPoints::CatmullPoints(const CatmullLevel& level, const Array<glm::vec3>& old)
    : points(lanes::paddedPoints(level.vertices + level.edges.size() + level.faces())),
      level_(level),
      old_(old),
      ring_(lanes::zeroSums(level.vertices))
{}

void CatmullPoints::faces(size_t first, size_t end)
{
    glm::vec3* out = points.data() + level_.vertices + level_.edges.size();
    const uint32_t* corner = level_.vertex.data();
    if (level_.faceStart.empty()) {
        quadPoints(corner + 4 * first, corner + 4 * end, old_.data(), out + first, ring_.data());
        return;
    }
    for (size_t f = first; f < end; ++f) {
        lanes::Doubles sum{};
        const uint32_t from = level_.faceStart[f], to = level_.faceStart[f + 1];
        for (uint32_t c = from; c < to; ++c) {
            MW_LANES(p, old_.data()[corner[c]])
            sum += MW_DOUBLES(p);
        }
        sum /= double(to - from);
        MW_PUT_POINT(out[f], sum)
        for (uint32_t c = from; c < to; ++c) ring_[corner[c]].v += MW_FLOATS(sum);
    }
}

void CatmullPoints::edges(size_t first, size_t end)
{
    glm::vec3* out = points.data() + level_.vertices;
    edgePoints(level_.edges.data() + first, level_.edges.data() + end, old_.data(), out + level_.edges.size(), out + first, ring_.data());
}

// All by the regular mask, without a branch; the few that differ are done over.
void CatmullPoints::vertices()
{
    const Array<glm::vec3>& old = old_.points();
    regularVertices(level_.vertices, old_.data(), ring_.data(), points.data());
    for (const CatmullLevel::Irregular& i : level_.irregular) {
        const double w = ringWeight(i);
        points[i.vertex] = glm::vec3((1 - double(i.edges + i.faces) * w) * glm::dvec3(old[i.vertex]) + w * ring_[i.vertex].point());
    }
    for (const SharpEdge& s : level_.sharp) {
        const CatmullLevel::Edge& k = level_.edges[s.edge];
        applySharp(s.sharpness, {k.a, k.b}, old, points[level_.vertices + s.edge]);
    }
    for (const SharpVertex& s : level_.creases) applySharp(s, old, points[s.vertex]);
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
