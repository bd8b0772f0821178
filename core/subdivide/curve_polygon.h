// What the schemes for curves share: a polygon that goes on beyond its ends, and what is checked and measured.
#pragma once
#include "core/steps/step.h"
#include "core/subdivide/subdivide_curve.h"

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

/// The points of a level and those of the next, as far as they are made.
class Refining {
public:
    /// Throws Error when there are too few points, or when there would be too many.
    Refining(const Curve& input, const SubdivideCurve& how);

    Points old, fresh;
    size_t taken = 0;  ///< points of `old` that `fresh` stands for
    const bool closed;

    /// Refined so far, and the rest as it was.
    Curve asItStands() const;
    /// After the last point of a level. `measured`: the step says how kinked the curve still is.
    Step endLevel(int64_t level, bool measured);
    /// After the last level.
    Curve result() { return {std::move(old), control_, closed}; }
    /// How far the run is at point i of a level.
    double done(int64_t level, size_t i) const { return (double(level - 1) + double(i) / double(old.size())) / double(levels_); }

private:
    Points control_;
    int64_t levels_;
};

}  // namespace mw::curves
