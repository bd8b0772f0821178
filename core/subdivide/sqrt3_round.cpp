// Tables of a round.
#include "core/subdivide/sqrt3_round.h"

#include <cmath>
#include <numbers>

#include "core/subdivide/carried.h"
#include "core/subdivide/edge_rings.h"

namespace mw {

namespace {

constexpr uint32_t next(uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// The neighbours along sharp edges of the vertices that have two of them.
Array<Ends> neighboursAlong(size_t vertices, const FaceEdges& edges, const std::vector<uint8_t>& sharp)
{
    Array<Ends> along(vertices, Ends{none, none});
    std::vector<uint8_t> count(vertices, 0);
    for (uint32_t e = 0; e < edges.size(); ++e) {
        if (!sharp[e]) continue;
        for (const auto& [v, other] : {std::pair(edges.ends[e].a, edges.ends[e].b), std::pair(edges.ends[e].b, edges.ends[e].a)}) {
            if (count[v] == 0) along[v].a = other;
            if (count[v] == 1) along[v].b = other;
            count[v] = uint8_t(std::min(count[v] + 1, 3));
        }
    }
    for (uint32_t v = 0; v < vertices; ++v) {
        if (count[v] == 1) along[v] = {none, none};  // the end of a crease
        if (count[v] == 3) along[v] = {v, none};
    }
    return along;
}

}  // namespace

double sqrt3Weight(size_t n)
{
    return (4 - 2 * std::cos(2 * std::numbers::pi / double(n))) / 9;
}

Sqrt3Round::Sqrt3Round(Mesh triangleMesh, bool cutsSharpEdges)
    : mesh(std::move(triangleMesh)),
      cutsSharp(cutsSharpEdges),
      edges(faceEdgesOf(mesh, creaseOf(mesh), 1)),
      sharp(edges.size(), 0),
      centre(mesh.faceCount(), none),
      firstOnSharp(edges.size(), none)
{
    for (const SharpEdge& s : edges.sharp) sharp[s.edge] = s.sharpness == alwaysSharp;
    along_ = neighboursAlong(mesh.vertexCount(), edges, sharp);
    uint32_t vertices = uint32_t(mesh.vertexCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        bool cut = false;
        for (uint32_t c = 3 * f; c < 3 * f + 3; ++c) cut = cut || (cutsSharp && sharp[edges.half[c] >> 1]);
        if (!cut) centre[f] = vertices++, ++centres_;
    }
    for (uint32_t e = 0; e < edges.size(); ++e)
        if (cutsSharp && sharp[e]) firstOnSharp[e] = vertices, vertices += 2;
    addVertexRows();
    addPieces();
    points.assign(mesh.positions().begin(), mesh.positions().end());
    for (uint32_t v = uint32_t(mesh.vertexCount()); v < vertices; ++v) {
        glm::dvec3 p(0);
        for (uint32_t i = rows.start[v]; i < rows.start[v + 1]; ++i) p += double(rows.weight[i]) * glm::dvec3(mesh.positions()[rows.source[i]]);
        points.emplace_back(p);
    }
}

void Sqrt3Round::addVertexRows()
{
    const EdgeRings rings(mesh.vertexCount(), edges.ends);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        const auto ring = rings.of(v);
        if (along_[v].a == none && !ring.empty()) {
            const double a = sqrt3Weight(ring.size());
            rows.add(v, 1 - a);
            for (const uint32_t e : ring) rows.add(otherEnd(edges.ends[e], v), a / double(ring.size()));
        } else if (cutsSharp && along_[v].b != none) {
            rows.add(v, 19.0 / 27);
            rows.add(along_[v].a, 4.0 / 27);
            rows.add(along_[v].b, 4.0 / 27);
        } else {
            rows.add(v, 1);
        }
        rows.endRow();
    }
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        if (centre[f] == none) continue;
        for (const uint32_t v : mesh.face(f)) rows.add(v, 1.0 / 3);
        rows.endRow();
    }
    for (uint32_t e = 0; e < edges.size(); ++e)
        if (firstOnSharp[e] != none) cutAlong(e);
}

/// Two points on a sharp edge, each by the neighbours of the end that is nearer.
void Sqrt3Round::cutAlong(uint32_t e)
{
    for (const auto& [v, other] : {std::pair(edges.ends[e].a, edges.ends[e].b), std::pair(edges.ends[e].b, edges.ends[e].a)}) {
        const bool curve = along_[v].b != none;
        rows.add(v, curve ? 16.0 / 27 : 2.0 / 3);
        rows.add(other, curve ? 10.0 / 27 : 1.0 / 3);
        if (curve) rows.add(along_[v].a == other ? along_[v].b : along_[v].a, 1.0 / 27);
        rows.endRow();
    }
}

void Sqrt3Round::addPieces()
{
    triangles.resize(9 * mesh.faceCount());
    const Shared<uint32_t>& v = mesh.cornerVertex();
    const auto put = [&](uint32_t corner, uint32_t a, uint32_t b, uint32_t apex) {
        triangles[3 * corner] = a, triangles[3 * corner + 1] = b, triangles[3 * corner + 2] = apex;
    };
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        uint32_t cut = none;
        for (uint32_t c = 3 * f; c < 3 * f + 3; ++c) {
            if (centre[f] != none) put(c, v[c], v[next(c)], centre[f]);
            if (firstOnSharp[edges.half[c] >> 1] != none) cut = c;
        }
        if (centre[f] != none) continue;
        const uint32_t half = edges.half[cut], second = next(cut), third = next(second);
        const uint32_t nearStart = firstOnSharp[half >> 1] + (half & 1), nearEnd = firstOnSharp[half >> 1] + 1 - (half & 1);
        put(cut, nearStart, nearEnd, v[third]);
        put(second, v[second], v[third], nearEnd);
        put(third, v[third], v[cut], nearStart);
    }
}

uint32_t Sqrt3Round::partner(uint32_t corner) const
{
    const uint32_t e = edges.half[corner] >> 1;
    if (sharp[e]) return none;
    return edges.corner[e].a == corner ? edges.corner[e].b : edges.corner[e].a;
}

void Sqrt3Round::flip(uint32_t e)
{
    uint32_t *one = triangles.data() + 3 * size_t(edges.corner[e].a), *two = triangles.data() + 3 * size_t(edges.corner[e].b);
    one[1] = two[2];
    two[1] = one[2];
}

glm::vec3 Sqrt3Round::relaxed(uint32_t v) const
{
    glm::dvec3 p(0);
    for (uint32_t i = rows.start[v]; i < rows.start[v + 1]; ++i) p += double(rows.weight[i]) * glm::dvec3(mesh.positions()[rows.source[i]]);
    return glm::vec3(p);
}

}  // namespace mw
