// Triangles for the hole that a vertex leaves: its ring, seen along the average normal, is a star round the place of the vertex; ears are cut off.
// Book 3.1.2.
#pragma once
#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace mw {

struct StarHole {
    std::vector<glm::dvec3> points;                   ///< the ring, anticlockwise round the normal
    bool open = false;                                ///< the edge from the last point to the first was not there: the vertex was on the border
    glm::dvec3 apex{0};                               ///< the vertex
    glm::dvec3 normal{0};                             ///< unit: the average
    std::vector<glm::dvec3> beyond;                   ///< unit normal of the face beyond the edge that starts at point i; 0 where there is none
    std::function<bool(uint32_t, uint32_t)> allowed;  ///< may there be a new edge between these two points?
};

/// Why there are no triangles. The order is that of the lesson's words.
enum class NoFilling : uint8_t { None, NotStar, Exists, Fold };

struct Filling {
    NoFilling why = NoFilling::None;
    std::vector<std::array<uint32_t, 3>> triangles;  ///< numbers of points, as the ring runs
    double leastAngle = 0;                           ///< degrees
};

/// Of all ears the one whose least angle is greatest, again and again; ties by number. `turn` is the least cosine between the average normal and
/// that of a new triangle; new triangles and their neighbours never meet at more than 90 degrees. O(n^3).
Filling filled(const StarHole& hole, double turn);

}  // namespace mw
