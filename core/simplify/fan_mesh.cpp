#include "core/simplify/fan_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/simplify/collapse_mesh.h"

namespace mw {

FanMesh::FanMesh(Mesh input, bool watched) : input_(std::move(input)), watched_(watched)
{
    const CollapseMesh tables(input_, {}, false);
    const size_t corners = 3 * tables.faceSlots();
    vertex_.resize(corners), twin_.resize(corners), corner_.resize(corners), face_.resize(tables.faceSlots());
    any_.assign(tables.vertexSlots(), none);
    const Mesh::Triangulation& cut = input_.triangulation();
    for (uint32_t h = uint32_t(corners); h-- > 0;) {
        vertex_[h] = tables.from(h);
        twin_[h] = tables.twin(h);
        corner_[h] = cut.corners[h];
        any_[vertex_[h]] = h;
        if (twin_[h] == none || twin_[h] > h) ++edges_;
    }
    for (uint32_t f = 0; f < face_.size(); ++f) face_[f] = cut.faces[f];
    for (uint32_t v = 0; v < tables.vertexSlots(); ++v) {
        at_.push_back(tables.at(v));
        const bool free = tables.kind(v) == CollapseMesh::Free && any_[v] != none, curve = tables.kind(v) == CollapseMesh::Curve;
        place_.push_back(free ? Place::Inside : curve ? Place::Border : Place::Fixed);
        odd_.push_back(tables.kind(v) == CollapseMesh::Locked);
    }
    // A curve of two edges is a border where the fan is open, else a seam passes through.
    std::vector<uint8_t> border(place_.size(), 0);
    for (uint32_t h = 0; h < corners; ++h)
        if (twin_[h] == none) border[from(h)] = border[to(h)] = 1;
    for (size_t v = 0; v < place_.size(); ++v)
        if (place_[v] == Place::Border && !border[v]) place_[v] = Place::Fixed;
    const Bounds box = input_.bounds();
    centre_ = box.centre();
    scale_ = box.diagonal() > 0 ? box.diagonal() : 1;
    alive_.assign(at_.size(), 1);
    vertices_ = at_.size();
    faces_ = face_.size();
    findCreases();
    if (!watched_) return;
    vertexRank_ = LiveRank(vertices_);
    faceRank_ = LiveRank(faces_);
}

// A corner's value belongs to the side of the polygon that leaves it; sides made by cutting have none.
void FanMesh::findCreases()
{
    if (!input_.find(names::crease, Domain::Corner)) return;
    crease_.assign(vertex_.size(), none);
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        const uint32_t c = corner_[h], first = input_.faceStart()[face_[h / 3]], end = input_.faceStart()[face_[h / 3] + 1];
        if (corner_[next(h)] == (c + 1 == end ? first : c + 1)) crease_[h] = c;
    }
}

glm::dvec3 FanMesh::areaNormal(uint32_t face) const
{
    const glm::dvec3& a = at_[vertex_[3 * face]];
    return glm::cross(at_[vertex_[3 * face + 1]] - a, at_[vertex_[3 * face + 2]] - a);
}

bool FanMesh::fan(uint32_t v, VertexFan& out) const
{
    out.ring.clear(), out.outline.clear();
    out.open = false;
    const uint32_t any = any_[v];
    if (any == none) return false;
    uint32_t first = any;  // at the border the one without a face on its right
    size_t steps = 0;
    while (twin_[first] != none) {
        first = next(twin_[first]);
        if (first == any) break;
        if (++steps > most) return false;
    }
    uint32_t h = first;
    do {
        if (out.outline.size() >= most) return false;
        out.ring.push_back(to(h));
        out.outline.push_back(next(h));
        const uint32_t last = prev(h);
        h = twin_[last];
        if (h != none) continue;
        out.open = true;
        out.ring.push_back(from(last));
    } while (h != none && h != first);
    return true;
}

bool FanMesh::joined(uint32_t a, uint32_t b) const
{
    if (odd_[a] && odd_[b]) return true;
    if (odd_[a]) std::swap(a, b);
    VertexFan f;
    return !fan(a, f) || std::find(f.ring.begin(), f.ring.end(), b) != f.ring.end();
}

void FanMesh::open(uint32_t v, const VertexFan& fan)
{
    free_.clear(), holeTwin_.clear(), holeCorner_.clear(), holeCrease_.clear(), holeFace_.clear();
    for (const uint32_t side : fan.outline) {
        free_.push_back(side / 3);
        holeTwin_.push_back(twin_[side]);
        holeCorner_.push_back(corner_[side]);
        holeCrease_.push_back(crease_.empty() ? none : crease_[side]);
        holeFace_.push_back(face_[side / 3]);
    }
    if (fan.open) holeCorner_.push_back(corner_[next(fan.outline.back())]);
    for (const uint32_t side : fan.outline) {
        const uint32_t g = twin_[side];
        if (g != none) {
            twin_[g] = none;
            any_[from(g)] = g;
            any_[to(g)] = next(g);
        }
    }
    for (const uint32_t f : free_) {
        vertex_[3 * f] = none;
        if (watched_) faceRank_.remove(f);
    }
    faces_ -= free_.size();
    edges_ -= fan.ring.size();
    any_[v] = none;
    alive_[v] = 0;
    --vertices_;
    if (watched_) vertexRank_.remove(v);
}

// Half-edge h runs from place i of the ring to place j: along the outline, or against another new one.
void FanMesh::link(uint32_t h, uint32_t i, uint32_t j, const VertexFan& fan, std::vector<std::array<uint32_t, 3>>& waiting)
{
    twin_[h] = none;
    if (!crease_.empty()) crease_[h] = none;
    if (j == (i + 1) % fan.ring.size()) {
        if (i >= fan.outline.size()) {  // the new border
            ++edges_;
            return;
        }
        twin_[h] = holeTwin_[i];
        if (holeTwin_[i] != none) twin_[holeTwin_[i]] = h;
        if (!crease_.empty()) crease_[h] = holeCrease_[i];
        return;
    }
    const auto other = std::find_if(waiting.begin(), waiting.end(), [&](const auto& w) { return w[0] == j && w[1] == i; });
    if (other == waiting.end()) {
        waiting.push_back({i, j, h});
        ++edges_;
        return;
    }
    twin_[h] = (*other)[2];
    twin_[(*other)[2]] = h;
}

void FanMesh::close(const VertexFan& fan, const std::vector<Triple>& triangles)
{
    std::vector<std::array<uint32_t, 3>> waiting;  // from, to, half-edge
    const auto n = uint32_t(fan.ring.size());
    for (size_t t = 0; t < triangles.size(); ++t) {
        const uint32_t f = free_[t];
        size_t source = 0;
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t h = 3 * f + uint32_t(k), i = triangles[t][k], j = triangles[t][(k + 1) % 3];
            vertex_[h] = fan.ring[i];
            corner_[h] = holeCorner_[i];
            any_[fan.ring[i]] = h;
            if (j == (i + 1) % n && i < fan.outline.size()) source = i;
            link(h, i, j, fan, waiting);
        }
        face_[f] = holeFace_[source];
        if (watched_) faceRank_.add(f);
    }
    faces_ += triangles.size();
}

Attribute FanMesh::carriedCreases(const Attribute& a, const std::vector<uint32_t>& halfEdges) const
{
    Array<float> values;
    for (const uint32_t h : halfEdges) values.push_back(crease_[h] == none ? 0.f : float(a.at(crease_[h], 0)));
    return floatAttribute(a.name, Domain::Corner, 1, std::move(values));
}

Mesh FanMesh::payload() const
{
    std::vector<uint32_t> kept, number(at_.size(), none), halfEdges, corners, faces;
    Array<glm::vec3> positions;
    for (uint32_t v = 0; v < at_.size(); ++v) {
        if (!alive_[v]) continue;
        number[v] = uint32_t(kept.size());
        kept.push_back(v);
        positions.push_back(input_.positions()[v]);
    }
    Array<uint32_t> triangles, lines;
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        if (vertex_[h - h % 3] == none) continue;
        triangles.push_back(number[vertex_[h]]);
        halfEdges.push_back(h);
        corners.push_back(corner_[h]);
        if (h % 3 == 0) faces.push_back(face_[h / 3]);
    }
    Mesh mesh = Mesh::triangles(std::move(positions), std::move(triangles)).withGroupNames(input_.groupNames());
    for (const uint32_t v : input_.lines()) lines.push_back(number[v]);
    if (!lines.empty()) mesh = mesh.withLines(std::move(lines));
    for (const Attribute& a : input_.attributes()) {
        if (a.domain == Domain::Corner && a.name == names::crease)
            mesh = mesh.with(carriedCreases(a, halfEdges));
        else
            mesh = mesh.with(gathered(a, a.domain == Domain::Vertex ? kept : a.domain == Domain::Corner ? corners : faces));
    }
    return mesh;
}

}  // namespace mw
