// Nearest points.
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mw {

/// Barycentric weights of the point of triangle a b c nearest to p; each is 0 to 1, exactly so at corners and sides (Ericson 2005, 5.1.5).
inline glm::dvec3 closestOnTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp), d5 = glm::dot(ab, cp),
                 d6 = glm::dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double t = d1 > d3 ? d1 / (d1 - d3) : 0;
        return {1 - t, t, 0};
    }
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double t = d2 > d6 ? d2 / (d2 - d6) : 0;
        return {1 - t, 0, t};
    }
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const double span = (d4 - d3) + (d5 - d6), t = span > 0 ? (d4 - d3) / span : 0;
        return {0, 1 - t, t};
    }
    const double q = 1 / (va + vb + vc), v = vb * q, w = vc * q;
    return {1 - v - w, v, w};
}

}  // namespace mw
