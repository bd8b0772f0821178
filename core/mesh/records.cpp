// Records of the three structures, all read off the half-edge view.
#include "core/mesh/records.h"

namespace mw {

namespace {

using To = RecordLink::To;

RecordLink link(To to, uint32_t index)
{
    return index == none ? RecordLink() : RecordLink{to, index};
}

/// The edge of a half-edge beside a face; nothing where there is no face, for a winged-edge record has no wings on that side.
RecordLink wing(const HalfedgeWalk& walk, uint32_t face, uint32_t halfedge)
{
    return face == none ? RecordLink() : link(To::Edge, walk.ofEdge(halfedge));
}

}  // namespace

RecordPlace placeOf(const HalfedgeWalk& walk, RecordLink of)
{
    RecordPlace p;
    switch (of.to) {
        case To::Nothing:
            return p;
        case To::Vertex:
            p.vertex = of.index;
            p.halfedge = walk.ofVertex(of.index);
            break;
        case To::Face:
            p.face = of.index;
            p.halfedge = walk.ofFace(of.index);
            break;
        case To::Edge:
            p.halfedge = 2 * of.index;
            break;
        case To::Halfedge:
            p.halfedge = of.index;
            break;
    }
    if (p.halfedge == none) return p;
    if (p.vertex == none) p.vertex = walk.source(p.halfedge);
    if (p.face == none) p.face = walk.face(p.halfedge);
    if (p.face == none) p.face = walk.face(walk.pair(p.halfedge));
    return p;
}

RecordPlace placeOfEdge(const HalfedgeWalk& walk, uint32_t from, uint32_t to)
{
    const std::vector<uint32_t> between = walk.between(from, to);
    return between.empty() ? RecordPlace() : placeOf(walk, {To::Halfedge, between[0]});
}

Record faceRecord(const HalfedgeWalk& walk, const Mesh& mesh, uint32_t face)
{
    const auto corners = mesh.face(face);
    Record r{corners.size() == 3 ? "Triangle" : "Polygon", {To::Face, face}, {}};
    for (size_t i = 0; i < corners.size(); ++i) r.fields.push_back({"p" + std::to_string(i + 1), "", {To::Vertex, corners[i]}});
    const uint32_t into = walk.ofFace(face);
    uint32_t h = into == none ? none : walk.next(into);  // leaves the first corner
    for (size_t i = 0; i < corners.size(); ++i) {
        r.fields.push_back({"t" + std::to_string(i + 1), "", h == none ? RecordLink() : link(To::Face, walk.face(walk.pair(h)))});
        if (h != none) h = walk.next(h);
    }
    return r;
}

Record wingedEdgeRecord(const HalfedgeWalk& walk, uint32_t edge)
{
    const uint32_t h = 2 * edge, g = walk.pair(h), left = walk.face(h), right = walk.face(g);
    Record r{"W_edge", {To::Edge, edge}, {}};
    r.fields = {{"start", "P", {To::Vertex, walk.source(h)}},
                {"end", "Q", {To::Vertex, walk.target(h)}},
                {"left", "L", link(To::Face, left)},
                {"right", "R", link(To::Face, right)},
                {"left_prev", "a", wing(walk, left, walk.next(h))},
                {"left_next", "b", wing(walk, left, walk.prev(h))},
                {"right_prev", "c", wing(walk, right, walk.next(g))},
                {"right_next", "d", wing(walk, right, walk.prev(g))}};
    return r;
}

Record wingedVertexRecord(const HalfedgeWalk& walk, uint32_t vertex)
{
    const uint32_t h = walk.ofVertex(vertex);
    return {"Vertex", {To::Vertex, vertex}, {{"edge", "", h == none ? RecordLink() : link(To::Edge, walk.ofEdge(h))}}};
}

Record wingedFaceRecord(const HalfedgeWalk& walk, uint32_t face)
{
    const uint32_t h = walk.ofFace(face);
    return {"Face", {To::Face, face}, {{"edge", "", h == none ? RecordLink() : link(To::Edge, walk.ofEdge(h))}}};
}

Record halfedgeRecord(const HalfedgeWalk& walk, uint32_t halfedge)
{
    Record r{"H_edge", {To::Halfedge, halfedge}, {}};
    r.fields = {{"vert", "Q", {To::Vertex, walk.target(halfedge)}},
                {"face", "L", link(To::Face, walk.face(halfedge))},
                {"prev", "a", {To::Halfedge, walk.prev(halfedge)}},
                {"next", "b", {To::Halfedge, walk.next(halfedge)}},
                {"pair", "QP", {To::Halfedge, walk.pair(halfedge)}}};
    return r;
}

Record halfedgeVertexRecord(const HalfedgeWalk& walk, uint32_t vertex)
{
    return {"Vertex", {To::Vertex, vertex}, {{"edge", "", link(To::Halfedge, walk.ofVertex(vertex))}}};
}

Record halfedgeFaceRecord(const HalfedgeWalk& walk, uint32_t face)
{
    return {"Face", {To::Face, face}, {{"edge", "", link(To::Halfedge, walk.ofFace(face))}}};
}

}  // namespace mw
