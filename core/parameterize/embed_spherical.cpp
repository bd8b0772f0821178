// Start, then rounds of relaxation with a check of every face that a move concerns.
#include "core/parameterize/embed_spherical.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "core/error.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/parameterize/sphere_hierarchy.h"

namespace mw {
namespace {

constexpr double pi = std::numbers::pi;
constexpr uint32_t pause = 1 << 12;  // vertices between two looks at whether to go on

void expectSphere(const Mesh& mesh)
{
    const auto refuse = [](const std::string& why) { throw Error("Spherical embedding needs a closed mesh without holes, but this one " + why); };
    const TopologyReport& t = mesh.topology();
    if (mesh.faceCount() == 0) refuse("has no faces. Add some first.");
    if (!t.degenerateFaces.empty()) refuse("has faces with fewer than three different corners. Add Repair before it.");
    if (!t.manifold()) refuse("is not a manifold. Add Repair before it.");
    if (!t.consistentlyOriented) refuse("has neighbouring faces turned against each other. Add Orient faces before it.");
    if (t.components > 1) refuse("has " + std::to_string(t.components) + " pieces. Keep one of them, or separate them into objects.");
    if (!t.closed) refuse("is open. Add Fill holes before it, or use Planar embedding.");
    if (t.euler != 2) refuse("has genus " + std::to_string(1 - t.euler / 2) + ". Cut it open and use Planar embedding.");
}

class Globe {
public:
    Globe(const Mesh& mesh, const EmbedSpherical& p)
        : mesh_(mesh),
          how_(p),
          triangles_(mesh.isTriangles() ? mesh : Mesh::triangles(mesh.positions(), mesh.triangulation().vertices)),
          rings_(orderedRings(triangles_)),
          weights_(edgeWeights(triangles_, p.weights)),
          places(mesh.vertexCount(), glm::dvec3(0))
    {
        double n = 0;
        for (uint32_t v = 0; v < rings_.size(); ++v) {
            if (rings_[v].empty()) continue;
            centre_ += glm::dvec3(mesh.positions()[v]);
            ++n;
        }
        count_ = n;
        centre_ /= n;
        least_ = 1e-4 * 8 * pi / double(triangles_.faceCount());
    }
    bool used(uint32_t v) const { return !rings_[v].empty(); }
    const std::vector<uint32_t>& ring(uint32_t v) const { return rings_[v]; }
    const Mesh& triangles() const { return triangles_; }

    void project(uint32_t v)
    {
        const glm::dvec3 d = glm::dvec3(mesh_.positions()[v]) - centre_;
        const double length = glm::length(d);
        places[v] = length > 0 ? d / length : glm::dvec3(0, 0, 1);
    }
    /// How far it went.
    double relax(uint32_t v)
    {
        const Rings& rings = triangles_.rings();
        glm::dvec3 sum(0);
        double all = 0;
        for (uint32_t k = rings.neighbourStart[v]; k < rings.neighbourStart[v + 1]; ++k) {
            sum += weights_[k] * places[rings.neighbour[k]];
            all += weights_[k];
        }
        const glm::dvec3 mean = all > 0 ? sum / all : places[v];
        if (guarded()) return moveOnSphere(places, v, rings_[v], mean, least_);
        const double length = glm::length(mean);
        if (!(length > 1e-12)) return 0;
        const glm::dvec3 from = places[v];
        places[v] = mean / length;
        return glm::length(places[v] - from);
    }
    glm::dvec3 mean() const
    {
        glm::dvec3 sum(0);
        for (const glm::dvec3& p : places) sum += p;
        return sum / count_;
    }
    /// As far as no face turns over, when that is asked for. The distance from the centre before.
    double recentre()
    {
        const glm::dvec3 offset = mean();
        std::vector<glm::dvec3> moved(places.size());
        for (double share = 1; share > 0.01; share /= 2) {
            bool fits = true;
            for (uint32_t v = 0; v < places.size(); ++v) {
                const glm::dvec3 p = places[v] - share * offset;
                const double length = glm::length(p);
                moved[v] = !used(v) ? places[v] : length > 1e-9 ? p / length : places[v];
            }
            if (guarded()) fits = keepsFaces(moved);
            if (!fits) continue;
            places.swap(moved);
            break;
        }
        return glm::length(offset);
    }
    bool guarded() const { return how_.start == EmbedSpherical::Start::Hierarchy; }
    Mesh asItStands() const;
    Mesh result(const std::vector<uint32_t>& folded) const;

private:
    bool keepsFaces(const std::vector<glm::dvec3>& moved) const
    {
        const auto& t = triangles_.cornerVertex();
        const auto twice = [&](const std::vector<glm::dvec3>& p, size_t i) { return glm::dot(p[t[i]], glm::cross(p[t[i + 1]], p[t[i + 2]])); };
        for (size_t i = 0; i < t.size(); i += 3) {
            const double now = twice(moved, i);
            if (now < least_ && (now <= 0 || now < 0.5 * twice(places, i))) return false;
        }
        return true;
    }

    Mesh mesh_;
    EmbedSpherical how_;
    Mesh triangles_;
    std::vector<std::vector<uint32_t>> rings_;
    Array<double> weights_;
    glm::dvec3 centre_{0};
    double count_ = 0, least_ = 0;

public:
    std::vector<glm::dvec3> places;
};

/// Longitudes of a face follow each other without a jump; where one is at a pole, it has the mean of the others.
void addCorners(const Mesh& mesh, size_t f, std::span<const glm::dvec3> places, Array<float>& out)
{
    const auto face = mesh.face(f);
    std::vector<glm::dvec2> at;
    double sum = 0, first = 0;
    size_t n = 0;
    for (const uint32_t v : face) {
        const glm::dvec3& p = places[v];
        glm::dvec2 c = sphericalCoordinates(p);
        const bool pole = std::hypot(p.x, p.z) < 1e-7;
        if (!pole) {
            if (n == 0) first = c.x;
            if (c.x - first > pi) c.x -= 2 * pi;
            if (c.x - first < -pi) c.x += 2 * pi;
            sum += c.x;
            ++n;
        }
        at.push_back({pole ? std::nan("") : c.x, c.y});
    }
    double lowest = 0;
    for (glm::dvec2& c : at) {
        if (std::isnan(c.x)) c.x = n ? sum / double(n) : 0;
        lowest = std::min(lowest, c.x);
    }
    for (const glm::dvec2& c : at) {
        out.push_back(float((c.x + (lowest < -1e-12 ? 2 * pi : 0)) / (2 * pi)));
        out.push_back(float(c.y / pi + 0.5));
    }
}

Mesh Globe::asItStands() const
{
    Array<float> t;
    t.reserve(2 * mesh_.cornerCount());
    for (size_t f = 0; f < mesh_.faceCount(); ++f) addCorners(mesh_, f, places, t);
    const Mesh textured = mesh_.with(floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(t)));
    if (how_.output == EmbedSpherical::Output::Texture) return textured;
    const double radius = std::sqrt(surfaceArea(mesh_) / (4 * pi));
    Array<glm::vec3> positions(mesh_.positions().begin(), mesh_.positions().end());
    for (uint32_t v = 0; v < positions.size(); ++v)
        if (used(v)) positions[v] = glm::vec3(centre_ + radius * places[v]);
    return textured.withPositions(std::move(positions)).without(names::normal).without(names::tangent);
}

Mesh Globe::result(const std::vector<uint32_t>& folded) const
{
    const Mesh out = asItStands().without("folded");
    if (folded.empty()) return out;
    Array<int32_t> flags(mesh_.faceCount(), 0);
    for (const uint32_t f : folded) flags[f] = 1;
    return out.with(integerAttribute("folded", Domain::Face, 1, std::move(flags)));
}

}  // namespace

glm::dvec2 sphericalCoordinates(const glm::dvec3& d)
{
    const double alpha = std::atan2(d.x, d.z);
    return {alpha < 0 ? alpha + 2 * pi : alpha, std::atan2(d.y, std::hypot(d.x, d.z))};
}

std::vector<uint32_t> foldedFaces(const Mesh& mesh, std::span<const glm::dvec3> places)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    std::vector<uint32_t> out;
    for (size_t t = 0; t < cut.faces.size(); ++t) {
        const uint32_t* v = cut.vertices.data() + 3 * t;
        if (glm::dot(places[v[0]], glm::cross(places[v[1]], places[v[2]])) > 0) continue;
        if (out.empty() || out.back() != cut.faces[t]) out.push_back(cut.faces[t]);
    }
    return out;
}

namespace {

/// The operation, or with `places` only where the vertices lie.
Generator layOut(Mesh input, EmbedSpherical p, Stage<Mesh>& stage, std::vector<glm::dvec3>* places)
{
    co_yield Step("remove").progress(0);
    expectSphere(input);
    Globe globe(input, p);
    stage.show([&] { return globe.asItStands(); });
    const uint32_t n = uint32_t(input.vertexCount());
    if (globe.guarded()) {
        SphereHierarchy hierarchy(globe.triangles());
        stage.show([&] { return input; });
        const double all = double(hierarchy.left());
        for (uint32_t i = 0; hierarchy.removeNext(); ++i)
            if (stage.watched() || i % pause == 0)
                co_yield Step("remove")
                    .vertex(hierarchy.vertex(), Role::Removed, "u")
                    .vertex(hierarchy.ring()[0], Role::Current, "v")
                    .ring(ElementKind::Vertex, Role::Neighbour, hierarchy.ring())
                    .number("left", double(hierarchy.left()))
                    .number("valence", double(hierarchy.ring().size()))
                    .progress(0.2 * (1 - double(hierarchy.left()) / all));
        stage.show([&] {
            globe.places = hierarchy.places();
            return globe.asItStands();
        });
        for (uint32_t i = 0; hierarchy.insertNext(); ++i) {
            const double done = 0.2 + 0.4 * double(hierarchy.left()) / all;
            if (stage.watched() || i % pause == 0)
                co_yield Step("insert")
                    .vertex(hierarchy.vertex(), Role::New, "u")
                    .ring(ElementKind::Vertex, Role::Neighbour, hierarchy.ring())
                    .number("placed", double(hierarchy.left()))
                    .number("room", hierarchy.room() * 180 / pi)
                    .progress(done);
            while (!stage.watched() && hierarchy.evenOut()) co_yield Step("insert").progress(done);
        }
        stage.show([&] { return globe.asItStands(); });
        globe.places = hierarchy.takePlaces();
    }
    for (uint32_t v = 0; v < n && !globe.guarded(); ++v) {
        if (!globe.used(v)) continue;
        globe.project(v);
        const glm::dvec2 at = sphericalCoordinates(globe.places[v]);
        if (stage.watched() || v % pause == 0)
            co_yield Step("project")
                .vertex(v, Role::Current, "V")
                .number("alpha", at.x * 180 / pi)
                .number("delta", at.y * 180 / pi)
                .progress(0.6 * double(v) / n);
    }

    int64_t rounds = 0;
    for (double largest = p.tolerance; largest >= p.tolerance && rounds < p.iterations; ++rounds) {
        largest = 0;
        const double done = 0.6 + 0.4 * double(rounds) / double(p.iterations);
        for (uint32_t v = 0; v < n; ++v) {
            if (!globe.used(v)) continue;
            const double moved = globe.relax(v);
            largest = std::max(largest, moved);
            if (stage.watched() || v % pause == pause - 1)
                co_yield Step("move")
                    .vertex(v, Role::Current, "P")
                    .ring(ElementKind::Vertex, Role::Neighbour, globe.ring(v))
                    .number("round", double(rounds + 1))
                    .number("moved", moved)
                    .progress(done);
        }
        const double offset = globe.recentre();
        const size_t folded = stage.watched() ? foldedFaces(input, globe.places).size() : 0;
        co_yield Step("round")
            .number("round", double(rounds + 1))
            .number("largest", largest)
            .number("offset", offset)
            .number("folded", double(folded))
            .progress(done);
    }
    if (places) {
        *places = std::move(globe.places);
        co_return;
    }
    const std::vector<uint32_t> folded = foldedFaces(input, globe.places);
    co_yield Step("result")
        .ring(ElementKind::Face, Role::Rejected, folded)
        .number("rounds", double(rounds))
        .number("folded", double(folded.size()))
        .progress(1);
    stage.finish(globe.result(folded));
}

}  // namespace

Generator embedSpherical(Mesh input, EmbedSpherical p, Stage<Mesh>& stage)
{
    return layOut(std::move(input), p, stage, nullptr);
}

Generator sphericalEmbedding(Mesh mesh, EmbedSpherical p, std::vector<glm::dvec3>& places)
{
    Stage<Mesh> unwatched(false);
    Generator all = layOut(std::move(mesh), p, unwatched, &places);
    while (all.next()) co_yield all.step();
}

std::vector<glm::dvec3> sphericalEmbedding(const Mesh& mesh, EdgeWeights weights, int64_t rounds)
{
    EmbedSpherical p;
    p.weights = weights;
    p.iterations = rounds;
    std::vector<glm::dvec3> places;
    Generator all = sphericalEmbedding(mesh, p, places);
    while (all.next()) {
    }
    return places;
}

}  // namespace mw
