// Catmull-Clark subdivision: level by level a point for every face, then for every edge, then a new place for every vertex. Tables are in
// catmull_level.h.
#include "core/subdivide/subdivide_catmull_clark.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/subdivide/catmull_level.h"
#include "core/subdivide/edge_rings.h"
#include "core/subdivide/refinement.h"

namespace mw {

namespace {

Origins originsOf(const CatmullLevel& level, Creases creases)
{
    const FaceCut cut{level.faceStart, level.faces(), 4, false};
    Origins o;
    o.vertexRows = [&level] { return catmullVertexRows(level); };
    o.corner = [cut](const Attribute& a) { return cutCorners(a, cut); };
    o.crease = [cut, creases](const Attribute& a) { return cutCrease(a, cut, creases); };
    o.faces = [cut] { return cutFaces(cut); };
    return o;
}

double resultFaces(const Mesh& mesh, int64_t levels)
{
    return double(mesh.cornerCount()) * std::pow(4.0, double(levels - 1));
}

/// The tables of all levels, with the last result.
Remembered<std::vector<CatmullLevel>>& remembered()
{
    static Remembered<std::vector<CatmullLevel>> memory;
    return memory;
}

std::string keyOf(const SubdivideCatmullClark& p)
{
    return std::to_string(p.levels) + ' ' + std::to_string(int(p.corners)) + ' ' + std::to_string(int(p.fading)) + ' ' + std::to_string(int(p.uv));
}

/// What the steps say about a vertex: its ring, and the means that the rule is made of.
class VertexView {
public:
    explicit VertexView(const CatmullLevel& level) : level_(level), rings_(level.vertices, level.edges), rule_(level.vertices, nullptr)
    {
        for (const SharpVertex& s : level.creases) rule_[s.vertex] = &s;
    }
    void look(uint32_t v, const Array<glm::vec3>& old, const Array<glm::vec3>& points)
    {
        ring.clear();
        q = r = glm::dvec3(0);
        std::vector<uint32_t> faces;
        for (const uint32_t e : rings_.of(v)) {
            const CatmullLevel::Edge& k = level_.edges[e];
            ring.push_back(otherEnd(k, v));
            r += 0.5 * (glm::dvec3(old[v]) + glm::dvec3(old[ring.back()]));
            faces.insert(faces.end(), {k.f, k.g});
        }
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        for (const uint32_t f : faces) q += glm::dvec3(points[level_.vertices + level_.edges.size() + f]);
        if (!faces.empty()) q /= double(faces.size());
        if (!ring.empty()) r /= double(ring.size());
        rule = rule_[v] == nullptr ? 0 : rule_[v]->side == 0 ? 2 : 1;
    }
    std::vector<uint32_t> ring;
    glm::dvec3 q{0}, r{0};
    int rule = 0;  // smooth, crease, corner

private:
    const CatmullLevel& level_;
    EdgeRings rings_;
    std::vector<const SharpVertex*> rule_;
};

}  // namespace

Generator subdivideCatmullClark(Mesh input, SubdivideCatmullClark parameters, Stage<Mesh>& stage)
{
    constexpr size_t chunk = size_t(1) << 20;  // elements between two pauses when nobody watches
    const std::string key = keyOf(parameters);
    const auto made = stage.watched() ? std::nullopt : remembered().find(input, key);
    if (made) {
        Array<glm::vec3> again = lanes::padded(input.positions());
        for (const CatmullLevel& tables : *made->tables) {
            CatmullPoints next(tables, again);
            for (size_t f = 0; f < tables.faces(); f += chunk) {
                next.faces(f, std::min(f + chunk, tables.faces()));
                co_yield Step("face").progress(0.9);
            }
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
    Mesh mesh = withoutTinyFaces(input);
    checkResultSize(resultFaces(mesh, parameters.levels), "levels=" + std::to_string(parameters.levels));
    stage.show([&mesh] { return mesh; });
    const bool sharpCorners = parameters.corners == SubdivideCatmullClark::Corners::Sharp;
    const float lasting = parameters.fading ? alwaysSharp : 1.f;
    CatmullLevel level = CatmullLevel::of(mesh, creaseOf(mesh), sharpCorners, lasting);
    Array<glm::vec3> places = lanes::padded(mesh.positions());
    Refinement<CatmullLevel> refinement(input, mesh, parameters.uv,
                                        [&](const Mesh& m) { return CatmullLevel::of(m, creaseOf(mesh), true, lasting); });
    const auto pointsOf = [](const CatmullLevel& l, const Array<glm::vec3>& points) {
        CatmullPoints next(l, points);
        next.faces(0, l.faces());
        next.edges(0, l.edges.size());
        next.vertices();
        return std::move(next.points);
    };
    const Creases creases = parameters.fading ? Creases::Fading : Creases::Lasting;
    const double share = 1.0 / double(parameters.levels);

    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        CatmullPoints next(level, places);
        const size_t edgePoints = level.vertices, facePoints = edgePoints + level.edges.size();
        for (size_t f = 0; f < level.faces(); f += chunk) {
            next.faces(f, std::min(f + chunk, level.faces()));
            if (!stage.watched()) co_yield Step("face").number("level", double(n)).progress(done);
        }
        for (uint32_t f = 0; stage.watched() && f < level.faces(); ++f)
            co_yield Step("face")
                .face(f, Role::Current)
                .ring(ElementKind::Vertex, Role::Neighbour, mesh.face(f))
                .point(next.points[facePoints + f], Role::New, "f")
                .number("level", double(n))
                .number("corners", double(mesh.face(f).size()))
                .number("points", double(f + 1))
                .progress(done + 0.2 * share * f / double(level.faces()));

        for (size_t e = 0; e < level.edges.size(); e += chunk) {
            next.edges(e, std::min(e + chunk, level.edges.size()));
            if (!stage.watched()) co_yield Step("edge").number("level", double(n)).progress(done + 0.3 * share);
        }
        next.vertices();
        std::vector<SharpEdge>::const_iterator sharp = level.sharp.begin();
        for (uint32_t e = 0; stage.watched() && e < level.edges.size(); ++e) {
            const CatmullLevel::Edge& k = level.edges[e];
            const bool crease = sharp != level.sharp.end() && sharp->edge == e;
            const double smooth = crease ? std::max(0.0, 1 - double(sharp->sharpness)) : 1;
            if (crease) ++sharp;
            co_yield Step("edge")
                .edge(k.a, k.b, Role::Current)
                .vertex(k.a, Role::Current, "A")
                .vertex(k.b, Role::Current, "B")
                .point(next.points[facePoints + k.f], Role::Neighbour, "f")
                .point(next.points[facePoints + k.g], Role::Neighbour, "g")
                .point(next.points[edgePoints + e], Role::New, "e")
                .number("level", double(n))
                .number("w ends", 0.5 - 0.25 * smooth)
                .number("w faces", 0.25 * smooth)
                .number("points", e + 1)
                .progress(done + share * (0.2 + 0.3 * e / double(level.edges.size())));
        }
        if (stage.watched()) {
            VertexView view(level);
            for (uint32_t v = 0; v < level.vertices; ++v) {
                view.look(v, places, next.points);
                co_yield Step("vertex")
                    .vertex(v, Role::Current, "v")
                    .ring(ElementKind::Vertex, Role::Neighbour, view.ring)
                    .point(glm::vec3(view.q), Role::Neighbour, "Q")
                    .point(glm::vec3(view.r), Role::Neighbour, "R")
                    .point(next.points[v], Role::New, "p")
                    .number("level", double(n))
                    .number("valence", double(view.ring.size()))
                    .number("rule", view.rule)
                    .number("moved", glm::distance(glm::dvec3(next.points[v]), glm::dvec3(places[v])))
                    .progress(done + share * (0.5 + 0.4 * v / double(level.vertices)));
            }
        }
        const bool last = n == parameters.levels;
        CatmullLevel finer = level.refined(last);
        const size_t faces = finer.faces();
        refinement.refine(originsOf(level, creases), pointsOf, last);
        places = std::move(next.points);
        if (stage.watched() || last) mesh = refinement.mesh(finer, places, 4, last);
        if (!stage.watched()) refinement.keep(std::move(level));
        level = std::move(finer);
        co_yield Step("split")
            .number("level", double(n))
            .number("vertices", double(level.vertices))
            .number("faces", double(faces))
            .progress(double(n) * share);
    }
    if (!stage.watched() && mesh.faceCount() > 0) refinement.remember(remembered(), key, mesh);
    stage.finish(std::move(mesh));
}

}  // namespace mw
