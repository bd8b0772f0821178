// Triangle by triangle: each adds to the six directed edges round it.
#include "core/parameterize/edge_weights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/rings.h"

namespace mw {
namespace {

constexpr double leastSine = 1e-6;

/// An angle by its cosine and sine times the lengths of its legs.
struct Angle {
    double cosine, sine, legs;
    double cotangent() const { return cosine / sine; }
    double halfTangent() const { return sine / (legs + cosine); }
};

Angle angleBetween(const glm::dvec3& u, const glm::dvec3& v)
{
    const double legs = std::max(std::sqrt(glm::dot(u, u) * glm::dot(v, v)), 1e-300);
    return {glm::dot(u, v), std::max(glm::length(glm::cross(u, v)), leastSine * legs), legs};
}

class Adding {
public:
    Adding(const Mesh& mesh, EdgeWeights kind) : mesh_(mesh), rings_(mesh.rings()), kind_(kind), out(rings_.neighbour.size(), 0.0)
    {
        shortest_ = std::max(1e-9 * mesh.bounds().diagonal(), 1e-300);
    }
    /// What triangle i, j, k gives to the springs i to j and i to k.
    void triangle(uint32_t i, uint32_t j, uint32_t k)
    {
        const glm::dvec3 a(mesh_.positions()[i]), b(mesh_.positions()[j]), c(mesh_.positions()[k]);
        const glm::dvec3 ab = b - a, ac = c - a, bc = c - b;
        if (kind_ == EdgeWeights::MeanValue) {
            const double tangent = angleBetween(ab, ac).halfTangent();
            add(i, j, tangent / length(ab));
            add(i, k, tangent / length(ac));
        } else {
            const double atJ = angleBetween(-ab, bc).cotangent(), atK = angleBetween(-ac, -bc).cotangent();
            const bool harmonic = kind_ == EdgeWeights::Harmonic;
            add(i, j, harmonic ? atK : atJ / (length(ab) * length(ab)));
            add(i, k, harmonic ? atJ : atK / (length(ac) * length(ac)));
        }
    }

private:
    double length(const glm::dvec3& v) const { return std::max(glm::length(v), shortest_); }
    void add(uint32_t from, uint32_t to, double w)
    {
        const auto ring = rings_.neighboursOf(from);
        const auto at = std::lower_bound(ring.begin(), ring.end(), to);
        if (at != ring.end() && *at == to) out[rings_.neighbourStart[from] + size_t(at - ring.begin())] += w;
    }

    const Mesh& mesh_;
    const Rings& rings_;
    EdgeWeights kind_;
    double shortest_ = 0;

public:
    Array<double> out;
};

}  // namespace

Array<double> edgeWeights(const Mesh& mesh, EdgeWeights kind)
{
    if (kind == EdgeWeights::Uniform) return Array<double>(mesh.rings().neighbour.size(), 1.0);
    Adding weights(mesh, kind);
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto t = mesh.face(f);
        if (t.size() != 3 || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (size_t k = 0; k < 3; ++k) weights.triangle(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    return std::move(weights.out);
}

}  // namespace mw
