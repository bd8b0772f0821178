// A point and a triangle: signed distance, foot, inclusion, closest point. Book 3.4.1, (3.51)-(3.56).
#pragma once
#include "core/math/closest.h"
#include "core/math/measure.h"

namespace mw {

/// With t1, t2, t3 as (3.56) has them, the sides AB, BC, CA in turn.
struct PointTriangle {
    glm::dvec3 normal{0};  ///< unit (3.52); 0 when the triangle has no area: then only `closest` says anything
    double distance = 0;   ///< D: above the plane where the normal points to (3.53)
    glm::dvec3 foot{0};    ///< Q on the plane (3.55)
    glm::dvec3 t{0};
    bool inside = false;    ///< Q in the triangle: no two of t have opposite signs
    glm::dvec3 weights{0};  ///< barycentric coordinates of Q (3.31)
    glm::dvec3 closest{0};  ///< of the triangle to P: Q when it is inside, else on the nearest side
};

inline PointTriangle pointTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    PointTriangle r;
    const glm::dvec3 n = glm::cross(b - a, c - a), w = closestOnTriangle(p, a, b, c);
    const double twice = glm::length(n);
    r.closest = w.x * a + w.y * b + w.z * c;
    if (!(twice > 0)) return r;
    r.normal = n / twice;
    r.distance = glm::dot(p - a, r.normal);
    r.foot = p - r.distance * r.normal;
    r.t = {glm::dot(glm::cross(b - a, r.foot - a), n), glm::dot(glm::cross(c - b, r.foot - b), n), glm::dot(glm::cross(a - c, r.foot - c), n)};
    const bool below = r.t.x < 0 || r.t.y < 0 || r.t.z<0, above = r.t.x> 0 || r.t.y > 0 || r.t.z > 0;
    r.inside = !(below && above);
    r.weights = barycentric(p, a, b, c);
    return r;
}

}  // namespace mw
