// What is measured between points: angle, area, barycentric coordinates.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mw {

/// Between the directions from `at` to a and to b, radians, 0 to pi; 0 where one of them has no length. Accurate at 0 and at pi as well.
inline double angleAt(const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 u = a - at, v = b - at;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

inline double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Weights of a, b, c whose sum is 1 and whose mix is p projected onto the plane of the triangle (3.29); all NaN when it has no area.
inline glm::dvec3 barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double square = glm::dot(n, n);
    if (square == 0) return glm::dvec3(std::nan(""));
    const double v = glm::dot(glm::cross(p - a, c - a), n) / square, w = glm::dot(glm::cross(b - a, p - a), n) / square;
    return {1 - v - w, v, w};
}

}  // namespace mw
