// Walking the half-edge view one half-edge at a time, in payload indices.
#include "core/mesh/halfedge_walk.h"

#include <algorithm>

#include "core/mesh/halfedge.h"

namespace mw {

namespace {

OpenMesh::HalfedgeHandle handle(uint32_t h)
{
    return OpenMesh::HalfedgeHandle(int(h));
}

}  // namespace

HalfedgeWalk::HalfedgeWalk(const Mesh& mesh) : mesh_(mesh), view_(mesh_.halfedges())
{
    for (size_t i = 0; i < view_.extraVertex.size(); ++i) copies_.emplace_back(view_.extraVertex[i], uint32_t(view_.payloadVertices + i));
    std::sort(copies_.begin(), copies_.end());
}

size_t HalfedgeWalk::size() const
{
    return view_.kernel.n_halfedges();
}

uint32_t HalfedgeWalk::next(uint32_t h) const
{
    return uint32_t(view_.kernel.next_halfedge_handle(handle(h)).idx());
}

uint32_t HalfedgeWalk::prev(uint32_t h) const
{
    return uint32_t(view_.kernel.prev_halfedge_handle(handle(h)).idx());
}

uint32_t HalfedgeWalk::target(uint32_t h) const
{
    return view_.vertexOf(uint32_t(view_.kernel.to_vertex_handle(handle(h)).idx()));
}

uint32_t HalfedgeWalk::face(uint32_t h) const
{
    const auto f = view_.kernel.face_handle(handle(h));
    return f.is_valid() ? view_.faceOf(uint32_t(f.idx())) : none;
}

uint32_t HalfedgeWalk::ofFace(uint32_t face) const
{
    uint32_t f = face;
    if (view_.kernel.n_faces() == 0) return none;
    if (!view_.payloadFace.empty()) {
        const auto i = std::lower_bound(view_.payloadFace.begin(), view_.payloadFace.end(), face);
        if (i == view_.payloadFace.end() || *i != face) return none;
        f = uint32_t(i - view_.payloadFace.begin());
    }
    return uint32_t(view_.kernel.halfedge_handle(OpenMesh::FaceHandle(int(f))).idx());
}

uint32_t HalfedgeWalk::ofVertex(uint32_t vertex) const
{
    const auto h = view_.kernel.halfedge_handle(OpenMesh::VertexHandle(int(vertex)));
    return h.is_valid() ? uint32_t(h.idx()) : none;
}

std::vector<uint32_t> HalfedgeWalk::fans(uint32_t vertex) const
{
    std::vector<uint32_t> out;
    if (const uint32_t h = ofVertex(vertex); h != none) out.push_back(h);
    for (auto i = std::lower_bound(copies_.begin(), copies_.end(), std::pair(vertex, 0u)); i != copies_.end() && i->first == vertex; ++i)
        out.push_back(ofVertex(i->second));
    return out;
}

std::vector<uint32_t> HalfedgeWalk::between(uint32_t a, uint32_t b) const
{
    std::vector<uint32_t> out;
    for (const uint32_t first : fans(a)) {
        uint32_t h = first;
        do {
            if (target(h) == b) out.push_back(h);
            h = next(pair(h));
        } while (h != first);
    }
    const size_t n = out.size();
    for (size_t i = 0; i < n; ++i) out.push_back(pair(out[i]));
    return out;
}

std::vector<uint32_t> HalfedgeWalk::leftOut() const
{
    std::vector<uint32_t> out;
    if (view_.degenerateFaces == 0) return out;
    size_t kept = 0;
    for (uint32_t f = 0; f < mesh_.faceCount(); ++f) {
        if (kept < view_.payloadFace.size() && view_.payloadFace[kept] == f)
            ++kept;
        else
            out.push_back(f);
    }
    return out;
}

}  // namespace mw
