// Curves by subdivision of a polygon: interpolating and approximating masks, and a bad one to compare with.
#pragma once
#include "core/mesh/curve.h"
#include "core/steps/stage.h"

namespace mw {

/// Book section 3.2. Each level doubles the segments.
///   four-point  old points stay, new = -w P(i-1) + (1/2 + w)(P(i) + P(i+1)) - w P(i+2)  (3.17); w = 1/16 repeats every cubic
///   positive    the same with all weights positive, 1/8 3/8 3/8 1/8 (3.16): goes through the points, but its slope never settles
///   b-spline    old points move to (P(i-1) + 6 P(i) + P(i+1))/8, new ones are middles (3.18)-(3.20): the cubic B-spline of the polygon
/// Ends of open curves: interpolating schemes continue the polygon by its reflection in the end point, which leaves the end without curvature; the
/// B-spline keeps its end points. `control` of the result is the polygon it began as. O(points of the last level).
struct SubdivideCurve {
    enum class Scheme { FourPoint, Positive, BSpline };
    enum class Ends { AsGiven, Open, Closed };

    Scheme scheme = Scheme::FourPoint;
    double w = 0.0625;
    int64_t levels = 3;
    Ends ends = Ends::AsGiven;

    template <class V>
    void describe(V& v)
    {
        v.choice("scheme", scheme, {"four-point", "positive", "b-spline"},
                 {.title = "Scheme",
                  .help = "four-point goes through the points and is smooth; positive goes through them with kinks; b-spline only comes near and is "
                          "smoothest."});
        v.number("w", w,
                 {.title = "Tension",
                  .help = "How far new points leave the middle. Smooth between 0 and 0.19; 1/16 repeats cubics.",
                  .min = -0.5,
                  .max = 0.5,
                  .softMin = 0,
                  .softMax = 0.19,
                  .when = "scheme=four-point"});
        v.integer("levels", levels, {.title = "Levels", .help = "How often every segment becomes two.", .min = 0, .max = 16, .softMax = 6});
        v.choice("ends", ends, {"as-given", "open", "closed"}, {.title = "Ends", .help = "Closed: the last point is joined to the first."});
    }
};

Generator subdivideCurve(Curve input, SubdivideCurve parameters, Stage<Curve>& stage);

}  // namespace mw
