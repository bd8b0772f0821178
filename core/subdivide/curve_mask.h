// Curves by any stationary mask.
#pragma once
#include "core/subdivide/subdivide_curve.h"

namespace mw {

struct CurveMask {
    std::vector<double> old, fresh;
    /// Where the weights of an old or a new point begin, from the point or the segment's first point.
    int64_t oldFrom() const { return -int64_t(old.size() / 2); }
    int64_t freshFrom() const { return fresh.size() % 2 ? -int64_t(fresh.size() / 2) : 1 - int64_t(fresh.size() / 2); }
};

/// subdivideCurve() with scheme=mask. Throws Error when the old points have an even number of weights.
Generator byMask(Curve input, SubdivideCurve p, CurveMask mask, Stage<Curve>& stage);

}  // namespace mw
