// Loop by loop: weights of all pairs of points, then the best triangles; they are put behind the mesh at the end.
#include "core/repair/fill_holes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_set>

#include "core/mesh/normals.h"
#include "core/mesh/rings.h"
#include "core/repair/appended.h"
#include "core/repair/boundary.h"
#include "core/repair/hole_triangulation.h"

namespace mw {

namespace {

constexpr size_t mostForDynamicProgramming = 300;

/// What is added so far, and which edges there are.
class Filling {
public:
    explicit Filling(const Mesh& mesh) : mesh_(mesh) {}

    HoleOutline outline(const BoundaryLoop& loop) const;
    void triangle(const BoundaryLoop& loop, const Triple& t);
    void fan(const BoundaryLoop& loop);
    Mesh mesh() const { return appended(mesh_, added_); }
    size_t triangles() const { return added_.faceFrom.size(); }

private:
    bool hasEdge(uint32_t a, uint32_t b) const;
    void addEdge(uint32_t a, uint32_t b) { edges_.insert(uint64_t(std::min(a, b)) << 32 | std::max(a, b)); }
    void corner(const BoundaryLoop& loop, uint32_t i);

    const Mesh& mesh_;
    Addition added_;
    std::unordered_set<uint64_t> edges_;  // those added
};

bool Filling::hasEdge(uint32_t a, uint32_t b) const
{
    const auto ring = mesh_.rings().neighboursOf(a);
    return std::binary_search(ring.begin(), ring.end(), b) || edges_.contains(uint64_t(std::min(a, b)) << 32 | std::max(a, b));
}

/// Both live as long as the outline is used.
HoleOutline Filling::outline(const BoundaryLoop& loop) const
{
    HoleOutline hole;
    for (const uint32_t v : loop.vertices) hole.points.emplace_back(mesh_.positions()[v]);
    for (const uint32_t f : loop.faces) {
        const glm::dvec3 n = areaVector(mesh_, f);
        hole.normals.push_back(glm::length(n) > 0 ? glm::normalize(n) : glm::dvec3(0));
    }
    hole.allowed = [this, &loop](uint32_t i, uint32_t j) { return !hasEdge(loop.vertices[i], loop.vertices[j]); };
    hole.isFace = loop.faces.size() == 3 && loop.faces[0] == loop.faces[1] && loop.faces[1] == loop.faces[2] && mesh_.face(loop.faces[0]).size() == 3;
    return hole;
}

void Filling::corner(const BoundaryLoop& loop, uint32_t i)
{
    added_.triangles.push_back(loop.vertices[i]);
    added_.corners.add(loop.corners[i], 1);
    added_.corners.endRow();
}

void Filling::triangle(const BoundaryLoop& loop, const Triple& t)
{
    for (const uint32_t i : t) corner(loop, i);
    added_.faceFrom.push_back(loop.faces[0]);
    for (size_t k = 0; k < 3; ++k) addEdge(loop.vertices[t[k]], loop.vertices[t[(k + 1) % 3]]);
}

/// Triangles to a new vertex in the middle: its edges cannot be there yet.
void Filling::fan(const BoundaryLoop& loop)
{
    const uint32_t n = uint32_t(loop.vertices.size()), middle = uint32_t(mesh_.vertexCount() + added_.positions.size());
    glm::dvec3 sum(0);
    for (const uint32_t v : loop.vertices) {
        sum += glm::dvec3(mesh_.positions()[v]);
        added_.vertices.add(v, 1.0 / n);
    }
    added_.vertices.endRow();
    added_.positions.emplace_back(sum / double(n));
    const uint32_t stride = 1 + n / 64;  // enough of them, or time and memory would grow as the square
    for (uint32_t i = 0; i < n; ++i) {
        corner(loop, i);
        corner(loop, (i + 1) % n);
        added_.triangles.push_back(middle);
        for (uint32_t c = 0; c < n; c += stride) added_.corners.add(loop.corners[c], 1.0 / ((n + stride - 1) / stride));
        added_.corners.endRow();
        added_.faceFrom.push_back(loop.faces[0]);
    }
}

double outlineLength(const Mesh& mesh, const BoundaryLoop& loop)
{
    double sum = 0;
    for (size_t i = 0; i < loop.vertices.size(); ++i) {
        const glm::dvec3 a(mesh.positions()[loop.vertices[i]]), b(mesh.positions()[loop.vertices[(i + 1) % loop.vertices.size()]]);
        sum += glm::length(b - a);
    }
    return sum;
}

/// The loop of the longest outline, or no loop.
size_t largest(const Mesh& mesh, const std::vector<BoundaryLoop>& loops)
{
    size_t best = loops.size();
    double length = -1;
    for (size_t i = 0; i < loops.size(); ++i)
        if (const double l = outlineLength(mesh, loops[i]); l > length) best = i, length = l;
    return best;
}

}  // namespace

Generator fillHoles(Mesh input, FillHoles p, Stage<Mesh>& stage)
{
    const Mesh& mesh = input;
    const std::vector<BoundaryLoop> loops = boundaryLoopsOf(mesh);
    const size_t kept = p.keepLargest ? largest(mesh, loops) : loops.size();
    Filling filling(mesh);
    stage.show([&] { return filling.mesh(); });
    for (size_t k = 0; k < loops.size(); ++k) {
        const BoundaryLoop& loop = loops[k];
        const size_t n = loop.vertices.size();
        const double done = double(k) / double(loops.size()), share = 1 / double(loops.size());
        if (k == kept || (p.maxEdges > 0 && n > size_t(p.maxEdges))) {
            co_yield Step("skip")
                .ring(ElementKind::Vertex, Role::Rejected, loop.vertices)
                .number("edges", double(n))
                .number("largest", double(k == kept))
                .progress(done);
            continue;
        }
        co_yield Step("loop")
            .ring(ElementKind::Vertex, Role::Current, loop.vertices)
            .number("loop", double(k + 1))
            .number("loops", double(loops.size()))
            .number("edges", double(n))
            .number("length", outlineLength(mesh, loop))
            .progress(done);
        const HoleOutline hole = filling.outline(loop);
        LeastBend best(hole, n <= mostForDynamicProgramming);
        for (size_t row = 0; row < best.rows(); ++row) {
            best.row(row);
            if (stage.watched() || (row & 15) == 15)
                co_yield Step("weights")
                    .ring(ElementKind::Vertex, Role::Current, loop.vertices)
                    .number("gap", double(row + 2))
                    .number("pairs", double(n - row - 2))
                    .number("edges", double(n))
                    .progress(done + 0.8 * share * double(row) / double(best.rows()));
        }
        const bool exact = best.possible();
        const std::vector<Triple> triangles = exact ? best.triangles() : n > mostForDynamicProgramming ? clippedEars(hole) : std::vector<Triple>();
        if (triangles.empty()) {
            filling.fan(loop);
            co_yield Step("fan")
                .ring(ElementKind::Vertex, Role::Current, loop.vertices)
                .number("edges", double(n))
                .number("triangles", double(filling.triangles()))
                .progress(done + share);
            continue;
        }
        for (const Triple& t : triangles) {
            filling.triangle(loop, t);
            if (stage.watched())
                co_yield Step("triangle")
                    .vertex(loop.vertices[t[0]], Role::Neighbour, "a")
                    .vertex(loop.vertices[t[1]], Role::Current, "b")
                    .vertex(loop.vertices[t[2]], Role::Neighbour, "c")
                    .face(uint32_t(mesh.faceCount() + filling.triangles() - 1), Role::New, "t")
                    .number("bend", exact ? best.bend(t) : 0)
                    .number("area", areaOf(hole, t))
                    .number("triangles", double(filling.triangles()))
                    .progress(done + share);
        }
    }
    stage.finish(filling.mesh());
}

}  // namespace mw
