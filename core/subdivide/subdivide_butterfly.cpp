// Butterfly subdivision: level by level a point on every edge by its neighbourhood, four triangles from each. The rules are in butterfly_rows.h.
#include "core/subdivide/subdivide_butterfly.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/subdivide/butterfly_rows.h"
#include "core/subdivide/carried.h"

namespace mw {

namespace {

constexpr const char* phaseOf(ButterflyRule rule)
{
    return rule == ButterflyRule::Regular ? "edge" : rule == ButterflyRule::Extraordinary ? "extraordinary" : "border";
}

Mesh nextMesh(const LoopLevel& finer, Array<glm::vec3> points, const Mesh& old, const LoopLevel& level, const Stencils& edgeRows)
{
    const FaceCut cut{{}, level.faces(), 3, true};
    Origins o;
    o.vertexRows = [&] {
        Stencils rows;
        for (uint32_t v = 0; v < level.vertices; ++v) {
            rows.add(v, 1);
            rows.endRow();
        }
        for (size_t e = 0; e < edgeRows.size(); ++e) {
            for (uint32_t i = edgeRows.start[e]; i < edgeRows.start[e + 1]; ++i) rows.add(edgeRows.source[i], double(edgeRows.weight[i]));
            rows.endRow();
        }
        return rows;
    };
    o.corner = [cut](const Attribute& a) { return cutCorners(a, cut); };
    o.crease = [cut](const Attribute& a) { return cutCrease(a, cut, Creases::Lasting); };
    o.faces = [cut] { return cutFaces(cut); };
    Mesh out = Mesh::triangles(std::move(points), finer.vertex).withGroupNames(old.groupNames());
    if (!old.lines().empty()) out = out.withLines(old.lines());
    return withAttributes(std::move(out), carried(old.attributes(), o));
}

/// What a step says about a row.
struct RowView {
    std::vector<uint32_t> others;
    glm::dvec3 point{0};
    double ends = 0;

    void read(const std::vector<ButterflyRows::Term>& terms, const Array<glm::vec3>& places, bool watched)
    {
        point = glm::dvec3(0);
        for (const auto& t : terms) point += t.weight * glm::dvec3(places[t.vertex]);
        if (!watched) return;
        others.clear();
        for (size_t i = 2; i < terms.size(); ++i) others.push_back(terms[i].vertex);
        ends = terms[0].weight + terms[1].weight;
    }
};

}  // namespace

Generator subdivideButterfly(Mesh input, SubdivideButterfly parameters, Stage<Mesh>& stage)
{
    Mesh mesh = asTriangles(input);
    checkResultSize(double(mesh.faceCount()) * std::pow(4.0, double(parameters.levels)), "levels=" + std::to_string(parameters.levels));
    stage.show([&mesh] { return mesh; });
    const double w = parameters.weights == SubdivideButterfly::Weights::Sixteenth ? 1.0 / 16 : 1.0 / 8;
    const double share = 1.0 / double(parameters.levels);
    LoopLevel level = LoopLevel::of(mesh, creaseOf(mesh), SubdivideLoop::Corners::Smooth);
    Array<glm::vec3> places(mesh.positions().begin(), mesh.positions().end());

    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        const ButterflyRows rows(level, w, parameters.modified);
        std::vector<ButterflyRows::Term> terms;
        RowView view;
        Stencils edgeRows;
        Array<glm::vec3> points = places;
        points.reserve(level.vertices + level.edges.size());
        for (uint32_t e = 0; e < level.edges.size(); ++e) {
            const ButterflyRule rule = rows.row(e, terms);
            view.read(terms, places, stage.watched());
            points.emplace_back(view.point);
            for (const auto& t : terms) edgeRows.add(t.vertex, t.weight);
            edgeRows.endRow();
            if (!stage.watched() && e % 65536 != 0) continue;
            const LoopLevel::Edge& k = level.edges[e];
            const glm::dvec3 middle = 0.5 * (glm::dvec3(places[k.a]) + glm::dvec3(places[k.b]));
            co_yield Step(phaseOf(rule))
                .edge(k.a, k.b, Role::Current)
                .vertex(k.a, Role::Current, "A")
                .vertex(k.b, Role::Current, "B")
                .ring(ElementKind::Vertex, Role::Neighbour, view.others)
                .point(points.back(), Role::New, "P")
                .number("level", double(n))
                .number("w ends", 0.5 * view.ends)
                .number("w", w)
                .number("offset", glm::distance(view.point, middle))
                .number("points", double(e + 1))
                .progress(done + 0.9 * share * e / double(level.edges.size()));
        }
        LoopLevel finer = level.refined(n == parameters.levels);
        Mesh next = nextMesh(finer, points, mesh, level, edgeRows);
        mesh = std::move(next);
        places = std::move(points);
        level = std::move(finer);
        co_yield Step("split")
            .number("level", double(n))
            .number("vertices", double(mesh.vertexCount()))
            .number("faces", double(mesh.faceCount()))
            .progress(double(n) * share);
    }
    stage.finish(std::move(mesh));
}

}  // namespace mw
