#include "core/repair/fans.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/normals.h"
#include "core/mesh/topology.h"
#include "core/repair/rebuild.h"

namespace mw {

CornerFans::CornerFans(const Mesh& mesh) : mesh_(mesh), sets_(mesh.cornerCount())
{
    if (!mesh.isTriangles()) cornerFace_ = cornerFacesOf(mesh);
}

uint32_t CornerFans::next(uint32_t c) const
{
    if (cornerFace_.empty()) return c % 3 == 2 ? c - 2 : c + 1;
    const uint32_t f = cornerFace_[c];
    return c + 1 == mesh_.faceStart()[f + 1] ? mesh_.faceStart()[f] : c + 1;
}

void CornerFans::join(uint32_t c, uint32_t d)
{
    const bool same = mesh_.cornerVertex()[c] == mesh_.cornerVertex()[d];
    sets_.join(c, same ? d : next(d));
    sets_.join(next(c), same ? next(d) : d);
}

Mesh splitAtFans(const Mesh& mesh, CornerFans& fans, const std::vector<uint8_t>& where)
{
    const Shared<uint32_t>& at = mesh.cornerVertex();
    Array<uint32_t> first(mesh.vertexCount(), none);  // the fan that keeps the vertex
    Array<uint32_t> vertexOfFan(mesh.cornerCount(), none);
    Parts parts;
    parts.vertexFrom.resize(mesh.vertexCount());
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) parts.vertexFrom[v] = v;
    parts.cornerVertex.assign(at.begin(), at.end());
    for (uint32_t c = 0; c < at.size(); ++c) {
        const uint32_t v = at[c];
        if (!where.empty() && !where[v]) continue;
        const uint32_t fan = fans.fanOf(c);
        if (first[v] == none) first[v] = fan;
        if (first[v] == fan) continue;
        if (vertexOfFan[fan] == none) {
            vertexOfFan[fan] = uint32_t(parts.vertexFrom.size());
            parts.vertexFrom.push_back(v);
        }
        parts.cornerVertex[c] = vertexOfFan[fan];
    }
    if (parts.vertexFrom.size() == mesh.vertexCount()) return mesh;
    parts.faceStart.assign(mesh.faceStart().begin(), mesh.faceStart().end());
    parts.cornerFrom.resize(mesh.cornerCount());
    for (uint32_t c = 0; c < at.size(); ++c) parts.cornerFrom[c] = c;
    parts.faceFrom.resize(mesh.faceCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) parts.faceFrom[f] = f;
    parts.lines.assign(mesh.lines().begin(), mesh.lines().end());
    return rebuilt(mesh, std::move(parts));
}

namespace {

/// The faces round one edge, by the angle at which they stand.
class FacesRoundEdge {
public:
    FacesRoundEdge(const Mesh& mesh, const Array<uint32_t>& cornerFace, uint32_t a, uint32_t b, std::span<const uint32_t> sides);
    /// Calls join(side, side) for those that stay together.
    template <class Join>
    void pair(const Join& join) const;

private:
    struct Face {
        double angle;  // of the face's plane about the edge a to b, anticlockwise
        uint32_t side;
        bool along;  // runs from a to b
    };
    std::vector<Face> faces_;
    bool balanced_ = false;
};

FacesRoundEdge::FacesRoundEdge(const Mesh& mesh, const Array<uint32_t>& cornerFace, uint32_t a, uint32_t b, std::span<const uint32_t> sides)
{
    const glm::dvec3 axis = glm::dvec3(mesh.positions()[b]) - glm::dvec3(mesh.positions()[a]);
    glm::dvec3 u(0), w(0);
    size_t along = 0;
    for (const uint32_t side : sides) {
        const bool forward = mesh.cornerVertex()[side] == a;
        const uint32_t f = cornerFace.empty() ? side / 3 : cornerFace[side];
        const glm::dvec3 inward = glm::cross(areaVector(mesh, f), forward ? axis : -axis);  // from the edge into the face
        if (u == glm::dvec3(0) && glm::length(inward) > 0) {
            u = glm::normalize(inward);
            w = glm::cross(axis, u);
            if (glm::length(w) > 0) w = glm::normalize(w);
        }
        faces_.push_back({std::atan2(glm::dot(inward, w), glm::dot(inward, u)), side, forward});
        along += forward;
    }
    balanced_ = 2 * along == sides.size();
    std::stable_sort(faces_.begin(), faces_.end(), [](const Face& x, const Face& y) { return x.angle < y.angle; });
}

template <class Join>
void FacesRoundEdge::pair(const Join& join) const
{
    std::vector<Face> left = faces_;
    // Going round anticlockwise, the inside lies behind a face that runs from b to a and ends at the next one that runs from a to b.
    for (bool found = balanced_; found && left.size() > 1;) {
        found = false;
        for (size_t i = 0; i < left.size() && !found; ++i) {
            const size_t j = (i + 1) % left.size();
            if (left[i].along || !left[j].along) continue;
            join(left[i].side, left[j].side);
            left.erase(left.begin() + long(std::max(i, j)));
            left.erase(left.begin() + long(std::min(i, j)));
            found = true;
        }
    }
    if (balanced_ || left.size() < 2) return;
    const Face *one = nullptr, *two = nullptr;
    std::pair<bool, double> best(false, -1);  // opposite directions first, then the least bend
    for (size_t i = 0; i < left.size(); ++i)
        for (size_t j = i + 1; j < left.size(); ++j) {
            const double turn = std::abs(left[i].angle - left[j].angle), flat = std::min(turn, 2 * M_PI - turn);  // pi: no bend
            const std::pair<bool, double> merit(left[i].along != left[j].along, flat);
            if (merit > best) one = &left[i], two = &left[j], best = merit;
        }
    if (one) join(one->side, two->side);
}

Mesh splitOnce(const Mesh& mesh, bool edges, bool vertices, bool cutAll)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    const EdgeSides all = edgeSidesOf(mesh, degenerate);
    const Array<uint32_t> cornerFace = mesh.isTriangles() ? Array<uint32_t>() : cornerFacesOf(mesh);
    CornerFans fans(mesh);
    std::vector<uint8_t> where;
    if (!vertices || !degenerate.empty()) where.assign(mesh.vertexCount(), uint8_t(vertices));
    for (size_t e = 0; e < all.size(); ++e) {
        const auto sides = all.sides(e);
        const uint32_t a = all.ends[2 * e], b = all.ends[2 * e + 1];
        const auto join = [&](uint32_t c, uint32_t d) { fans.join(c, d); };
        if (sides.size() <= 2 || !edges) {
            for (size_t i = 1; i < sides.size(); ++i) join(sides[0], sides[i]);
            continue;
        }
        if (!where.empty()) where[a] = where[b] = 1;
        if (!cutAll && sides.size() <= 64) FacesRoundEdge(mesh, cornerFace, a, b, sides).pair(join);
    }
    // Corners of degenerate faces hang on no edge: they stay where they are, and so does their vertex.
    for (size_t f = 0; f < degenerate.size(); ++f)
        if (degenerate[f])
            for (const uint32_t v : mesh.face(f)) where[v] = 0;
    return splitAtFans(mesh, fans, where);
}

}  // namespace

Mesh splitNonmanifold(const Mesh& mesh, bool edges, bool vertices)
{
    Mesh out = splitOnce(mesh, edges, vertices, false);
    // Faces that should part at an edge may still hang together round both its ends. Then all of them get an edge of their own there.
    for (int round = 0; edges && round < 4 && !out.topology().nonmanifoldEdges.empty(); ++round) out = splitOnce(out, edges, vertices, true);
    return out;
}

}  // namespace mw
