#include "core/repair/smooth.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/mesh/rings.h"
#include "core/mesh/topology.h"

namespace mw {

namespace {

std::vector<bool> boundaryVertices(const Mesh& mesh)
{
    std::vector<bool> boundary(mesh.vertexCount());
    for (const std::vector<uint32_t>& loop : mesh.topology().boundaryLoops)
        for (uint32_t v : loop) boundary[v] = true;
    for (const auto& [a, b] : mesh.topology().nonmanifoldEdges) boundary[a] = boundary[b] = true;
    return boundary;
}

// One weight for each entry of rings.neighbour, summing to 1 round each vertex. They are those of the input: the operator stays linear.
class RingWeights {
public:
    RingWeights(const Mesh& mesh, Smooth::Weights kind) : rings_(mesh.rings()), weight_(rings_.neighbour.size(), 1.0)
    {
        if (kind == Smooth::Weights::Cotangent) addCotangents(mesh);
        for (uint32_t v = 0; v < mesh.vertexCount(); ++v) normalise(v);
    }
    double of(uint32_t v, size_t k) const { return weight_[rings_.neighbourStart[v] + k]; }

private:
    // Half the cotangents of the two angles that face the edge; negative ones count as 0, so that no vertex leaves the hull of its ring.
    void addCotangents(const Mesh& mesh)
    {
        std::fill(weight_.begin(), weight_.end(), 0.0);
        const Shared<uint32_t>& t = mesh.triangulation().vertices;
        for (size_t i = 0; i < t.size(); ++i) {
            const size_t f = i - i % 3;
            const uint32_t tip = t[i], a = t[f + (i + 1) % 3], b = t[f + (i + 2) % 3];
            const glm::dvec3 p(mesh.positions()[tip]), u = glm::dvec3(mesh.positions()[a]) - p, w = glm::dvec3(mesh.positions()[b]) - p;
            const double area = glm::length(glm::cross(u, w));
            const double half = area > 0 ? std::max(0.0, 0.5 * glm::dot(u, w) / area) : 0.0;
            add(a, b, half);
            add(b, a, half);
        }
    }
    void add(uint32_t from, uint32_t to, double w)
    {
        const auto ring = rings_.neighboursOf(from);
        const auto i = std::lower_bound(ring.begin(), ring.end(), to);
        if (i != ring.end() && *i == to) weight_[rings_.neighbourStart[from] + size_t(i - ring.begin())] += w;  // a cut of a polygon is no edge
    }
    void normalise(uint32_t v)
    {
        double* w = weight_.data() + rings_.neighbourStart[v];
        const size_t n = rings_.neighboursOf(v).size();
        double sum = 0;
        for (size_t k = 0; k < n; ++k) sum += w[k];
        for (size_t k = 0; k < n; ++k) w[k] = sum > 0 ? w[k] / sum : 1.0 / double(n);
    }

    const Rings& rings_;
    Array<double> weight_;
};

Mesh withPlaces(const Mesh& mesh, const Array<glm::dvec3>& places)
{
    Array<glm::vec3> positions(places.begin(), places.end());
    return mesh.withPositions(std::move(positions));
}

}  // namespace

Generator smooth(Mesh input, Smooth p, Stage<Mesh>& stage)
{
    const Mesh mesh = input.without(names::normal).without(names::tangent);
    const Rings& rings = mesh.rings();
    const RingWeights weights(mesh, p.weights);
    const std::vector<bool> fixed = p.fixBoundary ? boundaryVertices(mesh) : std::vector<bool>(mesh.vertexCount());
    Array<glm::dvec3> place(mesh.positions().begin(), mesh.positions().end()), next = place;
    stage.show([&] { return withPlaces(mesh, next); });

    const double mu = p.lambda > 0 ? 1 / (p.passBand - 1 / p.lambda) : 0;  // 1/lambda + 1/mu = pass band
    const int64_t rounds = p.method == Smooth::Method::Taubin ? 2 * p.iterations : p.iterations;
    for (int64_t round = 0; round < rounds; ++round) {
        const bool inflating = p.method == Smooth::Method::Taubin && round % 2 == 1;
        const double size = inflating ? mu : p.lambda;
        const char* phase = inflating ? "inflate" : "shrink";
        double moved = 0;
        for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            const auto ring = rings.neighboursOf(v);
            if (fixed[v] || ring.empty()) continue;
            glm::dvec3 mean(0);
            for (size_t k = 0; k < ring.size(); ++k) mean += weights.of(v, k) * place[ring[k]];
            next[v] = place[v] + size * (mean - place[v]);
            const double distance = glm::length(next[v] - place[v]);
            moved = std::max(moved, distance);
            const double done = (double(round) + double(v) / double(mesh.vertexCount())) / double(rounds);
            if (stage.watched() || (v & 4095) == 0)
                co_yield Step(phase)
                    .vertex(v, Role::Current, "v")
                    .ring(ElementKind::Vertex, Role::Neighbour, ring)
                    .point(glm::vec3(mean), Role::New, "m")
                    .number("round", double(round + 1))
                    .number("size", size)
                    .number("valence", double(ring.size()))
                    .number("distance", distance)
                    .progress(done);
        }
        place = next;
        co_yield Step("round").number("round", double(round + 1)).number("largest", moved).progress(double(round + 1) / double(rounds));
    }
    stage.finish(withPlaces(mesh, place));
}

}  // namespace mw
