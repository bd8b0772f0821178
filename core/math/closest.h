// Nearest points.
#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mw {

/// How far along the segment from a to b its point nearest to p lies, 0 to 1.
inline double closestOnSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 ab = b - a;
    const double square = glm::dot(ab, ab);
    return square > 0 ? glm::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0;
}

/// Barycentric weights of the point nearest to p on the sides of triangle a b c.
inline glm::dvec3 closestOnSides(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 corner[] = {a, b, c};
    double least = 0;
    glm::dvec3 best(1, 0, 0);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const double t = closestOnSegment(p, corner[k], corner[next]);
        const glm::dvec3 gap = corner[k] + t * (corner[next] - corner[k]) - p;
        const double d = glm::dot(gap, gap);
        if (k > 0 && d >= least) continue;
        least = d;
        best = glm::dvec3(0);
        best[k] = 1 - t;
        best[next] = t;
    }
    return best;
}

/// closestOnTriangle() where an angle is below 0.006 degrees or there is no area: products of dot products, as used there, would lose all digits.
inline glm::dvec3 closestOnSliver(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double square = glm::dot(n, n), v = glm::dot(glm::cross(p - a, c - a), n), w = glm::dot(glm::cross(b - a, p - a), n);
    const bool inside = square > 0 && v >= 0 && w >= 0 && v + w <= square;
    return inside ? glm::dvec3(1 - (v + w) / square, v / square, w / square) : closestOnSides(p, a, b, c);
}

/// Barycentric weights of the point of triangle a b c nearest to p; each is 0 to 1, exactly so at corners and sides (Ericson 2005, 5.1.5).
inline glm::dvec3 closestOnTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const glm::dvec3 n = glm::cross(ab, ac);
    if (!(glm::dot(n, n) > 1e-8 * glm::dot(ab, ab) * glm::dot(ac, ac))) return closestOnSliver(p, a, b, c);
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
