// The border vertex by vertex, the weights ring by ring, then one of three solvers.
#include "core/parameterize/embed_planar.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/error.h"
#include "core/mesh/topology.h"
#include "core/parameterize/spring_system.h"

namespace mw {
namespace {

constexpr double orderWork = 2e5, factorWork = 3e7;  // between two looks at whether to go on
constexpr uint32_t sweepWork = 1 << 15;

double signedArea(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c)
{
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

Attribute textureOf(const Mesh& mesh, std::span<const glm::dvec2> places)
{
    Array<float> t;
    t.reserve(2 * mesh.cornerCount());
    for (const uint32_t v : mesh.cornerVertex()) {
        t.push_back(float(0.5 + 0.5 * places[v].x));
        t.push_back(float(0.5 + 0.5 * places[v].y));
    }
    return floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(t));
}

/// In the plane at the mesh's own area, its middle where the mesh's was.
Mesh flat(const Mesh& mesh, std::span<const glm::dvec2> places, PlanarOutline outline)
{
    const double unit = outline == PlanarOutline::Square ? 2 : std::sqrt(std::numbers::pi);
    const double scale = std::sqrt(surfaceArea(mesh)) / unit;
    const glm::dvec3 centre = mesh.bounds().centre();
    Array<glm::vec3> positions;
    positions.reserve(places.size());
    for (const glm::dvec2 p : places) positions.push_back(glm::vec3(centre + glm::dvec3(scale * p, 0)));
    return mesh.withPositions(std::move(positions)).without(names::normal).without(names::tangent);
}

/// All the state of a run.
struct Layout {
    Mesh mesh;
    EmbedPlanar how;
    Disk disk;
    std::vector<glm::dvec2> outline, places, next;
    std::vector<glm::dvec2> exact;  // of the direct solver, to compare with

    Layout(const Mesh& m, const EmbedPlanar& p) : mesh(m), how(p), disk(diskOf(m)), outline(outlinePlaces(disk, p.boundary))
    {
        places.assign(m.vertexCount(), glm::dvec2(0));
    }
    Mesh asItStands() const
    {
        const Mesh textured = mesh.with(textureOf(mesh, places));
        return how.output == EmbedPlanar::Output::Flat ? flat(textured, places, how.boundary) : textured;
    }
    Mesh result(const std::vector<uint32_t>& folded) const
    {
        Mesh out = asItStands().without("folded");
        if (folded.empty()) return out;
        Array<int32_t> flags(mesh.faceCount(), 0);
        for (const uint32_t f : folded) flags[f] = 1;
        return out.with(integerAttribute("folded", Domain::Face, 1, std::move(flags)));
    }
    void take(std::span<const glm::dvec2> inner)
    {
        for (size_t i = 0; i < inner.size(); ++i) places[disk.inner[i]] = inner[i];
    }
    double error() const
    {
        double worst = 0;
        for (const uint32_t v : disk.inner) worst = std::max(worst, glm::length(places[v] - exact[v]));
        return worst;
    }
};

void expectSolved(double residual)
{
    if (residual < 1e-9) return;
    throw Error("the weights of this mesh give no stable system (residual " + std::to_string(residual) +
                "); choose mean-value or uniform weights, or repair its thin triangles");
}

SparseDirect ordered(const SpringSystem& springs)
{
    const std::vector<glm::vec3> places = springs.places();
    return SparseDirect(springs.pattern(), places);
}

/// The factors are there.
std::vector<glm::dvec2> solved(const SparseDirect& direct, const SpringSystem& springs, std::span<const glm::dvec2> places)
{
    std::vector<glm::dvec2> x = springs.rightSides(places);
    direct.solve(x);
    return x;
}

}  // namespace

std::vector<uint32_t> foldedFaces(const Mesh& mesh, std::span<const glm::dvec2> places)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    std::vector<uint32_t> out;
    for (size_t t = 0; t < cut.faces.size(); ++t) {
        const uint32_t* v = cut.vertices.data() + 3 * t;
        if (signedArea(places[v[0]], places[v[1]], places[v[2]]) > 0) continue;
        if (out.empty() || out.back() != cut.faces[t]) out.push_back(cut.faces[t]);
    }
    return out;
}

std::vector<glm::dvec2> planarEmbedding(const Disk& disk, EdgeWeights weights, std::span<const glm::dvec2> outline)
{
    std::vector<glm::dvec2> places(disk.triangles.vertexCount(), glm::dvec2(0));
    for (size_t i = 0; i < disk.border.size(); ++i) places[disk.border[i]] = outline[i];
    const SpringSystem springs(disk, weights);
    SparseDirect direct = ordered(springs);
    while (direct.order(1e9)) {
    }
    while (direct.analyse(1e9)) {
    }
    direct.begin(springs.values());
    while (direct.factor(1e12)) {
    }
    const std::vector<glm::dvec2> x = solved(direct, springs, places);
    for (size_t i = 0; i < x.size(); ++i) places[disk.inner[i]] = x[i];
    expectSolved(springs.residual(places));
    return places;
}

std::vector<glm::dvec2> planarEmbedding(const Mesh& mesh, EdgeWeights weights, PlanarOutline outline)
{
    const Disk disk = diskOf(mesh);
    return planarEmbedding(disk, weights, outlinePlaces(disk, outline));
}

Generator embedPlanar(Mesh input, EmbedPlanar p, Stage<Mesh>& stage)
{
    co_yield Step("boundary").progress(0);
    Layout at(input, p);
    stage.show([&] { return at.asItStands(); });
    const std::vector<uint32_t>& border = at.disk.border;
    for (size_t i = 0; i < border.size(); ++i) {
        const glm::dvec2 place = at.outline[i];
        at.places[border[i]] = place;
        if (stage.watched())
            co_yield Step("boundary")
                .vertex(border[i], Role::Current, "P")
                .ring(ElementKind::Vertex, Role::Neighbour, std::span(border).first(i))
                .number("pinned", double(i + 1))
                .number("border", double(border.size()))
                .number("u", place.x)
                .number("v", place.y)
                .progress(0.05 * double(i) / double(border.size()));
    }

    const SpringSystem springs(at.disk, p.weights);
    const std::vector<uint32_t> inner(at.disk.inner.begin(), at.disk.inner.end());
    for (size_t i = 0; i < inner.size() && stage.watched(); ++i) {
        const auto shares = springs.shares(inner[i]);
        const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
        co_yield Step("weights")
            .vertex(inner[i], Role::Current, "P")
            .ring(ElementKind::Vertex, Role::Neighbour, springs.ring(inner[i]))
            .number("valence", double(shares.size()))
            .number("sum", springs.sum(inner[i]))
            .number("least", *least)
            .number("most", *most)
            .progress(0.05 + 0.05 * double(i) / double(inner.size()));
    }

    // The exact solution: the result, or what an iteration is compared with when somebody looks.
    const bool direct = p.solver == EmbedPlanar::Solver::Direct;
    if (direct || (stage.watched() && inner.size() < 200000)) {
        SparseDirect solver = ordered(springs);
        while (solver.order(orderWork)) co_yield Step("order").progress(0.1 + 0.2 * solver.progress());
        while (solver.analyse(orderWork)) co_yield Step("order").progress(0.3 + 0.1 * solver.progress());
        solver.begin(springs.values());
        const bool shown = direct && stage.watched();
        while (solver.factor(shown ? 0.5 : factorWork, !shown)) {
            const double done = 0.4 + 0.5 * solver.progress();
            if (!shown) {
                co_yield Step("eliminate").progress(done);
                continue;
            }
            const SparseDirect::Supernode node = solver.supernode(solver.factored() - 1);
            std::vector<uint32_t> own;
            for (const uint32_t i : node.own) own.push_back(inner[i]);
            co_yield Step("eliminate")
                .ring(ElementKind::Vertex, Role::Current, own)
                .number("done", double(solver.factored()))
                .number("groups", double(solver.supernodes()))
                .number("own", double(node.own.size()))
                .number("joined", double(node.border))
                .number("operations", node.operations)
                .progress(done);
        }
        at.exact = at.places;
        const std::vector<glm::dvec2> x = solved(solver, springs, at.places);
        for (size_t i = 0; i < x.size(); ++i) at.exact[inner[i]] = x[i];
        const double residual = springs.residual(at.exact);
        if (direct) {
            expectSolved(residual);
            at.places = at.exact;
        }
    }

    at.next = at.places;
    int64_t sweeps = 0;
    for (double largest = p.tolerance; !direct && largest >= p.tolerance && sweeps < p.iterations; ++sweeps) {
        largest = 0;
        const bool jacobi = p.solver == EmbedPlanar::Solver::Jacobi;
        for (uint32_t i = 0; i < inner.size(); ++i) {
            const uint32_t v = inner[i];
            const glm::dvec2 place = springs.mean(v, at.places);
            const double moved = glm::length(place - at.places[v]);
            largest = std::max(largest, moved);
            at.next[v] = place;
            if (!jacobi) at.places[v] = place;
            if (stage.watched())
                co_yield Step("move")
                    .vertex(v, Role::Current, "P")
                    .ring(ElementKind::Vertex, Role::Neighbour, springs.ring(v))
                    .number("sweep", double(sweeps + 1))
                    .number("u", place.x)
                    .number("v", place.y)
                    .number("moved", moved);
            else if (i % sweepWork == sweepWork - 1)
                co_yield Step("move");
        }
        if (jacobi) at.places = at.next;
        if (!std::isfinite(largest) || largest > 1e12)
            throw Error("the sweeps run away: with these weights they do not settle; choose the direct solver, or mean-value weights");
        const double share = p.tolerance >= largest ? 1 : std::log(std::min(largest, 1.0)) / std::log(p.tolerance);
        const double done = 0.1 + 0.85 * std::max(share, double(sweeps) / double(p.iterations));
        if (stage.watched())
            co_yield Step("sweep")
                .number("sweep", double(sweeps + 1))
                .number("largest", largest)
                .number("residual", springs.residual(at.places))
                .number("error", at.exact.empty() ? 0 : at.error())
                .progress(done);
        else if (sweeps % 16 == 0 || inner.size() > sweepWork)
            co_yield Step("sweep").progress(done);
    }

    const std::vector<uint32_t> folded = foldedFaces(at.mesh, at.places);
    co_yield Step("result")
        .ring(ElementKind::Face, Role::Rejected, folded)
        .number("residual", springs.residual(at.places))
        .number("folded", double(folded.size()))
        .number("negative", double(springs.negative()))
        .number("sweeps", double(sweeps))
        .progress(1);
    stage.finish(at.result(folded));
}

}  // namespace mw
