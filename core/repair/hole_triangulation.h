// Triangles that close a loop in space.
#pragma once
#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace mw {

/// A closed polygon in space, the hole on its left, and what is round it.
struct HoleOutline {
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> normals;                  ///< unit, of the face beyond edge i (point i to i + 1); 0 where there is none
    std::function<bool(uint32_t, uint32_t)> allowed;  ///< may there be an edge between these two points?
    bool isFace = false;                              ///< three points that are a face already: it must not be doubled
};

using Triple = std::array<uint32_t, 3>;  ///< numbers of points, running as the outline does

double areaOf(const HoleOutline& hole, const Triple& t);

/// The triangulation whose sharpest bend (between its triangles and to the faces round it) is least, and of those the one of least area:
/// dynamic programming over the gaps between two points (Barequet and Sharir 1995; Liepa 2003). O(n^3) time, O(n^2) memory, so row by row.
/// Bends are compared in steps of 0.0001 of 1 - cos, so that in a flat hole the area decides.
class LeastBend {
public:
    explicit LeastBend(const HoleOutline& hole, bool wanted = true);  ///< not wanted: no rows, not possible
    size_t rows() const { return n_ < 3 ? 0 : n_ - 2; }
    void row(size_t k);  ///< all pairs of points k + 2 apart; in order from 0
    bool possible() const;
    std::vector<Triple> triangles() const;  ///< from the first edge inwards
    double bend(const Triple& t) const;     ///< degrees, the sharper one at its two sides away from i..j

private:
    struct Weight {
        int32_t bend = -1;  // -1: not possible
        uint32_t split = 0;
        double area = 0;
    };
    Weight& at(size_t i, size_t j) { return weight_[i * n_ + j]; }
    const Weight& at(size_t i, size_t j) const { return weight_[i * n_ + j]; }
    glm::dvec3 normal(size_t i, size_t m, size_t j) const;
    glm::dvec3 beyond(size_t i, size_t j) const;
    void fill(size_t i, size_t j);

    const HoleOutline& hole_;
    size_t n_;
    std::vector<Weight> weight_;
    std::vector<glm::dvec3> beyond_;  // normal of the triangle that closes i..j
};

/// For outlines too large for that: cuts off the ear of least angle, again and again. O(n log n). Empty when edges that exist already leave no way.
std::vector<Triple> clippedEars(const HoleOutline& hole);

}  // namespace mw
