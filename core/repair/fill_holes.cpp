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
#include "core/repair/patch.h"

namespace mw {

namespace {

constexpr size_t mostForDynamicProgramming = 300;
constexpr size_t mostNewPoints = 50000;  // in one hole

/// What is added so far, and which edges there are.
class Filling {
public:
    Filling(const Mesh& mesh, const std::vector<BoundaryLoop>& loops);

    HoleOutline outline(const BoundaryLoop& loop) const;
    void triangle(const BoundaryLoop& loop, const Triple& t);
    void fan(const BoundaryLoop& loop);
    /// The same triangles made dense and smooth.
    void surface(const BoundaryLoop& loop, const HoleOutline& hole, const std::vector<Triple>& triangles);
    Mesh mesh() const { return appended(mesh_, added_); }
    size_t triangles() const { return added_.faceFrom.size(); }

private:
    bool hasEdge(uint32_t a, uint32_t b) const;
    void addEdge(uint32_t a, uint32_t b) { edges_.insert(uint64_t(std::min(a, b)) << 32 | std::max(a, b)); }
    void corner(const BoundaryLoop& loop, uint32_t i);
    std::vector<double> nearness(const BoundaryLoop& loop, const glm::dvec3& p) const;
    std::vector<std::vector<glm::dvec3>> ringsBeyond(const BoundaryLoop& loop) const;

    const Mesh& mesh_;
    Addition added_;
    std::unordered_set<uint64_t> edges_;  // those added, and cuts of polygons
};

/// The cuts of polygons beside holes count as edges: the mesh is to stay a manifold when it is triangulated.
Filling::Filling(const Mesh& mesh, const std::vector<BoundaryLoop>& loops) : mesh_(mesh)
{
    if (mesh.isTriangles()) return;
    std::vector<uint8_t> beside(mesh.vertexCount(), 0);
    for (const BoundaryLoop& loop : loops)
        for (const uint32_t v : loop.vertices) beside[v] = 1;
    const Shared<uint32_t>& t = mesh.triangulation().vertices;
    for (size_t i = 0; i < t.size(); ++i) {
        const uint32_t a = t[i], b = t[i % 3 == 2 ? i - 2 : i + 1];
        if (beside[a] && beside[b]) addEdge(a, b);
    }
}

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

/// Shares of points of the outline, by the inverse square of the distance; 0 for those not asked.
std::vector<double> Filling::nearness(const BoundaryLoop& loop, const glm::dvec3& p) const
{
    const size_t n = loop.vertices.size(), stride = 1 + n / 64;
    std::vector<double> share(n, 0);
    double sum = 0;
    for (size_t i = 0; i < n; i += stride) {
        const glm::dvec3 d = glm::dvec3(mesh_.positions()[loop.vertices[i]]) - p;
        sum += share[i] = 1 / std::max(glm::dot(d, d), 1e-300);
    }
    for (double& s : share) s /= sum;
    return share;
}

/// Neighbours of each point of the outline that are not its neighbours on the outline.
std::vector<std::vector<glm::dvec3>> Filling::ringsBeyond(const BoundaryLoop& loop) const
{
    const size_t n = loop.vertices.size();
    std::vector<std::vector<glm::dvec3>> out(n);
    for (size_t i = 0; i < n; ++i)
        for (const uint32_t w : mesh_.rings().neighboursOf(loop.vertices[i]))
            if (w != loop.vertices[(i + 1) % n] && w != loop.vertices[(i + n - 1) % n]) out[i].emplace_back(mesh_.positions()[w]);
    return out;
}

void Filling::surface(const BoundaryLoop& loop, const HoleOutline& hole, const std::vector<Triple>& triangles)
{
    const uint32_t n = uint32_t(loop.vertices.size()), first = uint32_t(mesh_.vertexCount() + added_.positions.size());
    std::vector<double> spacing;
    for (const uint32_t v : loop.vertices) {
        double sum = 0;
        const auto ring = mesh_.rings().neighboursOf(v);
        for (const uint32_t w : ring) sum += glm::length(glm::dvec3(mesh_.positions()[w]) - glm::dvec3(mesh_.positions()[v]));
        spacing.push_back(sum / double(ring.size()));
    }
    Patch patch{hole.points, triangles, n};
    refine(patch, spacing, hole.allowed, mostNewPoints);
    fair(patch, ringsBeyond(loop));
    std::vector<std::vector<double>> shares;
    for (size_t i = n; i < patch.points.size(); ++i) {
        shares.push_back(nearness(loop, patch.points[i]));
        for (uint32_t k = 0; k < n; ++k)
            if (shares.back()[k] > 0) added_.vertices.add(loop.vertices[k], shares.back()[k]);
        added_.vertices.endRow();
        added_.positions.emplace_back(patch.points[i]);
    }
    for (const Triple& t : patch.triangles) {
        for (const uint32_t i : t) {
            if (i < n) {
                corner(loop, i);
                continue;
            }
            added_.triangles.push_back(first + i - n);
            for (uint32_t k = 0; k < n; ++k)
                if (shares[i - n][k] > 0) added_.corners.add(loop.corners[k], shares[i - n][k]);
            added_.corners.endRow();
        }
        added_.faceFrom.push_back(loop.faces[0]);
        for (size_t k = 0; k < 3; ++k)
            if (t[k] < n && t[(k + 1) % 3] < n) addEdge(loop.vertices[t[k]], loop.vertices[t[(k + 1) % 3]]);
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
    Filling filling(mesh, loops);
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
        if (p.method == FillHoles::Method::Fair) {
            filling.surface(loop, hole, triangles);
            co_yield Step("surface")
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
