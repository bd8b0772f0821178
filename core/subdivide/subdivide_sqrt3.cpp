// sqrt(3) subdivision: a centre in every triangle, every old edge flipped, every old vertex relaxed. Tables are in sqrt3_round.h.
#include "core/subdivide/subdivide_sqrt3.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/subdivide/carried.h"
#include "core/subdivide/sqrt3_attributes.h"

namespace mw {

namespace {

/// The mesh as a round leaves it. `first`: the other round of its pair.
Mesh finished(const Sqrt3Round& round, const Sqrt3Round* first)
{
    Mesh out = Mesh::triangles(round.points, round.triangles).withGroupNames(round.mesh.groupNames());
    if (!round.mesh.lines().empty()) out = out.withLines(round.mesh.lines());
    Origins o;
    o.vertexRows = [&round] { return round.rows; };
    std::vector<Attribute> ofVertices;
    for (const Attribute& a : round.mesh.attributes())
        if (a.domain == Domain::Vertex) ofVertices.push_back(a);
    out = withAttributes(std::move(out), carried(ofVertices, o));
    return withAttributes(std::move(out), first ? sqrt3Attributes(*first, &round) : sqrt3Attributes(round, nullptr));
}

}  // namespace

Generator subdivideSqrt3(Mesh input, SubdivideSqrt3 parameters, Stage<Mesh>& stage)
{
    Mesh mesh = asTriangles(input);
    checkResultSize(double(mesh.faceCount()) * std::pow(3.0, double(parameters.levels)), "levels=" + std::to_string(parameters.levels));
    const double share = 1.0 / double(parameters.levels);
    std::optional<Sqrt3Round> first;  // of a pair, while its second is made
    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        const bool last = n == parameters.levels;
        stage.show([&mesh] { return mesh; });
        if (!stage.watched()) co_yield Step("insert").number("level", double(n)).progress(done);
        Sqrt3Round round(mesh, n % 2 == 0);
        for (uint32_t f = 0; stage.watched() && f < mesh.faceCount(); ++f) {
            if (round.centre[f] == none) continue;
            co_yield Step("insert")
                .face(f, Role::Current)
                .ring(ElementKind::Vertex, Role::Neighbour, mesh.face(f))
                .point(round.points[round.centre[f]], Role::New, "c")
                .number("level", double(n))
                .number("points", double(round.centre[f] + 1 - mesh.vertexCount()))
                .progress(done + 0.25 * share * f / double(mesh.faceCount()));
        }
        for (uint32_t e = 0; stage.watched() && e < round.edges.size(); ++e) {
            if (round.firstOnSharp[e] == none) continue;
            co_yield Step("border")
                .edge(round.edges.ends[e].a, round.edges.ends[e].b, Role::Current)
                .vertex(round.edges.ends[e].a, Role::Current, "A")
                .vertex(round.edges.ends[e].b, Role::Current, "B")
                .point(round.points[round.firstOnSharp[e]], Role::New, "p")
                .point(round.points[round.firstOnSharp[e] + 1], Role::New, "q")
                .number("level", double(n))
                .progress(done + 0.3 * share);
        }
        stage.show([&round] { return Mesh::triangles(round.points, round.triangles); });
        if (stage.watched())
            co_yield Step("split")
                .number("level", double(n))
                .number("vertices", double(round.points.size()))
                .number("faces", double(round.triangles.size() / 3))
                .progress(done + 0.35 * share);

        std::vector<uint8_t> seam(round.edges.size(), 0);
        if (last && n % 2 == 1) seam = seamsOf(round);
        for (uint32_t e = 0, flipped = 0; e < round.edges.size(); ++e) {
            if (!round.flips(e) || seam[e]) continue;
            round.flip(e);
            ++flipped;
            if (!stage.watched() && flipped % 65536 != 0) continue;
            const uint32_t c = round.triangles[3 * size_t(round.edges.corner[e].a) + 2], d = round.triangles[3 * size_t(round.edges.corner[e].b) + 2];
            co_yield Step("flip")
                .segment(round.points[round.edges.ends[e].a], round.points[round.edges.ends[e].b], Role::Removed)
                .edge(c, d, Role::New)
                .vertex(round.edges.ends[e].a, Role::Neighbour, "A")
                .vertex(round.edges.ends[e].b, Role::Neighbour, "B")
                .vertex(c, Role::Current, "c")
                .vertex(d, Role::Current, "d")
                .number("level", double(n))
                .number("flipped", double(flipped))
                .progress(done + share * (0.35 + 0.3 * e / double(round.edges.size())));
        }
        for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            const glm::vec3 before = round.points[v], after = round.relaxed(v);
            round.points[v] = after;
            if (!stage.watched() && v % 65536 != 0) continue;
            const uint32_t from = round.rows.start[v], size = round.rows.start[v + 1] - from;
            const std::span<const uint32_t> ring(round.rows.source.data() + from + 1, size - 1);
            co_yield Step("relax")
                .vertex(v, Role::Current, "v")
                .ring(ElementKind::Vertex, Role::Neighbour, ring)
                .point(after, Role::New, "p")
                .number("level", double(n))
                .number("valence", double(ring.size()))
                .number("kept", double(round.rows.weight[from]))
                .number("moved", glm::distance(before, after))
                .progress(done + share * (0.65 + 0.3 * v / double(mesh.vertexCount())));
        }
        Mesh after = finished(round, first ? &*first : nullptr);
        mesh = std::move(after);
        stage.show([&mesh] { return mesh; });
        first.reset();
        if (n % 2 == 1) first.emplace(std::move(round));
        co_yield Step("level")
            .number("level", double(n))
            .number("vertices", double(mesh.vertexCount()))
            .number("faces", double(mesh.faceCount()))
            .progress(double(n) * share);
    }
    stage.finish(std::move(mesh));
}

}  // namespace mw
