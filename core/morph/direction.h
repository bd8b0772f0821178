// Directions from a centre as whole numbers: on which side of an arc a point lies is then decided exactly, in 128 bits.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mw {

__extension__ typedef __int128 Wide;

/// About 2^41 long on the sphere; a point of the plane is (x, y, 1) times that, with x and y within -1 to 1. Two are the same place when they are
/// parallel. 3 * 41 bits and six terms fit in 127 bits.
struct Direction {
    int64_t x = 0, y = 0, z = 0;
    static constexpr double unit = 2199023255552.0;  // 2^41

    static Direction rounded(const glm::dvec3& p)
    {
        return {int64_t(std::llround(p.x * unit)), int64_t(std::llround(p.y * unit)), int64_t(std::llround(p.z * unit))};
    }
    static Direction onSphere(const glm::dvec3& p) { return rounded(glm::normalize(p)); }
    static Direction inPlane(double x, double y) { return rounded({x, y, 1}); }
    glm::dvec3 point() const { return glm::dvec3(double(x), double(y), double(z)) / unit; }
    bool operator==(const Direction&) const = default;
};

inline Wide determinant(const Direction& a, const Direction& b, const Direction& c)
{
    return (Wide(b.y) * c.z - Wide(b.z) * c.y) * a.x + (Wide(b.z) * c.x - Wide(b.x) * c.z) * a.y + (Wide(b.x) * c.y - Wide(b.y) * c.x) * a.z;
}

/// Where c lies beside the arc (or line) from a to b, seen from outside: 1 left, -1 right, 0 on its circle.
inline int side(const Direction& a, const Direction& b, const Direction& c)
{
    const double p = double(b.y) * double(c.z), q = double(b.z) * double(c.y), r = double(b.z) * double(c.x), s = double(b.x) * double(c.z),
                 t = double(b.x) * double(c.y), u = double(b.y) * double(c.x);
    const double det = (p - q) * double(a.x) + (r - s) * double(a.y) + (t - u) * double(a.z);
    const double size = (std::abs(p) + std::abs(q)) * std::abs(double(a.x)) + (std::abs(r) + std::abs(s)) * std::abs(double(a.y)) +
                        (std::abs(t) + std::abs(u)) * std::abs(double(a.z));
    if (std::abs(det) > 1e-15 * size) return det > 0 ? 1 : -1;  // nine roundings at most
    const Wide exact = determinant(a, b, c);
    return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

}  // namespace mw
