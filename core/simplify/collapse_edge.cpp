#include "core/simplify/collapse_edge.h"

#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/mesh/select.h"
#include "core/metrics/edge_quadric.h"

namespace mw {

EdgeCollapser::EdgeCollapser(Mesh mesh) : mesh_(std::move(mesh), {}, true) {}

uint32_t EdgeCollapser::halfEdge(uint32_t a, uint32_t b) const
{
    uint32_t found = none;
    for (uint32_t h = 0; h < 3 * mesh_.faceSlots(); ++h) {
        if (mesh_.from(h) == a && mesh_.to(h) == b) return h;
        if (found == none && mesh_.from(h) == b && mesh_.to(h) == a) found = h;
    }
    return found;
}

// By the planes of the faces round both ends (3.14), each counted once for each end it has, as in the book.
glm::dvec3 EdgeCollapser::placeOf(uint32_t half, uint32_t a, CollapsePlace place)
{
    const uint32_t v = mesh_.from(half), w = mesh_.to(half);
    const glm::dvec3 p = mesh_.at(v), q = mesh_.at(w);
    if (place == CollapsePlace::Middle) return 0.5 * (p + q);
    if (place != CollapsePlace::Optimal) return (place == CollapsePlace::First) == (v == a) ? p : q;
    if (mesh_.kind(v) != mesh_.kind(w)) return mesh_.kind(v) > mesh_.kind(w) ? p : q;
    Quadric sum;
    std::vector<uint32_t> fan;
    bool open = false;
    const uint32_t twin = mesh_.twin(half);
    for (const uint32_t out : {half, twin == none ? CollapseMesh::next(half) : twin}) {
        mesh_.fan(out, fan, open);
        for (const uint32_t h : fan) {
            const glm::dvec3 n = mesh_.areaNormal(h / 3);
            const double twice = glm::length(n);
            if (twice > 0) sum.addPlane(n / twice, -glm::dot(n / twice, mesh_.at(mesh_.from(h))), 1);
        }
    }
    return bestPoint(sum, p, q).place;
}

EdgeCollapser::Judgement EdgeCollapser::judge(uint32_t a, uint32_t b, CollapsePlace place)
{
    Judgement j;
    j.half = halfEdge(a, b);
    if (j.half == none) return j;
    j.place = placeOf(j.half, a, place);
    mesh_.star(j.half);
    j.verdict = mesh_.test(j.half, j.place);
    return j;
}

Mesh EdgeCollapser::collapsed(const Judgement& j)
{
    mesh_.star(j.half);
    mesh_.collapse(j.half, j.place);
    return mesh_.payload();
}

std::string reasonAgainst(const EdgeCollapser::Judgement& j)
{
    if (j.half == none) return "there is no such edge";
    switch (j.verdict.refusal) {
        case Refusal::None:
        case Refusal::Error:
            return {};
        case Refusal::Link:
            return j.verdict.common > j.verdict.allowed ? "its ends share another neighbour, and the surface would be pinched there"
                                                        : "its faces are all there is of this piece";
        case Refusal::Turn:
            return "a face would turn over";
        case Refusal::Fold:
            return "it would make a fold";
        case Refusal::Feature:
            return "both ends lie on borders or seams, and the edge is not part of them";
        case Refusal::Locked:
            return "an end is at a place that is no surface";
        case Refusal::Valence:
            return "an end has too many faces";
    }
    return {};
}

namespace {

/// The edge that is meant; without a text the first one that may be collapsed.
EdgeCollapser::Judgement judged(EdgeCollapser& c, const CollapseEdge& p, size_t vertices)
{
    const ElementSet set = parsedElements(ElementKind::Edge, p.edge, vertices);
    if (set.indices.size() > 2) throw Error("collapse-edge: \"" + p.edge + "\" is more than one edge; give one, as 3~7");
    if (set.indices.size() == 2) {
        uint32_t a = set.indices[0], b = set.indices[1];
        const size_t mark = p.edge.find('~');  // first and second as written
        if (const ElementSet first = parsedElements(ElementKind::Vertex, std::string_view(p.edge).substr(0, mark), vertices);
            first.indices != std::vector{a})
            std::swap(a, b);
        return c.judge(a, b, p.place);
    }
    for (uint32_t h = 0; h < 3 * c.mesh().faceSlots(); ++h)
        if (c.mesh().edgeOf(h) == h)
            if (const auto j = c.judge(c.mesh().from(h), c.mesh().to(h), p.place); j.legal()) return j;
    throw Error("collapse-edge: no edge of this mesh may be collapsed");
}

}  // namespace

Generator collapseEdge(Mesh input, CollapseEdge parameters, Stage<Mesh>& stage)
{
    EdgeCollapser collapser(input);
    CollapseMesh& mesh = collapser.mesh();
    stage.show([&mesh] { return mesh.payload(); });
    const EdgeCollapser::Judgement j = judged(collapser, parameters, input.vertexCount());
    if (j.half == none)
        throw Error("collapse-edge: there is no edge " + parameters.edge + " in this mesh; edges are written as 3~7, by their vertices");
    const uint32_t h = j.half, g = mesh.twin(h), v = mesh.from(h), w = mesh.to(h);
    std::vector<uint32_t> gone{h / 3}, ring;
    if (g != none) gone.push_back(g / 3);
    for (const uint32_t c : mesh.star(h)) ring.push_back(c / 3);
    co_yield Step("edge")
        .edge(v, w, Role::Current)
        .vertex(v, Role::Current, "P")
        .vertex(w, Role::Current, "Q")
        .point(mesh.position(j.place), Role::New, "P'")
        .ring(ElementKind::Face, Role::Neighbour, ring)
        .number("faces of the edge", double(gone.size()))
        .number("ring", double(ring.size()))
        .number("length", glm::distance(mesh.position(mesh.at(v)), mesh.position(mesh.at(w))))
        .progress(0.2);
    if (!j.legal()) {
        co_yield Step("refuse")
            .edge(v, w, Role::Rejected)
            .vertex(v, Role::Rejected, "P")
            .vertex(w, Role::Rejected, "Q")
            .number("reason", double(j.verdict.refusal))
            .number("common", j.verdict.common)
            .number("allowed", j.verdict.allowed)
            .number("turn", j.verdict.turn)
            .progress(1);
        throw Error("collapse-edge: the edge " + std::to_string(v) + "~" + std::to_string(w) + " may not be collapsed: " + reasonAgainst(j));
    }
    co_yield Step("collapse")
        .edge(v, w, Role::Current)
        .point(mesh.position(j.place), Role::New, "P'")
        .ring(ElementKind::Face, Role::Removed, gone)
        .number("common", j.verdict.common)
        .number("allowed", j.verdict.allowed)
        .number("turn", j.verdict.turn)
        .number("faces gone", double(gone.size()))
        .progress(0.6);
    mesh.star(h);
    ring.clear();
    const uint32_t stays = mesh.collapse(h, j.place);
    std::vector<uint32_t> fan;
    bool open = false;
    mesh.fan(stays, fan, open);
    for (const uint32_t c : fan) ring.push_back(mesh.faceIndex(c / 3));
    co_yield Step("done")
        .vertex(mesh.vertexIndex(v), Role::New, "P'")
        .ring(ElementKind::Face, Role::Neighbour, ring)
        .number("dV", -1)
        .number("dE", -1 - double(gone.size()))
        .number("dF", -double(gone.size()))
        .number("faces", double(mesh.faces()))
        .progress(0.9);
    stage.finish(mesh.payload());
}

}  // namespace mw
