#include "core/morph/star_centre.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace mw {

namespace {

struct Plane {
    glm::dvec3 normal;
    double offset;
};

glm::dvec3 centreOfVolume(std::span<const glm::dvec3> p, std::span<const uint32_t> t)
{
    glm::dvec3 mean(0), sum(0);
    for (const glm::dvec3& v : p) mean += v / double(p.size());
    double volume = 0;
    for (size_t i = 0; i < t.size(); i += 3) {
        const glm::dvec3 a = p[t[i]] - mean, b = p[t[i + 1]] - mean, c = p[t[i + 2]] - mean;
        const double six = glm::dot(a, glm::cross(b, c));
        volume += six;
        sum += six * (a + b + c) / 4.0;
    }
    return volume > 0 ? mean + sum / volume : mean;
}

}  // namespace

std::optional<glm::dvec3> starCentre(std::span<const glm::dvec3> positions, std::span<const uint32_t> triangles)
{
    constexpr int mostRounds = 300;
    if (positions.empty()) return std::nullopt;
    glm::dvec3 low = positions[0], high = low;
    for (const glm::dvec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
    const double size = glm::distance(low, high);
    std::vector<Plane> planes;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        const glm::dvec3 &a = positions[triangles[i]], n = glm::cross(positions[triangles[i + 1]] - a, positions[triangles[i + 2]] - a);
        const double length = glm::length(n);
        if (!(length > 1e-14 * size * size)) return std::nullopt;  // seen from the edge wherever one stands
        planes.push_back({n / length, glm::dot(n, a) / length});
    }
    glm::dvec3 c = centreOfVolume(positions, triangles);
    const double margin = 1e-4 * size;
    for (int round = 0; round < mostRounds; ++round) {
        double worst = -std::numeric_limits<double>::infinity();
        const Plane* at = nullptr;
        for (const Plane& p : planes)
            if (const double d = glm::dot(p.normal, c) - p.offset; d > worst) worst = d, at = &p;
        if (worst < (round == 0 ? -1e-6 * size : -0.5 * margin)) return c;
        c -= (worst + margin) * 1.5 * at->normal;
    }
    return std::nullopt;
}

}  // namespace mw
