// Listing 2.1: each triangle knows its three vertices and its three neighbours, nothing else. From the first triangle the walk steps into a
// neighbour that has the vertex and is not where it came from, and collects the vertices it has not yet.
#include "core/mesh/one_ring_walk.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/mesh/opposite_sides.h"
#include "core/mesh/select.h"

namespace mw {

namespace {

class Walk {
public:
    Walk(const Mesh& mesh, const OneRingWalk& parameters);

    /// The two sides of a triangle at the vertex, by corner: only their neighbours can have the vertex.
    std::array<uint32_t, 2> sidesAtVertex(uint32_t t) const;
    uint32_t beyond(uint32_t side) const { return opposite_[side]; }  ///< the same side, of the neighbour; none at the boundary
    /// Visits a triangle: adds those of its vertices that are not there yet.
    void visit(uint32_t t);
    Step step(const char* phase, uint32_t t) const;
    ElementSet answer() const { return sorted({ElementKind::Vertex, ring_}); }

    uint32_t start = none;
    std::vector<uint32_t> fresh;  // collected last
    bool refuse(uint32_t t);      ///< counts the neighbour of a triangle that lacks the vertex; false when there is none
    uint32_t refusedFace = none;

private:
    bool hasVertex(uint32_t t) const { return std::ranges::find(mesh_.face(t), v_) != mesh_.face(t).end(); }
    void chooseStart(int64_t face);

    Mesh mesh_;
    uint32_t v_;
    Array<uint32_t> opposite_;
    std::vector<uint32_t> ring_, path_;
    size_t refused_ = 0;
};

Walk::Walk(const Mesh& mesh, const OneRingWalk& p) : mesh_(mesh), v_(uint32_t(p.vertex))
{
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        if (mesh.face(f).size() != 3)
            throw Error("the face-based structure is for triangles, and face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                        " corners; the operation adjacency walks any polygons");
    if (size_t(p.vertex) >= mesh.vertexCount())
        throw Error("there is no vertex " + std::to_string(p.vertex) + ": the mesh has " + std::to_string(mesh.vertexCount()));
    opposite_ = oppositeSidesOf(mesh);
    chooseStart(p.face);
}

void Walk::chooseStart(int64_t face)
{
    if (face >= int64_t(mesh_.faceCount()))
        throw Error("there is no face " + std::to_string(face) + ": the mesh has " + std::to_string(mesh_.faceCount()));
    const auto fits = [&](uint32_t t) {
        const auto f = mesh_.face(t);
        return hasVertex(t) && f[0] != f[1] && f[1] != f[2] && f[2] != f[0];
    };
    if (face >= 0 && !fits(uint32_t(face)))
        throw Error("face " + std::to_string(face) + " does not have the vertex " + std::to_string(v_) + "; choose one that has it, or -1");
    if (face >= 0) start = uint32_t(face);
    for (uint32_t t = 0; start == none && t < mesh_.faceCount(); ++t)
        if (fits(t)) start = t;
    if (start == none) throw Error("no triangle has the vertex " + std::to_string(v_) + ": it stands alone; choose another");
}

std::array<uint32_t, 2> Walk::sidesAtVertex(uint32_t t) const
{
    const auto f = mesh_.face(t);
    const uint32_t i = f[0] == v_ ? 0 : f[1] == v_ ? 1 : 2, before = (i + 2) % 3;
    return {3 * t + std::min(i, before), 3 * t + std::max(i, before)};
}

bool Walk::refuse(uint32_t t)
{
    const auto f = mesh_.face(t);
    const uint32_t i = f[0] == v_ ? 0 : f[1] == v_ ? 1 : 2, o = opposite_[3 * size_t(t) + (i + 1) % 3];
    if (o == none) return false;
    refusedFace = o / 3;
    ++refused_;
    return true;
}

void Walk::visit(uint32_t t)
{
    path_.push_back(t);
    fresh.clear();
    for (const uint32_t w : mesh_.face(t))
        if (w != v_ && std::ranges::find(ring_, w) == ring_.end()) fresh.push_back(w);
    ring_.insert(ring_.end(), fresh.begin(), fresh.end());
}

Step Walk::step(const char* phase, uint32_t t) const
{
    return Step(phase)
        .vertex(v_, Role::Current, "v")
        .face(t, Role::Current, "t")
        .ring(ElementKind::Face, Role::Neighbour, path_)
        .ring(ElementKind::Vertex, Role::Neighbour, ring_)
        .number("face", t)
        .number("triangles", double(path_.size()))
        .number("vertices", double(ring_.size()))
        .number("refused", double(refused_));
}

}  // namespace

Generator oneRingWalk(Mesh input, OneRingWalk parameters, Stage<ElementSet>& stage)
{
    Walk walk(input, parameters);
    stage.show([&] { return walk.answer(); });
    walk.visit(walk.start);
    co_yield walk.step("start", walk.start).ring(ElementKind::Vertex, Role::New, walk.fresh).number("new", double(walk.fresh.size()));
    if (walk.refuse(walk.start)) co_yield walk.step("refuse", walk.start).face(walk.refusedFace, Role::Rejected, "x");
    bool closed = false;
    // Twice at most: round, or to a boundary and then from the first triangle the other way.
    for (size_t way = 0; way < 2 && !closed; ++way) {
        uint32_t t = walk.start, out = walk.sidesAtVertex(t)[way];
        for (uint32_t in = walk.beyond(out); in != none && !closed; in = walk.beyond(out)) {
            t = in / 3;
            closed = t == walk.start;
            if (closed) break;
            walk.visit(t);
            co_yield walk.step("visit", t).ring(ElementKind::Vertex, Role::New, walk.fresh).number("new", double(walk.fresh.size()));
            if (walk.refuse(t)) co_yield walk.step("refuse", t).face(walk.refusedFace, Role::Rejected, "x");
            const std::array<uint32_t, 2> sides = walk.sidesAtVertex(t);
            out = sides[0] == in ? sides[1] : sides[0];
        }
        if (closed)
            co_yield walk.step("close", walk.start).face(t, Role::Neighbour, "p");
        else
            co_yield walk.step("boundary", t).number("way", double(way));
    }
    stage.finish(walk.answer());
}

}  // namespace mw
