// Loop subdivision: level by level a point on every edge, a new place for every vertex, four triangles from each. Tables are in loop_level.h.
#include "core/subdivide/subdivide_loop.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/subdivide/loop_level.h"

namespace mw {

namespace {

constexpr size_t mostTriangles = 100'000'000;

/// The input as triangles, with its corner and face attributes on them. What cutting a polygon adds is no crease.
Mesh asTriangles(const Mesh& input)
{
    if (input.isTriangles()) return input;
    const Mesh::Triangulation& t = input.triangulation();
    Mesh out = Mesh::triangles(input.positions(), t.vertices).withGroupNames(input.groupNames());
    if (!input.lines().empty()) out = out.withLines(input.lines());
    for (const Attribute& a : input.attributes()) {
        Attribute carried = a.domain == Domain::Corner ? gathered(a, t.corners) : a.domain == Domain::Face ? gathered(a, t.faces) : a;
        if (a.domain == Domain::Corner && a.name == names::crease) {
            Array<float> crease(t.corners.size(), 0.f);
            for (size_t c = 0; c < crease.size(); ++c) {
                const uint32_t face = t.faces[c / 3], after = t.corners[c % 3 == 2 ? c - 2 : c + 1], end = input.faceStart()[face + 1];
                if (after == (t.corners[c] + 1 == end ? input.faceStart()[face] : t.corners[c] + 1)) crease[c] = float(a.at(t.corners[c], 0));
            }
            carried = floatAttribute(a.name, Domain::Corner, 1, std::move(crease));
        }
        out = out.with(std::move(carried));
    }
    return out;
}

void checkSize(const Mesh& triangles, int64_t levels)
{
    const double faces = double(triangles.faceCount()) * std::pow(4.0, double(levels));
    if (faces <= double(mostTriangles)) return;
    throw Error("levels=" + std::to_string(levels) + " would make " + std::to_string(int64_t(faces / 1e6)) + " million triangles, at most " +
                std::to_string(mostTriangles / 1'000'000) + " million are made; take fewer levels or simplify first");
}

/// Sharpness goes to the halves of each side; sides inside are smooth.
Attribute refinedCrease(const Attribute& crease)
{
    const size_t corners = crease.size();
    Array<float> out(4 * corners, 0.f);
    for (size_t c = 0; c < corners; ++c) {
        const size_t f = c / 3, k = c % 3, child = 12 * f;
        out[child + 3 * k] = float(crease.at(c, 0));
        out[child + 3 * ((k + 1) % 3) + 2] = float(crease.at(c, 0));
    }
    return floatAttribute(crease.name, Domain::Corner, 1, std::move(out));
}

/// Puts the attributes of `old` on the next level.
Mesh withAttributes(Mesh next, const Mesh& old, const LoopLevel& level, SubdivideLoop::Weights weights)
{
    const auto has = [&](Domain d) {
        return std::any_of(old.attributes().begin(), old.attributes().end(), [d](const Attribute& a) { return a.domain == d; });
    };
    const Stencils vertexRows = has(Domain::Vertex) ? loopVertexRows(level, weights) : Stencils();
    const Stencils cornerRows = has(Domain::Corner) ? loopCornerRows(level.faces()) : Stencils();
    std::vector<uint32_t> faceFrom(has(Domain::Face) ? 4 * level.faces() : 0);
    for (size_t f = 0; f < faceFrom.size(); ++f) faceFrom[f] = uint32_t(f / 4);
    const Attribute *joints = old.find(names::joints, Domain::Vertex), *skin = old.find(names::weights, Domain::Vertex);
    for (const Attribute& a : old.attributes()) {
        if (a.domain == Domain::Face)
            next = next.with(gathered(a, faceFrom));
        else if (a.domain == Domain::Corner)
            next = next.with(a.name == names::crease ? refinedCrease(a) : blended(a, cornerRows));
        else if (!(joints && skin && (&a == joints || &a == skin)))
            next = next.with(blended(a, vertexRows));
    }
    if (joints && skin) {
        SkinWeights mixed = blendedSkin(*joints, *skin, vertexRows);
        next = next.with(std::move(mixed.joints)).with(std::move(mixed.weights));
    }
    return next.withGroupNames(old.groupNames());
}

Array<glm::vec3> asFloats(std::span<const glm::dvec3> points)
{
    Array<glm::vec3> out(points.size());
    for (size_t i = 0; i < points.size(); ++i) out[i] = glm::vec3(points[i]);
    return out;
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
    Mesh mesh = asTriangles(input);
    checkSize(mesh, parameters.levels);
    stage.show([&mesh] { return mesh; });
    const Attribute* crease = mesh.find(names::crease, Domain::Corner);
    LoopLevel level = LoopLevel::of(mesh, crease ? crease->floats() : std::span<const float>(), parameters.corners);
    std::vector<glm::dvec3> places(mesh.positions().begin(), mesh.positions().end());
    const double share = 1.0 / double(parameters.levels);

    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        LoopPoints next(level, places, parameters.weights);
        for (size_t e = 0; e < level.edges.size(); e += chunk) {
            next.edges(e, std::min(e + chunk, level.edges.size()));
            if (!stage.watched()) co_yield Step("edge").number("level", double(n)).progress(done);
        }
        next.vertices();
        const std::vector<glm::dvec3>& points = next.points;

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
        Mesh split = Mesh::triangles(asFloats(points), last ? std::move(finer.vertex) : finer.vertex);
        if (!mesh.lines().empty()) split = split.withLines(mesh.lines());
        mesh = withAttributes(std::move(split), mesh, level, parameters.weights);
        places = std::move(next.points);
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
