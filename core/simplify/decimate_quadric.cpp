// Simplification by quadrics: the loop of Garland and Heckbert over a heap of edges. Tables and tests are in collapse_mesh.h, the metric in
// quadric.h.
#include "core/simplify/decimate_quadric.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>

#include "core/simplify/collapse_mesh.h"
#include "core/simplify/decimate_quick.h"
#include "core/simplify/edge_heap.h"
#include "core/simplify/quadric.h"

namespace mw {

namespace {

constexpr double pull = 1e-5;  // of a vertex to its own place, against the planes of its faces

/// The cheapest edge and where it goes.
struct Candidate {
    uint32_t edge = none;
    glm::dvec3 place{0};
    double cost = 0;
};

class Decimation {
public:
    Decimation(Mesh input, const DecimateQuadric& parameters, bool watched);

    // The phases, in order.
    void gatherQuadrics();
    void rankEdges();
    Candidate takeCheapest();
    Verdict test(const Candidate& best);
    void putBack(const Candidate& best, Refusal why);
    uint32_t collapse(const Candidate& best, const Verdict& verdict);
    double updateRing(uint32_t corner);  ///< the least new cost

    bool wantsMore() const { return mesh.faces() > target_ && !heap.empty(); }
    double progress() const;
    Candidate ranked(uint32_t edge) const;
    Quadric sum(uint32_t edge) const { return quadrics[mesh.from(edge)] + quadrics[mesh.to(edge)]; }

    CollapseMesh mesh;
    std::vector<Quadric> quadrics;  // by vertex
    EdgeHeap heap;
    std::vector<uint32_t> ring;  // half-edges out of the last new vertex
    size_t refused = 0;

private:
    void addFace(uint32_t face, double sign);
    size_t targetOf(const DecimateQuadric& p) const;

    DecimateQuadric parameters_;
    size_t first_, target_;
    std::vector<float> moved_;  // by vertex: how far the surface has moved there; only when the error is the goal
    float popped_ = 0;
};

Decimation::Decimation(Mesh input, const DecimateQuadric& p, bool watched)
    : mesh(std::move(input), {.featureAngle = p.feature, .turnCosine = std::cos(glm::radians(p.turn))}, watched),
      quadrics(mesh.vertexSlots()),
      heap(3 * mesh.faceSlots()),
      parameters_(p),
      first_(mesh.faces()),
      target_(targetOf(p))
{
    if (p.stop == DecimateQuadric::Stop::Error) moved_.assign(mesh.vertexSlots(), 0.f);
}

size_t Decimation::targetOf(const DecimateQuadric& p) const
{
    if (p.stop == DecimateQuadric::Stop::Error) return 0;
    return p.stop == DecimateQuadric::Stop::Faces ? size_t(p.faces) : size_t(std::llround(p.ratio * double(mesh.faces())));
}

double Decimation::progress() const
{
    return first_ > target_ ? double(first_ - mesh.faces()) / double(first_ - target_) : 1;
}

// What a face gives to its three vertices: its plane, weighed with its area, and for each border or feature side a plane that stands on it.
void Decimation::addFace(uint32_t face, double sign)
{
    const uint32_t h = 3 * face;
    glm::dvec3 n = mesh.areaNormal(face);
    const double twice = glm::length(n), area = 0.5 * twice;
    if (!(twice > 0)) return;
    n /= twice;
    Quadric plane;
    plane.addPlane(n, -glm::dot(n, mesh.at(mesh.from(h))), sign * area);
    for (uint32_t k = h; k < h + 3; ++k) {
        const uint32_t v = mesh.from(k);
        quadrics[v] += plane;
        quadrics[v].addPoint(mesh.at(v), sign * area * pull);
    }
    for (uint32_t k = h; k < h + 3; ++k) {
        if (!mesh.weighed(k)) continue;
        const glm::dvec3 a = mesh.at(mesh.from(k)), side = mesh.at(mesh.to(k)) - a;
        const double length2 = glm::dot(side, side);
        if (!(length2 > 0)) continue;
        const glm::dvec3 m = glm::cross(n, side) / std::sqrt(length2);
        Quadric wall;
        wall.addPlane(m, -glm::dot(m, a), sign * parameters_.border * length2);
        quadrics[mesh.from(k)] += wall;
        quadrics[mesh.to(k)] += wall;
    }
}

void Decimation::gatherQuadrics()
{
    for (uint32_t f = 0; f < mesh.faceSlots(); ++f) addFace(f, 1);
}

// Where an edge would go and what that costs (3.14). An end on a curve, or at the end of one, holds the other.
Candidate Decimation::ranked(uint32_t edge) const
{
    const uint32_t v = mesh.from(edge), w = mesh.to(edge);
    const Quadric q = sum(edge);
    const glm::dvec3 a = mesh.at(v), b = mesh.at(w);
    Candidate c{edge, a, 0};
    if (mesh.kind(v) != mesh.kind(w)) {
        c.place = mesh.kind(v) > mesh.kind(w) ? a : b;
        c.cost = q.at(c.place);
    } else if (glm::dvec3 p; parameters_.optimal && q.least(p) && glm::dot(p - a, p - a) + glm::dot(p - b, p - b) < 16 * glm::dot(b - a, b - a)) {
        c.place = p;
        c.cost = q.at(p);
    } else {
        c.cost = q.at(a);
        const glm::dvec3 others[] = {b, 0.5 * (a + b)};
        for (int i = 0; i < (parameters_.optimal ? 2 : 1); ++i) {
            const double cost = q.at(others[i]);
            if (cost < c.cost) c.place = others[i], c.cost = cost;
        }
    }
    c.cost = std::isfinite(c.cost) ? std::max(c.cost, 0.0) : 1e30;
    return c;
}

void Decimation::rankEdges()
{
    for (uint32_t h = 0; h < 3 * mesh.faceSlots(); ++h)
        if (mesh.edgeOf(h) == h && mesh.collapsible(h)) heap.append(h, float(ranked(h).cost));
    heap.order();
}

// The edge on top may have become dearer since it was ranked, because the faces around it have changed: then it goes back and the next one is taken.
Candidate Decimation::takeCheapest()
{
    for (;;) {
        const uint32_t edge = heap.topEdge();
        popped_ = heap.topCost();
        const Candidate c = ranked(edge);
        if (float(c.cost) > popped_) {
            heap.set(edge, float(c.cost));
            continue;
        }
        heap.remove(edge);
        return c;
    }
}

Verdict Decimation::test(const Candidate& best)
{
    mesh.star(best.edge);
    Verdict v = mesh.test(best.edge, best.place);
    if (v.refusal == Refusal::None && !moved_.empty()) {
        const float before = std::max(moved_[mesh.from(best.edge)], moved_[mesh.to(best.edge)]);
        if (before + v.deviation > parameters_.error) v.refusal = Refusal::Error;
    }
    return v;
}

void Decimation::putBack(const Candidate& best, Refusal why)
{
    ++refused;
    if (why == Refusal::Locked || why == Refusal::Valence || why == Refusal::Error) return;
    const float again = 4 * std::max(popped_, 1e-12f);
    if (again < 1e3f) heap.set(best.edge, again);
}

uint32_t Decimation::collapse(const Candidate& best, const Verdict& verdict)
{
    const uint32_t h = best.edge, g = mesh.twin(h), v = mesh.from(h), w = mesh.to(h);
    const std::vector<uint32_t> star = mesh.star(h);
    for (const uint32_t side : {h, g})
        if (side != none)
            for (const uint32_t k : {CollapseMesh::next(side), CollapseMesh::prev(side)}) heap.remove(mesh.edgeOf(k));
    const bool forget = parameters_.memory == DecimateQuadric::Memory::None;
    Quadric all = sum(h);
    if (forget) {  // the faces that change or go take back what they gave
        for (const uint32_t c : star) addFace(c / 3, -1);
        addFace(h / 3, -1);
        if (g != none) addFace(g / 3, -1);
        all = Quadric();
    }
    if (!moved_.empty()) moved_[v] = std::max(moved_[v], moved_[w]) + float(verdict.deviation);
    const uint32_t stays = mesh.collapse(h, best.place);
    quadrics[v] = all;
    if (forget)
        for (const uint32_t c : star) addFace(c / 3, 1);
    return stays;
}

double Decimation::updateRing(uint32_t corner)
{
    bool open = false;
    double least = 1e30;
    const auto rank = [&](uint32_t h) {
        const uint32_t edge = mesh.edgeOf(h);
        if (!mesh.collapsible(edge)) {
            heap.remove(edge);
            return;
        }
        const double cost = ranked(edge).cost;
        least = std::min(least, cost);
        heap.set(edge, float(cost));
    };
    if (!mesh.fan(corner, ring, open)) return least;
    for (const uint32_t h : ring) rank(h);
    if (open) rank(CollapseMesh::prev(ring.back()));
    return least;
}

/// The lists of faces and vertices a step shows, numbered as the payload is.
struct Shown {
    std::vector<uint32_t> ring, removed;

    void around(const CollapseMesh& mesh, std::span<const uint32_t> corners, uint32_t edge)
    {
        ring.clear(), removed.clear();
        for (const uint32_t c : corners) ring.push_back(mesh.faceIndex(c / 3));
        if (edge == none) return;
        removed.push_back(mesh.faceIndex(edge / 3));
        if (mesh.twin(edge) != none) removed.push_back(mesh.faceIndex(mesh.twin(edge) / 3));
    }
};

Generator decimateTextbook(Mesh input, DecimateQuadric parameters, Stage<Mesh>& stage)
{
    Decimation d(std::move(input), parameters, stage.watched());
    CollapseMesh& mesh = d.mesh;
    stage.show([&mesh] { return mesh.payload(); });
    const double limit = std::cos(glm::radians(parameters.turn));
    Shown shown;

    d.gatherQuadrics();
    if (stage.watched()) {
        std::vector<uint32_t> corner(mesh.vertexSlots(), none), fan;
        bool open = false;
        for (uint32_t h = 3 * uint32_t(mesh.faceSlots()); h-- > 0;) corner[mesh.from(h)] = h;
        for (uint32_t v = 0; v < mesh.vertexSlots(); ++v) {
            if (corner[v] == none) continue;
            mesh.fan(corner[v], fan, open);
            shown.around(mesh, fan, none);
            const Quadric& q = d.quadrics[v];
            co_yield Step("build")
                .vertex(v, Role::Current, "v")
                .ring(ElementKind::Face, Role::Neighbour, shown.ring)
                .number("planes", double(fan.size()))
                .number("q11", q.xx)
                .number("q12", q.xy)
                .number("q13", q.xz)
                .number("q14", q.bx)
                .number("q22", q.yy)
                .number("q23", q.yz)
                .number("q24", q.by)
                .number("q33", q.zz)
                .number("q34", q.bz)
                .number("q44", q.c)
                .progress(0);
        }
    } else {
        co_yield Step("build").progress(0);
    }
    d.rankEdges();

    size_t collapses = 0;
    while (d.wantsMore()) {
        const Candidate best = d.takeCheapest();
        const uint32_t h = best.edge, v = mesh.from(h), w = mesh.to(h);
        if (stage.watched()) {
            const Quadric q = d.sum(h);
            co_yield Step("pick")
                .edge(mesh.vertexIndex(v), mesh.vertexIndex(w), Role::Current)
                .vertex(mesh.vertexIndex(v), Role::Current, "v")
                .vertex(mesh.vertexIndex(w), Role::Current, "w")
                .point(mesh.position(best.place), Role::New, "p")
                .number("cost", best.cost)
                .number("cost v", q.at(mesh.at(v)))
                .number("cost w", q.at(mesh.at(w)))
                .number("condition", q.condition())
                .number("edges", double(d.heap.size() + 1))
                .number("faces", double(mesh.faces()))
                .progress(d.progress());
        }
        const Verdict verdict = d.test(best);
        if (verdict.refusal != Refusal::None) {
            d.putBack(best, verdict.refusal);
            if (stage.watched() || (d.refused & 1023) == 0)
                co_yield Step("refuse")
                    .edge(mesh.vertexIndex(v), mesh.vertexIndex(w), Role::Rejected)
                    .vertex(mesh.vertexIndex(v), Role::Rejected, "v")
                    .vertex(mesh.vertexIndex(w), Role::Rejected, "w")
                    .number("reason", double(verdict.refusal))
                    .number("common", verdict.common)
                    .number("allowed", verdict.allowed)
                    .number("turn", verdict.turn)
                    .number("turn limit", limit)
                    .number("refused", double(d.refused))
                    .progress(d.progress());
            continue;
        }
        if (stage.watched()) {
            const std::vector<uint32_t>& star = mesh.star(h);
            shown.around(mesh, star, h);
            co_yield Step("collapse")
                .edge(mesh.vertexIndex(v), mesh.vertexIndex(w), Role::Current)
                .vertex(mesh.vertexIndex(v), Role::Current, "v")
                .vertex(mesh.vertexIndex(w), Role::Current, "w")
                .point(mesh.position(best.place), Role::New, "p")
                .ring(ElementKind::Face, Role::Removed, shown.removed)
                .ring(ElementKind::Face, Role::Neighbour, shown.ring)
                .number("cost", best.cost)
                .number("faces", double(mesh.faces()))
                .number("faces after", double(mesh.faces() - shown.removed.size()))
                .number("common", verdict.common)
                .number("turn", verdict.turn)
                .progress(d.progress());
        }
        const double least = d.updateRing(d.collapse(best, verdict));
        if (stage.watched() || (++collapses & 1023) == 0) {
            shown.around(mesh, d.ring, none);
            co_yield Step("update")
                .vertex(mesh.vertexIndex(v), Role::New, "p")
                .ring(ElementKind::Face, Role::Neighbour, shown.ring)
                .number("edges changed", double(d.ring.size()))
                .number("least", least)
                .number("faces", double(mesh.faces()))
                .progress(d.progress());
        }
    }
    stage.finish(mesh.payload());
}

}  // namespace

Generator decimateQuadric(Mesh input, DecimateQuadric parameters, Stage<Mesh>& stage)
{
    if (parameters.quality == DecimateQuadric::Quality::Textbook) return decimateTextbook(std::move(input), parameters, stage);
    return decimateQuick(std::move(input), parameters, stage);
}

}  // namespace mw
