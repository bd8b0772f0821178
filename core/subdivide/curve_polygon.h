// What the schemes for curves share: a polygon that goes on beyond its ends, and what is checked and measured.
#pragma once
#include "core/mesh/curve.h"

namespace mw::curves {

inline constexpr size_t mostPoints = 4'000'000;

using Points = Array<glm::dvec3>;

/// A polygon that goes on beyond its ends as its reflection in the end point: what lies there is smooth whatever the weights.
class Polygon {
public:
    Polygon(const Points& points, bool closed) : p_(points), closed_(closed) {}
    glm::dvec3 at(int64_t i) const
    {
        const auto n = int64_t(p_.size());
        if (closed_) return p_[size_t((i % n + n) % n)];
        if (i < 0) return 2.0 * p_.front() - at(-i);
        if (i >= n) return 2.0 * p_.back() - at(2 * (n - 1) - i);
        return p_[size_t(i)];
    }
    /// An inner one of an open polygon, any of a closed one.
    bool moves(size_t i) const { return closed_ || (i > 0 && i + 1 < p_.size()); }

private:
    const Points& p_;
    bool closed_;
};

size_t segments(size_t points, bool closed);
/// The greatest angle between neighbouring segments, degrees: what is left of the kinks.
double greatestKink(const Points& p, bool closed);
/// Throws Error when there are too few points, or when there would be too many.
void check(const Curve& input, bool closed, int64_t levels);

}  // namespace mw::curves
