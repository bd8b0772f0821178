// Euler angles of a rotation: some, or those nearest to what was shown before.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace mw {

/// Radians about X, then Y, then Z, as glm::dquat(angles) takes them; exact also where Y is a right angle (Z is then 0).
inline glm::dvec3 eulerAnglesOf(const glm::dquat& q)
{
    const glm::dmat3 m = glm::mat3_cast(glm::normalize(q));
    const double cosine = std::hypot(m[0][0], m[0][1]);
    const double y = std::atan2(-m[0][2], cosine);
    if (cosine < 1e-9) return {std::atan2(-m[2][1], m[1][1]), y, 0};
    return {std::atan2(m[1][2], m[2][2]), y, std::atan2(m[0][1], m[0][0])};
}

/// Degrees, so that dquat(radians(result)) is `rotation` (or its negative). Every turn counts: near {0, 0, 350} it says 350 and not -10.
inline glm::dvec3 eulerDegreesNear(const glm::dquat& rotation, glm::dvec3 near)
{
    // What was shown still holds, also where the Y angle is 90 and X and Z cannot be told apart.
    if (std::abs(std::abs(glm::dot(glm::normalize(rotation), glm::dquat(glm::radians(near)))) - 1) < 1e-12) return near;
    const glm::dvec3 e = glm::degrees(eulerAnglesOf(rotation));
    const auto turned = [&](glm::dvec3 a) {
        for (int i = 0; i < 3; ++i) a[i] += 360 * std::round((near[i] - a[i]) / 360);
        return a;
    };
    const glm::dvec3 one = turned(e), other = turned({e.x + 180, 180 - e.y, e.z + 180});
    return glm::distance(one, near) <= glm::distance(other, near) ? one : other;
}

}  // namespace mw
