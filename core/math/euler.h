// Euler angles of a rotation.
#pragma once
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

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

}  // namespace mw
