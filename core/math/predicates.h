// On which side does a point lie? Exactly, whatever the rounding.
#pragma once
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace mw {

/// Sign of the determinant of a-d, b-d, c-d: 1 when d lies below the plane of a, b, c (they run anticlockwise seen from above), -1 above it,
/// 0 on it. Filtered as by Shewchuk (1997): nearly always one determinant in double decides, else expansions do. Finite inputs.
int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);
/// 1 when a, b, c run anticlockwise, -1 clockwise, 0 on one line.
int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);

/// The slow way of the same, for tests too.
int exactOrientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);
int exactOrientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);

inline int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    const double ax = double(a.x) - d.x, ay = double(a.y) - d.y, az = double(a.z) - d.z;
    const double bx = double(b.x) - d.x, by = double(b.y) - d.y, bz = double(b.z) - d.z;
    const double cx = double(c.x) - d.x, cy = double(c.y) - d.y, cz = double(c.z) - d.z;
    const double bc1 = bx * cy, bc2 = cx * by, ca1 = cx * ay, ca2 = ax * cy, ab1 = ax * by, ab2 = bx * ay;
    const double det = az * (bc1 - bc2) + bz * (ca1 - ca2) + cz * (ab1 - ab2);
    const double size = (std::abs(bc1) + std::abs(bc2)) * std::abs(az) + (std::abs(ca1) + std::abs(ca2)) * std::abs(bz) +
                        (std::abs(ab1) + std::abs(ab2)) * std::abs(cz);
    const double bound = 7.8e-16 * size;  // (7 + 56 e) e, e = 2^-53
    if (det > bound) return 1;
    if (-det > bound) return -1;
    return size == 0 ? 0 : exactOrientation(a, b, c, d);  // products of floats do not vanish in double
}

inline int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c)
{
    const double left = (double(a.x) - c.x) * (double(b.y) - c.y), right = (double(a.y) - c.y) * (double(b.x) - c.x);
    const double det = left - right, bound = 3.4e-16 * (std::abs(left) + std::abs(right));  // (3 + 16 e) e
    if (det > bound) return 1;
    if (-det > bound) return -1;
    return left == 0 && right == 0 ? 0 : exactOrientation(a, b, c);
}

}  // namespace mw
