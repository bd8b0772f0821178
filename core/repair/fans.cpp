#include "core/repair/fans.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

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

constexpr size_t mostSides = 64;  // of an edge; beyond that all its faces part

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
    double best = -1;
    for (const Face& x : left)
        for (const Face& y : left) {
            const double turn = std::abs(x.angle - y.angle), flat = std::min(turn, 2 * M_PI - turn);  // pi: no bend
            if (x.along && !y.along && flat > best) one = &x, two = &y, best = flat;
        }
    if (one) join(one->side, two->side);
}

constexpr const char *vertexMark = "repair:vertex", *pieceMark = "repair:piece", *turnMark = "repair:turn";

/// What may be joined, given how things were before welding; without marks everything may.
class Before {
public:
    explicit Before(const Mesh& mesh);
    bool known() const { return !vertex_.empty(); }
    /// Sides c and d lay on one edge before.
    bool sameEdge(uint32_t c, uint32_t d) const { return edge(c) == edge(d); }
    /// Takes note of the join, unless it would make the surface one-sided or glue a face to its own back.
    bool mayJoin(uint32_t c, uint32_t d);

private:
    std::pair<int32_t, int32_t> edge(uint32_t c) const { return std::minmax(vertex_[c], vertex_[next(c)]); }
    uint32_t faceOf(uint32_t c) const { return face_[c]; }
    uint32_t next(uint32_t c) const { return c + 1 == mesh_.faceStart()[face_[c] + 1] ? mesh_.faceStart()[face_[c]] : c + 1; }

    const Mesh& mesh_;
    std::span<const int32_t> vertex_;
    Array<uint32_t> face_;
    ParityUnionFind pieces_;
};

Before::Before(const Mesh& mesh) : mesh_(mesh), pieces_(mesh.find(vertexMark) ? mesh.faceCount() : 0)
{
    const Attribute *vertex = mesh.find(vertexMark), *piece = mesh.find(pieceMark), *turn = mesh.find(turnMark);
    if (!vertex || !piece || !turn) return;
    vertex_ = vertex->integers();
    face_ = cornerFacesOf(mesh);
    std::unordered_map<int32_t, uint32_t> first;
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t g = first.emplace(piece->integers()[f], f).first->second;
        pieces_.join(f, g, turn->integers()[f] != turn->integers()[g]);
    }
}

bool Before::mayJoin(uint32_t c, uint32_t d)
{
    if (!known() || sameEdge(c, d)) return true;
    const auto f = mesh_.face(faceOf(c)), g = mesh_.face(faceOf(d));
    if (f.size() == g.size() && std::is_permutation(f.begin(), f.end(), g.begin())) return false;
    return pieces_.join(faceOf(c), faceOf(d), mesh_.cornerVertex()[c] == mesh_.cornerVertex()[d]);
}

/// Sides that lay on one edge of two faces before are joined; gives those that are left.
template <class Join>
std::vector<uint32_t> joinAsBefore(const Before& before, std::span<const uint32_t> sides, const Join& join)
{
    std::vector<uint32_t> rest;
    for (const uint32_t c : sides) {
        uint32_t partner = none;
        size_t same = 0;
        for (const uint32_t d : sides)
            if (before.known() && before.sameEdge(c, d) && ++same && d != c) partner = d;
        if (same != 2)
            rest.push_back(c);
        else if (c < partner)
            join(c, partner);
    }
    return rest;
}

/// How much of an edge of more than two faces is cut: first what cannot be told, then what was not joined before, then all.
enum class Cut { Least, New, All };

Mesh splitOnce(const Mesh& mesh, bool edges, bool vertices, Cut cut)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    const EdgeSides all = edgeSidesOf(mesh, degenerate);
    const Array<uint32_t> cornerFace = mesh.isTriangles() ? Array<uint32_t>() : cornerFacesOf(mesh);
    CornerFans fans(mesh);
    Before before(mesh);
    std::vector<uint8_t> where;
    if (!vertices || !degenerate.empty()) where.assign(mesh.vertexCount(), uint8_t(vertices));
    const auto join = [&](uint32_t c, uint32_t d) { fans.join(c, d); };
    const auto joinIfAllowed = [&](uint32_t c, uint32_t d) {
        if (before.mayJoin(c, d)) fans.join(c, d);
    };
    for (size_t e = 0; e < all.size(); ++e) {
        const auto sides = all.sides(e);
        const uint32_t a = all.ends[2 * e], b = all.ends[2 * e + 1];
        if (sides.size() <= 2 || !edges) {
            for (size_t i = 1; i < sides.size(); ++i) joinIfAllowed(sides[0], sides[i]);
            continue;
        }
        if (!where.empty()) where[a] = where[b] = 1;
        if (cut == Cut::All || sides.size() > mostSides) continue;
        const std::vector<uint32_t> rest = joinAsBefore(before, sides, join);
        if (cut == Cut::New || rest.size() < 2) continue;
        if (rest.size() == 2)
            joinIfAllowed(rest[0], rest[1]);
        else
            FacesRoundEdge(mesh, cornerFace, a, b, rest).pair(joinIfAllowed);
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
    Mesh out = splitOnce(mesh, edges, vertices, Cut::Least);
    // Faces that should part at an edge may still hang together round both its ends. Then more of it is cut.
    for (int round = 0; edges && round < 4 && !out.topology().nonmanifoldEdges.empty(); ++round)
        out = splitOnce(out, edges, vertices, round == 0 ? Cut::New : Cut::All);
    return out;
}

Mesh markedForWelding(const Mesh& mesh)
{
    if (mesh.find(vertexMark)) return mesh;  // of the whole, when this is a part of it
    const EdgeSides edges = edgeSidesOf(mesh, degenerateFacesOf(mesh));
    const Array<uint32_t> face = cornerFacesOf(mesh);
    ParityUnionFind pieces(mesh.faceCount());
    for (size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() == 2) pieces.join(face[sides[0]], face[sides[1]], mesh.cornerVertex()[sides[0]] == mesh.cornerVertex()[sides[1]]);
    }
    Array<int32_t> vertex(mesh.cornerVertex().begin(), mesh.cornerVertex().end()), piece(mesh.faceCount()), turn(mesh.faceCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const auto at = pieces.find(f);
        piece[f] = int32_t(at.to);
        turn[f] = int32_t(at.turned);
    }
    return mesh.with(integerAttribute(vertexMark, Domain::Corner, 1, std::move(vertex)))
        .with(integerAttribute(pieceMark, Domain::Face, 1, std::move(piece)))
        .with(integerAttribute(turnMark, Domain::Face, 1, std::move(turn)));
}

Mesh withoutMarks(const Mesh& mesh)
{
    return mesh.without(vertexMark).without(pieceMark).without(turnMark);
}

}  // namespace mw
