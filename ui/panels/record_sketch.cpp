// What the Records panel draws into the view: half-edges as arrows set inwards, letters as in the book's figures, answers in colours.
#include <glm/geometric.hpp>

#include "core/mesh/normals.h"
#include "core/mesh/select.h"
#include "core/mesh/triangle_adjacency.h"
#include "render/colors.h"
#include "ui/panels/record_tables.h"

namespace mw {

namespace {

using To = RecordLink::To;

constexpr size_t labelledUpTo = 24;  // elements of an answer that get their handles written beside them
constexpr size_t arrowsUpTo = 64;    // sides of one face that are drawn

glm::vec4 colour(Role role)
{
    return glm::vec4(roleColor(role), 1);
}

/// Draws at one place of one mesh.
class Drawing {
public:
    Drawing(const RecordMesh& m, NodeId node, const glm::dmat4& world) : m_(m), node_(node), world_(world) {}
    ViewState::Sketch sketch;

    void halfedges(const RecordPlace& place);
    void wingedEdge(uint32_t edge);
    void faceBased(uint32_t face);
    void primitive(uint32_t face);
    void mark(const ElementSet& elements, glm::vec4 color);
    void name(const ElementSet& elements, size_t i, glm::vec4 color);

private:
    glm::dvec3 at(uint32_t v) const { return glm::dvec3(world_ * glm::dvec4(m_.mesh.positions()[v], 1)); }
    glm::dvec3 centreOf(uint32_t face) const;
    glm::dvec3 middle(uint32_t h) const { return 0.5 * (at(m_.walk.source(h)) + at(m_.walk.target(h))); }
    glm::dvec3 inwards(uint32_t h, glm::dvec3 p, double share) const;
    void arrow(uint32_t h, glm::vec4 color, float width, const std::string& text);
    void line(uint32_t edge, glm::vec4 color, const std::string& text);
    void label(glm::dvec3 p, std::string text, glm::vec4 color) { sketch.labels.push_back({glm::vec3(p), std::move(text), color}); }
    void vertex(uint32_t v, glm::vec4 color, const std::string& text);

    const RecordMesh& m_;
    NodeId node_;
    glm::dmat4 world_;
};

glm::dvec3 Drawing::centreOf(uint32_t face) const
{
    glm::dvec3 sum(0);
    for (const uint32_t v : m_.mesh.face(face)) sum += at(v);
    return sum / double(m_.mesh.face(face).size());
}

/// A point of a half-edge set into its face; at the boundary, where there is none, out of the face beyond.
glm::dvec3 Drawing::inwards(uint32_t h, glm::dvec3 p, double share) const
{
    const uint32_t face = m_.walk.face(h), beyond = m_.walk.face(m_.walk.pair(h));
    if (face != none) return p + share * (centreOf(face) - p);
    return beyond == none ? p : p - 0.5 * share * (centreOf(beyond) - p);
}

void Drawing::arrow(uint32_t h, glm::vec4 color, float width, const std::string& text)
{
    const glm::dvec3 a0 = at(m_.walk.source(h)), b0 = at(m_.walk.target(h));
    const glm::dvec3 a = inwards(h, a0 + 0.1 * (b0 - a0), 0.16), b = inwards(h, b0 - 0.1 * (b0 - a0), 0.16);
    const glm::dvec3 into = inwards(h, middle(h), 0.3) - 0.5 * (a + b);
    const glm::dvec3 side = glm::length(into) > 0 ? glm::normalize(into) : glm::dvec3(0), back = 0.16 * (b - a),
                     wide = 0.07 * glm::length(b - a) * side;
    const auto stroke = [&](glm::dvec3 from, glm::dvec3 to) { sketch.points.push_back({glm::vec3(from), color, width, glm::vec3(to), false, true}); };
    stroke(a, b);
    stroke(b - back + wide, b);
    stroke(b - back - wide, b);
    if (!text.empty()) label(inwards(h, middle(h), 0.36), text, color);
}

void Drawing::line(uint32_t edge, glm::vec4 color, const std::string& text)
{
    const uint32_t h = 2 * edge;
    sketch.points.push_back({glm::vec3(at(m_.walk.source(h))), color, 3, glm::vec3(at(m_.walk.target(h))), false, true});
    label(middle(h), text, color);
}

void Drawing::vertex(uint32_t v, glm::vec4 color, const std::string& text)
{
    sketch.points.push_back({glm::vec3(at(v)), color, 9, std::nullopt, false, true});
    label(at(v), text, color);
}

/// Figures 2.10 and 2.11: PQ, what its record names, and the other half-edges of the two faces.
void Drawing::halfedges(const RecordPlace& place)
{
    const HalfedgeWalk& w = m_.walk;
    const uint32_t h = place.halfedge, pair = w.pair(h);
    for (const uint32_t start : {h, pair}) {
        if (w.face(start) == none || m_.mesh.face(w.face(start)).size() > arrowsUpTo) continue;
        for (uint32_t g = w.next(start); g != start; g = w.next(g))
            if (g != w.next(h) && g != w.prev(h) && g != pair && g != h) arrow(g, glm::vec4(0.62f, 0.66f, 0.71f, 1), 1.5f, {});
    }
    arrow(w.prev(h), colour(Role::Neighbour), 2.5f, "a: prev");
    if (w.next(h) != w.prev(h)) arrow(w.next(h), colour(Role::New), 2.5f, "b: next");
    arrow(pair, colour(Role::Rejected), 2.5f, "QP: pair");
    arrow(h, colour(Role::Current), 3.5f, "PQ");
    vertex(w.source(h), glm::vec4(1), "P");
    vertex(w.target(h), glm::vec4(1), "Q: vert");
    if (w.face(h) != none) label(centreOf(w.face(h)), "L: face", glm::vec4(1));
    if (w.face(pair) != none) label(centreOf(w.face(pair)), "R", glm::vec4(1));
}

/// Figure 2.9.
void Drawing::wingedEdge(uint32_t edge)
{
    const HalfedgeWalk& w = m_.walk;
    const Record r = wingedEdgeRecord(w, edge);
    for (const Record::Field& f : r.fields) {
        const bool before = f.name.ends_with("prev");
        if (f.link.to == To::Edge) line(f.link.index, colour(before ? Role::Neighbour : Role::New), f.label + ": " + f.name);
        if (f.link.to == To::Face) label(centreOf(f.link.index), f.label, glm::vec4(1));
        if (f.link.to == To::Vertex) vertex(f.link.index, glm::vec4(1), f.label);
    }
    const glm::dvec3 p = at(w.source(2 * edge)), q = at(w.target(2 * edge));
    sketch.points.push_back({glm::vec3(p), colour(Role::Current), 4, glm::vec3(q), false, true});
    // An arrow head in the middle: from P to Q.
    const uint32_t face = w.face(2 * edge) == none ? w.face(2 * edge + 1) : w.face(2 * edge);
    glm::dvec3 side = face == none ? glm::dvec3(0) : centreOf(face) - 0.5 * (p + q);
    if (glm::length(side) > 0) side = glm::normalize(side) * 0.07 * glm::length(q - p);
    for (const double sign : {1., -1.})
        sketch.points.push_back({glm::vec3(p + 0.42 * (q - p) + sign * side), colour(Role::Current), 4, glm::vec3(p + 0.58 * (q - p)), false, true});
}

/// Figure 2.7: a triangle, its vertices and its neighbours.
void Drawing::faceBased(uint32_t face)
{
    const Record r = faceRecord(m_.walk, m_.mesh, face);
    ElementSet neighbours{ElementKind::Face, {}};
    mark({ElementKind::Face, {face}}, glm::vec4(roleColor(Role::Current), 0.35f));
    for (const Record::Field& f : r.fields) {
        if (f.link.to == To::Vertex) vertex(f.link.index, glm::vec4(1), f.name);
        if (f.link.to != To::Face) continue;
        neighbours.indices.push_back(f.link.index);
        label(centreOf(f.link.index), f.name, colour(Role::Neighbour));
    }
    mark(sorted(neighbours), glm::vec4(roleColor(Role::Neighbour), 0.35f));
}

/// Figures 2.14 and 2.15. Where a neighbour is missing the repeated vertex is written beyond the side, and the side is dashed.
void Drawing::primitive(uint32_t face)
{
    const auto six = adjacencyOf(m_.walk, m_.mesh, face);
    if (!six) return;
    const auto segment = [&](uint32_t a, uint32_t b, glm::vec4 c, float width, bool dashed) {
        sketch.points.push_back({glm::vec3(at(a)), c, width, glm::vec3(at(b)), dashed, true});
    };
    mark({ElementKind::Face, {face}}, glm::vec4(roleColor(Role::Current), 0.3f));
    for (size_t k = 0; k < 6; k += 2) {
        const uint32_t from = (*six)[k], beyond = (*six)[k + 1], to = (*six)[(k + 2) % 6];
        const bool missing = beyond == from;
        segment(from, to, colour(missing ? Role::Rejected : Role::Current), 3, missing);
        vertex(from, colour(Role::Current), "V" + std::to_string(k));
        const std::string name = "V" + std::to_string(k + 1);
        if (missing) {
            const glm::dvec3 side = 0.5 * (at(from) + at(to));
            label(side + 0.6 * (side - centreOf(face)), name + " = V" + std::to_string(k) + ": none", colour(Role::Rejected));
            continue;
        }
        segment(from, beyond, colour(Role::Neighbour), 2, false);
        segment(beyond, to, colour(Role::Neighbour), 2, false);
        vertex(beyond, colour(Role::Neighbour), name);
    }
}

void Drawing::mark(const ElementSet& elements, glm::vec4 color)
{
    if (elements.indices.empty()) return;
    Mark mark;
    mark.node = node_;
    mark.kind = elements.kind;
    mark.indices = elements.indices;
    mark.color = color;
    mark.width = elements.kind == ElementKind::Vertex ? 10.f : 4.f;
    mark.through = elements.kind != ElementKind::Face;
    sketch.marks.push_back(std::move(mark));
}

void Drawing::name(const ElementSet& elements, size_t i, glm::vec4 color)
{
    if (elements.kind == ElementKind::Edge) {
        const uint32_t a = elements.indices[2 * i], b = elements.indices[2 * i + 1];
        const RecordPlace place = placeOfEdge(m_.walk, a, b);
        if (place.halfedge != none) label(0.5 * (at(a) + at(b)), handleOf({To::Edge, place.halfedge / 2}).toStdString(), color);
        return;
    }
    const uint32_t e = elements.indices[i];
    const bool isFace = elements.kind == ElementKind::Face;
    label(isFace ? centreOf(e) : at(e), handleOf({isFace ? To::Face : To::Vertex, e}).toStdString(), color);
}

}  // namespace

ViewState::Sketch sketchOf(const RecordMesh& m, const RecordPlace& place, RecordDrawing drawing, NodeId node, const glm::dmat4& world)
{
    Drawing d(m, node, world);
    if (drawing == RecordDrawing::Halfedge && place.halfedge != none) d.halfedges(place);
    if (drawing == RecordDrawing::WingedEdge && place.halfedge != none) d.wingedEdge(m.walk.ofEdge(place.halfedge));
    if (drawing == RecordDrawing::FaceBased && place.face != none) d.faceBased(place.face);
    if (drawing == RecordDrawing::Primitive && place.face != none) d.primitive(place.face);
    return std::move(d.sketch);
}

ViewState::Sketch sketchOfAnswer(const RecordMesh& m, RecordLink asked, const ElementSet& answer, NodeId node, const glm::dmat4& world)
{
    Drawing d(m, node, world);
    const auto tone = [](Role role, ElementKind kind) { return glm::vec4(roleColor(role), kind == ElementKind::Face ? 0.55f : 1.f); };
    const ElementSet own = elementsOf(m, asked);
    // Red and blue, as in table 2.1. What is asked about lies on top.
    d.mark(answer, tone(Role::Neighbour, answer.kind));
    d.mark(own, tone(Role::Removed, own.kind));
    const size_t n = countOf(answer);
    for (size_t i = 0; i < n && n <= labelledUpTo; ++i) d.name(answer, i, colour(Role::Neighbour));
    if (countOf(own) == 1) d.name(own, 0, colour(Role::Removed));
    return std::move(d.sketch);
}

}  // namespace mw
