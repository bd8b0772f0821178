// OpenMesh's connectivity filled in bulk. Its own add_face searches and resizes for every element; here one library call sizes everything, and
// the rest is inline functions of its headers. Edges and half-edges get the numbers that add_face would give them.
#include "core/mesh/halfedge.h"

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <algorithm>

#include "core/error.h"
#include "core/mesh/connectivity.h"

namespace mw {

namespace {

using HH = OpenMesh::HalfedgeHandle;
using VH = OpenMesh::VertexHandle;
using FH = OpenMesh::FaceHandle;

HH halfedge(uint32_t h)
{
    return HH(int(h));
}

VH vertex(uint32_t v)
{
    return VH(int(v));
}

/// One phase a function, called in order by run().
class Builder {
public:
    Builder(const Mesh& mesh, HalfedgeView& view)
        : view_(view),
          kernel_(view.kernel),
          start_(mesh.faceStart().data()),
          at_(mesh.cornerVertex().data()),
          vertices_(uint32_t(mesh.vertexCount())),
          corners_(uint32_t(mesh.cornerCount())),
          faces_(uint32_t(mesh.faceCount()))
    {}
    void run(const Mesh& mesh);

private:
    void chooseFaces(const Mesh& mesh);
    void numberSides(const Mesh& mesh);
    void fillFaces();
    void joinFans();
    void splitVertices();
    void markFirstFans(std::vector<bool>& seen);
    template <class Visit>
    uint32_t walkFan(uint32_t h, const Visit& visit);
    /// body(view face, first corner, last corner) for all faces of the view.
    template <class Body>
    void forFaces(const Body& body) const;

    HalfedgeView& view_;
    OpenMesh::PolyConnectivity& kernel_;
    const uint32_t *start_, *at_;
    uint32_t vertices_, corners_, faces_;
    std::vector<uint8_t> degenerate_;
    uint32_t keptCorners_ = 0, edges_ = 0, fanCorners_ = 0;
    /// The next half-edge round the vertex that one leaves; none for those of the boundary. Walks go over these 4 bytes a half-edge and not over
    /// the 32 of an edge in the kernel.
    Array<uint32_t> turn_;
};

template <class Body>
void Builder::forFaces(const Body& body) const
{
    if (view_.payloadFace.empty()) {
        for (uint32_t f = 0; f < faces_; ++f) body(f, start_[f], start_[f + 1] - 1);
    } else {
        for (uint32_t f = 0; f < view_.payloadFace.size(); ++f) body(f, start_[view_.payloadFace[f]], start_[view_.payloadFace[f] + 1] - 1);
    }
}

/// Degenerate faces stay out; a face map exists only then.
void Builder::chooseFaces(const Mesh& mesh)
{
    keptCorners_ = corners_;
    degenerate_ = degenerateFacesOf(mesh);
    if (degenerate_.empty()) return;
    for (uint32_t f = 0; f < faces_; ++f) {
        if (!degenerate_[f]) {
            view_.payloadFace.push_back(f);
        } else {
            ++view_.degenerateFaces;
            keptCorners_ -= start_[f + 1] - start_[f];
        }
    }
    if (view_.payloadFace.empty()) faces_ = 0;  // an empty map means: all faces
}

/// An edge gets its number at its first corner; half-edge 2e leaves that corner. A later corner that runs the other way takes the side 2e+1 of
/// the oldest edge still open there. Who finds no open edge (a third face, a neighbour of the same direction) gets a new edge of its own.
void Builder::numberSides(const Mesh& mesh)
{
    const Array<uint32_t> opposite = oppositeCornersOf(mesh, degenerate_);
    view_.cornerHalfedge.resize(corners_);
    if (view_.degenerateFaces > 0) std::fill(view_.cornerHalfedge.begin(), view_.cornerHalfedge.end(), none);
    uint32_t* side = view_.cornerHalfedge.data();
    uint32_t edges = 0;
    forFaces([&](uint32_t, uint32_t first, uint32_t last) {
        for (uint32_t c = first; c <= last; ++c) side[c] = opposite[c] < c ? side[opposite[c]] + 1 : 2 * edges++;
    });
    edges_ = edges;
    view_.boundaryEdges = 2 * edges - keptCorners_;
}

/// resize() leaves every handle invalid, so boundary half-edges have no face and lone vertices no half-edge already.
void Builder::fillFaces()
{
    const uint32_t* side = view_.cornerHalfedge.data();
    const size_t viewFaces = view_.payloadFace.empty() ? faces_ : view_.payloadFace.size();
    kernel_.resize(vertices_, edges_, viewFaces);
    turn_.assign(2 * size_t(edges_), none);
    forFaces([&](uint32_t f, uint32_t first, uint32_t last) {
        const FH face{int(f)};
        uint32_t h = side[last], from = at_[last];
        kernel_.set_halfedge_handle(face, halfedge(h));  // as add_face: circulating starts at the payload's first corner
        for (uint32_t c = first; c <= last; ++c) {       // h runs from `from` to the vertex of corner c
            const uint32_t to = at_[c], next = side[c];
            if (!(h & 1)) {  // both ends by the owner of the even side, so the boundary needs no list
                kernel_.set_vertex_handle(halfedge(h), vertex(to));
                kernel_.set_vertex_handle(halfedge(h ^ 1), vertex(from));
            }
            kernel_.set_face_handle(halfedge(h), face);
            kernel_.set_next_halfedge_handle(halfedge(h), halfedge(next));  // also prev
            turn_[next] = h ^ 1;
            from = to;
            h = next;
        }
    });
}

/// Round a vertex from the outgoing half-edge h of a face, through all faces of its fan: visit(outgoing half-edge). Where the fan ends at the
/// boundary, the boundary half-edges into and out of the vertex are joined. Gives the half-edge the vertex should have (boundary first).
template <class Visit>
uint32_t Builder::walkFan(uint32_t h, const Visit& visit)
{
    uint32_t g = h;
    do {
        visit(g);
        g = turn_[g];
    } while (g != h && turn_[g] != none);
    if (g == h) return h;
    uint32_t into = h ^ 1;
    while (!kernel_.is_boundary(halfedge(into))) {
        const uint32_t o = uint32_t(kernel_.next_halfedge_handle(halfedge(into)).idx());
        visit(o);
        into = o ^ 1;
    }
    kernel_.set_next_halfedge_handle(halfedge(into), halfedge(g));
    return g;
}

/// Once round every vertex, in the order of corners so that what is walked lies together. Counts corners, to find further fans.
void Builder::joinFans()
{
    const uint32_t* side = view_.cornerHalfedge.data();
    uint32_t seen = 0;
    forFaces([&](uint32_t, uint32_t first, uint32_t last) {
        for (uint32_t c = first; c <= last; ++c) {
            const VH v = vertex(at_[c]);
            if (!kernel_.halfedge_handle(v).is_valid()) kernel_.set_halfedge_handle(v, halfedge(walkFan(side[c], [&](uint32_t) { ++seen; })));
        }
    });
    fanCorners_ = seen;
}

void Builder::markFirstFans(std::vector<bool>& seen)
{
    for (uint32_t v = 0; v < vertices_; ++v) {
        const HH start = kernel_.halfedge_handle(vertex(v));
        if (!start.is_valid()) continue;
        uint32_t h = uint32_t(start.idx());
        if (kernel_.is_boundary(start)) h = uint32_t(kernel_.next_halfedge_handle(halfedge(h ^ 1)).idx());  // one with a face
        walkFan(h, [&](uint32_t g) { seen[g] = true; });
    }
}

/// The fan of the lowest corner keeps the vertex, each further fan gets a copy, in the order of corners.
void Builder::splitVertices()
{
    std::vector<bool> seen(2 * size_t(edges_)), split(vertices_);
    markFirstFans(seen);
    std::vector<uint32_t> heads;  // outgoing half-edge of each copy
    for (uint32_t c = 0; c < corners_; ++c) {
        const uint32_t h = view_.cornerHalfedge[c];
        if (h == none || seen[h]) continue;
        const VH copy = vertex(vertices_ + uint32_t(heads.size()));
        const uint32_t g = walkFan(h, [&](uint32_t o) {
            seen[o] = true;
            kernel_.set_vertex_handle(halfedge(o ^ 1), copy);
        });
        if (kernel_.is_boundary(halfedge(g))) kernel_.set_vertex_handle(halfedge(g ^ 1), copy);
        heads.push_back(g);
        view_.extraVertex.push_back(at_[c]);
        if (!split[at_[c]]) ++view_.splitVertices;
        split[at_[c]] = true;
    }
    kernel_.resize(vertices_ + heads.size(), edges_, kernel_.n_faces());
    for (uint32_t i = 0; i < heads.size(); ++i) kernel_.set_halfedge_handle(vertex(vertices_ + i), halfedge(heads[i]));
}

void Builder::run(const Mesh& mesh)
{
    // Handles are int, and a corner may need an edge of its own with two half-edges.
    if (vertices_ >= 1u << 31 || corners_ >= 1u << 30)
        throw Error("the mesh has more than a thousand million corners: too many for half-edges; simplify or split it");
    chooseFaces(mesh);
    numberSides(mesh);
    fillFaces();
    joinFans();
    if (fanCorners_ != keptCorners_) splitVertices();
}

}  // namespace

HalfedgeView::HalfedgeView(const Mesh& mesh) : payloadVertices(mesh.vertexCount())
{
    Builder(mesh, *this).run(mesh);
}

}  // namespace mw
