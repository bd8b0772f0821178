// Simplification by removing vertices: a heap of them by cost. The tables are in fan_mesh.h, the triangles of a hole in star_hole.h.
#include "core/simplify/decimate_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/metrics/fan.h"
#include "core/simplify/edge_heap.h"
#include "core/simplify/fan_mesh.h"
#include "core/simplify/star_hole.h"

namespace mw {

namespace {

using Place = FanMesh::Place;

/// What a vertex costs, and why.
struct VertexCost {
    double cost = -1;  ///< negative: it stays, whatever the threshold
    double distance = 0, longest = 0;
    glm::dvec3 foot{0}, normal{0};
};

class Removal {
public:
    Removal(Mesh input, const DecimateVertices& p, bool watched)
        : mesh(std::move(input), watched), heap(mesh.vertexSlots()), parameters_(p), turn_(std::cos(glm::radians(p.turn))), first_(mesh.faces())
    {}

    // The phases, in order.
    void rank();
    bool pick();  ///< false when the cheapest costs too much
    bool fill();  ///< finds triangles for the hole that `vertex` would leave
    void open() { mesh.open(vertex, fan); }
    void close() { mesh.close(fan, filling.triangles); }
    double updateRing();  ///< the least new cost

    VertexCost costOf(uint32_t v);
    bool wantsMore() const { return !heap.empty() && (parameters_.faces == 0 || mesh.faces() > size_t(parameters_.faces)); }
    double progress() const;

    FanMesh mesh;
    EdgeHeap heap;  // of vertices
    uint32_t vertex = none;
    VertexCost cost;
    VertexFan fan;
    Filling filling;
    size_t refused = 0;

private:
    NoFilling refusal() const;

    DecimateVertices parameters_;
    double turn_;
    size_t first_;
    VertexFan around_;
};

VertexCost Removal::costOf(uint32_t v)
{
    VertexCost c;
    if (mesh.place(v) == Place::Fixed || !mesh.alive(v) || !mesh.fan(v, around_)) return c;
    const bool border = mesh.place(v) == Place::Border;
    if (around_.open != border || (border && !parameters_.border) || (!border && around_.faces() < 3)) return c;
    const glm::dvec3 p = mesh.at(v);
    AveragePlane plane;
    for (size_t i = 0; i < around_.faces(); ++i)
        plane.add(measureOf(p, mesh.at(around_.ring[i]), mesh.at(around_.ring[(i + 1) % around_.ring.size()])));
    if (!plane.defined()) return c;
    c.normal = plane.normal();
    if (border) {
        const glm::dvec3 a = mesh.at(around_.ring.front()), b = mesh.at(around_.ring.back());
        const double width = glm::distance(a, b);
        c.distance = distanceToLine(p, a, b);
        c.longest = std::max(glm::distance(p, a), glm::distance(p, b));
        c.foot = width > 0 ? a + glm::dot(p - a, b - a) / (width * width) * (b - a) : a;
    } else {
        const double height = plane.height(p);
        c.distance = std::abs(height);
        c.foot = p - height * c.normal;
        for (const uint32_t w : around_.ring) c.longest = std::max(c.longest, glm::distance(p, mesh.at(w)));
    }
    const double measured = parameters_.metric == DecimateVertices::Metric::Relative ? c.distance / c.longest : c.distance;
    if (std::isfinite(measured)) c.cost = measured;
    return c;
}

void Removal::rank()
{
    for (uint32_t v = 0; v < mesh.vertexSlots(); ++v)
        if (const VertexCost c = costOf(v); c.cost >= 0) heap.append(v, float(c.cost));
    heap.order();
}

double Removal::progress() const
{
    const auto target = size_t(parameters_.faces);
    if (first_ > target && target > 0) return double(first_ - mesh.faces()) / double(first_ - target);
    return heap.empty() ? 1 : std::min(1.0, double(heap.topCost()) / std::max(parameters_.threshold, 1e-12));
}

bool Removal::pick()
{
    vertex = heap.topEdge();
    cost = costOf(vertex);
    if (!(cost.cost <= parameters_.threshold)) return false;
    heap.remove(vertex);
    return mesh.fan(vertex, fan);
}

// What can be said before triangles are sought.
NoFilling Removal::refusal() const
{
    const size_t n = fan.ring.size();
    if (fan.open && n == 2) return mesh.twin(fan.outline[0]) == none ? NoFilling::Exists : NoFilling::None;  // the piece would vanish
    if (fan.open && mesh.joined(fan.ring.front(), fan.ring.back())) return NoFilling::Exists;
    std::vector<uint32_t> ring = fan.ring;
    std::sort(ring.begin(), ring.end());
    if (std::adjacent_find(ring.begin(), ring.end()) != ring.end()) return NoFilling::Exists;
    if (!fan.open && n == 3) {  // a face there may be already
        const uint32_t a = mesh.twin(fan.outline[0]), b = mesh.twin(fan.outline[1]), c = mesh.twin(fan.outline[2]);
        const auto same = [](uint32_t g, uint32_t h) { return g != none && h != none && g / 3 == h / 3; };
        if (same(a, b) || same(b, c) || same(c, a)) return NoFilling::Exists;
    }
    return NoFilling::None;
}

bool Removal::fill()
{
    filling = {refusal(), {}, 0};
    if (filling.why == NoFilling::None && fan.ring.size() > 2) {
        StarHole hole;
        hole.open = fan.open;
        hole.apex = mesh.at(vertex);
        hole.normal = cost.normal;
        for (const uint32_t w : fan.ring) hole.points.push_back(mesh.at(w));
        for (const uint32_t side : fan.outline) {
            const uint32_t g = mesh.twin(side);
            const glm::dvec3 n = g == none ? glm::dvec3(0) : mesh.areaNormal(g / 3);
            const double length = glm::length(n);
            // Where it folds already nothing can be made worse.
            const bool folded = glm::dot(n, mesh.areaNormal(side / 3)) < 0;
            hole.beyond.push_back(length > 0 && !folded ? n / length : glm::dvec3(0));
        }
        hole.allowed = [this](uint32_t i, uint32_t j) { return !mesh.joined(fan.ring[i], fan.ring[j]); };
        filling = filled(hole, turn_);
    }
    if (filling.why != NoFilling::None) ++refused;
    return filling.why == NoFilling::None;
}

double Removal::updateRing()
{
    double least = 1e30;
    for (const uint32_t w : fan.ring) {
        const VertexCost c = costOf(w);
        if (c.cost < 0) {
            heap.remove(w);
            continue;
        }
        heap.set(w, float(c.cost));
        least = std::min(least, c.cost);
    }
    return least;
}

/// The lists a step shows, numbered as the payload is.
struct Shown {
    std::vector<uint32_t> faces, ring;

    void around(const FanMesh& mesh, const VertexFan& fan, bool withFaces)
    {
        faces.clear(), ring.clear();
        for (const uint32_t side : fan.outline)
            if (withFaces) faces.push_back(mesh.faceIndex(side / 3));
        for (const uint32_t w : fan.ring) ring.push_back(mesh.vertexIndex(w));
    }
    // Triangles take the slots of the faces that went, in their order.
    void closed(const FanMesh& mesh, const VertexFan& fan, size_t triangles)
    {
        around(mesh, fan, false);
        for (size_t t = 0; t < triangles; ++t) faces.push_back(mesh.faceIndex(fan.outline[t] / 3));
    }
};

}  // namespace

Generator decimateVertices(Mesh input, DecimateVertices parameters, Stage<Mesh>& stage)
{
    co_yield Step("rank").number("vertices", double(input.vertexCount())).progress(0);
    Removal r(std::move(input), parameters, stage.watched());
    FanMesh& mesh = r.mesh;
    stage.show([&mesh] { return mesh.payload(); });
    Shown shown;
    r.rank();

    size_t removed = 0;
    while (r.wantsMore()) {
        if (!r.pick()) break;
        const uint32_t v = r.vertex;
        const size_t vertices = mesh.vertices(), edges = mesh.edges(), faces = mesh.faces();
        if (stage.watched()) {
            shown.around(mesh, r.fan, true);
            co_yield Step("pick")
                .vertex(mesh.vertexIndex(v), Role::Current, "v")
                .ring(ElementKind::Face, Role::Neighbour, shown.faces)
                .ring(ElementKind::Vertex, Role::Neighbour, shown.ring)
                .segment(mesh.position(mesh.at(v)), mesh.position(r.cost.foot), Role::New, "d")
                .number("cost", r.cost.cost)
                .number("threshold", parameters.threshold)
                .number("place", double(r.fan.open))
                .number("d", r.cost.distance * mesh.scale())
                .number("longest", r.cost.longest * mesh.scale())
                .number("k", double(r.fan.ring.size()))
                .number("candidates", double(r.heap.size() + 1))
                .number("faces", double(faces))
                .progress(r.progress());
        }
        if (!r.fill()) {
            if (stage.watched() || (r.refused & 63) == 0)
                co_yield Step("refuse")
                    .vertex(mesh.vertexIndex(v), Role::Rejected, "v")
                    .ring(ElementKind::Face, Role::Rejected, shown.faces)
                    .number("reason", double(r.filling.why))
                    .number("k", double(r.fan.ring.size()))
                    .number("refused", double(r.refused))
                    .progress(r.progress());
            continue;
        }
        r.open();
        if (stage.watched()) {
            shown.around(mesh, r.fan, false);
            co_yield Step("hole")
                .point(mesh.position(mesh.at(v)), Role::Removed, "v")
                .ring(ElementKind::Vertex, Role::Neighbour, shown.ring)
                .number("k", double(r.fan.ring.size()))
                .number("faces gone", double(r.fan.faces()))
                .number("faces", double(mesh.faces()))
                .progress(r.progress());
        }
        r.close();
        if (stage.watched()) {
            shown.closed(mesh, r.fan, r.filling.triangles.size());
            co_yield Step("retriangulate")
                .ring(ElementKind::Face, Role::New, shown.faces)
                .ring(ElementKind::Vertex, Role::Neighbour, shown.ring)
                .number("k", double(r.fan.ring.size()))
                .number("triangles", double(r.filling.triangles.size()))
                .number("least angle", r.filling.leastAngle)
                .number("dV", double(mesh.vertices()) - double(vertices))
                .number("dE", double(mesh.edges()) - double(edges))
                .number("dF", double(mesh.faces()) - double(faces))
                .number("euler", double(mesh.vertices()) - double(mesh.edges()) + double(mesh.faces()))
                .progress(r.progress());
        }
        const double least = r.updateRing();
        if (stage.watched() || (++removed & 63) == 0)
            co_yield Step("update")
                .ring(ElementKind::Vertex, Role::New, shown.ring)
                .number("changed", double(r.fan.ring.size()))
                .number("least", least)
                .number("vertices", double(mesh.vertices()))
                .number("faces", double(mesh.faces()))
                .progress(r.progress());
    }
    stage.finish(mesh.payload());
}

}  // namespace mw
