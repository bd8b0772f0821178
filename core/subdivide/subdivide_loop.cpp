// Loop subdivision: level by level a point on every edge, a new place for every vertex, four triangles from each. Tables are in loop_level.h.
#include "core/subdivide/subdivide_loop.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/subdivide/loop_level.h"
#include "core/subdivide/refinement.h"

namespace mw {

namespace {

Origins originsOf(const LoopLevel& level, SubdivideLoop::Weights weights, Creases creases)
{
    const FaceCut cut{{}, level.faces(), 3, true};
    Origins o;
    o.vertexRows = [&level, weights] { return loopVertexRows(level, weights); };
    o.corner = [cut](const Attribute& a) { return cutCorners(a, cut); };
    o.crease = [cut, creases](const Attribute& a) { return cutCrease(a, cut, creases); };
    o.faces = [cut] { return cutFaces(cut); };
    return o;
}

/// The tables of all levels, with the last result.
Remembered<std::vector<LoopLevel>>& remembered()
{
    static Remembered<std::vector<LoopLevel>> memory;
    return memory;
}

std::string keyOf(const SubdivideLoop& p)
{
    return std::to_string(p.levels) + ' ' + std::to_string(int(p.weights)) + ' ' + std::to_string(int(p.corners)) + ' ' +
           std::to_string(int(p.fading)) + ' ' + std::to_string(int(p.uv));
}

/// What the steps say about vertices: their neighbours and rules, read from the rows that attributes use.
struct VertexRule {
    std::vector<uint32_t> ring;
    double kept = 1, lambda = 0;

    void read(const Stencils& rows, uint32_t v)
    {
        ring.clear();
        kept = rows.weight[rows.start[v]], lambda = 0;
        for (uint32_t i = rows.start[v] + 1; i < rows.start[v + 1]; ++i) {
            ring.push_back(rows.source[i]);
            lambda = rows.weight[i];
        }
    }
};

}  // namespace

Generator subdivideLoop(Mesh input, SubdivideLoop parameters, Stage<Mesh>& stage)
{
    constexpr size_t chunk = size_t(1) << 20;  // edges between two pauses when nobody watches
    const std::string key = keyOf(parameters);
    const auto made = stage.watched() ? std::nullopt : remembered().find(input, key);
    if (made) {
        Array<glm::vec3> again = lanes::padded(input.positions());
        for (const LoopLevel& tables : *made->tables) {
            LoopPoints next(tables, again, parameters.weights);
            for (size_t e = 0; e < tables.edges.size(); e += chunk) {
                next.edges(e, std::min(e + chunk, tables.edges.size()));
                co_yield Step("edge").progress(0.9);
            }
            next.vertices();
            again = std::move(next.points);
        }
        stage.finish(made->mesh.withPositions(std::move(again)));
        co_return;
    }
    Mesh mesh = asTriangles(input);
    checkResultSize(double(mesh.faceCount()) * std::pow(4.0, double(parameters.levels)), "levels=" + std::to_string(parameters.levels));
    stage.show([&mesh] { return mesh; });
    const float lasting = parameters.fading ? alwaysSharp : 1.f;
    LoopLevel level = LoopLevel::of(mesh, creaseOf(mesh), parameters.corners, lasting);
    Array<glm::vec3> places = lanes::padded(mesh.positions());
    Refinement<LoopLevel> refinement(input, mesh, parameters.uv,
                                     [&](const Mesh& m) { return LoopLevel::of(m, creaseOf(mesh), SubdivideLoop::Corners::Sharp, lasting); });
    const auto pointsOf = [weights = parameters.weights](const LoopLevel& l, const Array<glm::vec3>& points) {
        LoopPoints next(l, points, weights);
        next.edges(0, l.edges.size());
        next.vertices();
        return std::move(next.points);
    };
    const Creases creases = parameters.fading ? Creases::Fading : Creases::Lasting;
    const double share = 1.0 / double(parameters.levels);

    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        LoopPoints next(level, places, parameters.weights);
        for (size_t e = 0; e < level.edges.size(); e += chunk) {
            next.edges(e, std::min(e + chunk, level.edges.size()));
            if (!stage.watched()) co_yield Step("edge").number("level", double(n)).progress(done);
        }
        next.vertices();
        const Array<glm::vec3>& points = next.points;

        if (stage.watched()) {
            const Stencils rows = loopVertexRows(level, parameters.weights);
            for (uint32_t e = 0; e < level.edges.size(); ++e) {
                const LoopLevel::Edge& k = level.edges[e];
                const uint32_t row = uint32_t(level.vertices) + e;
                const bool sharp = rows.start[row + 1] - rows.start[row] == 2;
                const glm::vec3 p(points[level.vertices + e]);
                if (sharp)
                    co_yield Step("edge")
                        .edge(k.a, k.b, Role::Current)
                        .vertex(k.a, Role::Current, "A")
                        .vertex(k.b, Role::Current, "B")
                        .point(p, Role::New, "p")
                        .number("level", double(n))
                        .number("w edge", 0.5)
                        .number("w side", 0)
                        .number("points", e + 1)
                        .progress(done + 0.3 * share * e / double(level.edges.size()));
                else
                    co_yield Step("edge")
                        .edge(k.a, k.b, Role::Current)
                        .vertex(k.a, Role::Current, "A")
                        .vertex(k.b, Role::Current, "B")
                        .vertex(k.c, Role::Neighbour, "C")
                        .vertex(k.d, Role::Neighbour, "D")
                        .point(p, Role::New, "p")
                        .number("level", double(n))
                        .number("w edge", 0.375)
                        .number("w side", 0.125)
                        .number("points", e + 1)
                        .progress(done + 0.3 * share * e / double(level.edges.size()));
            }
            VertexRule rule;
            for (uint32_t v = 0; v < level.vertices; ++v) {
                rule.read(rows, v);
                co_yield Step("vertex")
                    .vertex(v, Role::Current, "v")
                    .ring(ElementKind::Vertex, Role::Neighbour, rule.ring)
                    .point(glm::vec3(points[v]), Role::New, "p")
                    .number("level", double(n))
                    .number("valence", double(rule.ring.size()))
                    .number("lambda", rule.lambda)
                    .number("kept", rule.kept)
                    .number("moved", glm::distance(points[v], places[v]))
                    .progress(done + share * (0.3 + 0.6 * v / double(level.vertices)));
            }
        }

        const bool last = n == parameters.levels;
        LoopLevel finer = level.refined(last);
        const size_t faces = finer.faces();
        refinement.refine(originsOf(level, parameters.weights, creases), pointsOf, last);
        places = std::move(next.points);
        if (stage.watched() || last) mesh = refinement.mesh(finer, places, 3, last);
        if (!stage.watched()) refinement.keep(std::move(level));
        level = std::move(finer);
        co_yield Step("split")
            .number("level", double(n))
            .number("vertices", double(level.vertices))
            .number("faces", double(faces))
            .progress(double(n) * share);
    }
    if (!stage.watched() && input.isTriangles()) refinement.remember(remembered(), key, mesh);
    stage.finish(std::move(mesh));
}

}  // namespace mw
