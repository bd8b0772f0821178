// Curves by subdivision of a polygon: interpolating and approximating masks, and a bad one to compare with.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/curve.h"
#include "core/steps/stage.h"

namespace mw {

/// Book section 3.2. Each level doubles the segments.
///   four-point  old points stay, new = -w P(i-1) + (1/2 + w)(P(i) + P(i+1)) - w P(i+2)  (3.17); w = 1/16 repeats every cubic
///   positive    the same with all weights positive, 1/8 3/8 3/8 1/8 (3.16): goes through the points, but its slope never settles
///   mask        any stationary mask: `old` has 2k + 1 weights round a point, `fresh` an even number round the middle of a segment, or 2k + 1
///               round its first point as the rows of (3.20); each sums to 1
///   b-spline    old points move to (P(i-1) + 6 P(i) + P(i+1))/8, new ones are middles (3.18)-(3.20): the cubic B-spline of the polygon
/// Ends of open curves stay; schemes continue the polygon by its reflection in the end point, which leaves the end without curvature.
/// `control` of the result is the polygon it began as. O(points of the last level).
struct SubdivideCurve {
    enum class Scheme { FourPoint, Positive, BSpline, Mask };
    enum class Ends { AsGiven, Open, Closed };

    Scheme scheme = Scheme::FourPoint;
    double w = 0.0625;
    std::string old = "1/8 6/8 1/8", fresh = "1/2 1/2";
    int64_t levels = 3;
    Ends ends = Ends::AsGiven;

    template <class V>
    void describe(V& v)
    {
        v.choice("scheme", scheme, {"four-point", "positive", "b-spline", "mask"},
                 {.title = "Scheme",
                  .help = "four-point goes through the points and is smooth; positive goes through them with kinks; b-spline only comes near and is "
                          "smoothest; mask takes any weights."});
        v.number("w", w,
                 {.title = "Tension",
                  .help = "How far new points leave the middle. Smooth between 0 and 0.19; 1/16 repeats cubics.",
                  .min = -0.5,
                  .max = 0.5,
                  .softMin = 0,
                  .softMax = 0.19,
                  .when = "scheme=four-point"});
        v.text("old", old,
               {.title = "Old points",
                .help = "Weights of a point and as many on either side, as numbers or fractions: 2k + 1 that sum to 1. A single 1 keeps the points.",
                .when = "scheme=mask"});
        v.text(
            "new", fresh,
            {.title = "New points",
             .help = "Weights for a new point on a segment: an even number, as many before as after it, or 2k + 1 round the segment's first point; "
                     "they sum to 1.",
             .when = "scheme=mask"});
        v.integer("levels", levels, {.title = "Levels", .help = "How often every segment becomes two.", .min = 0, .max = 16, .softMax = 6});
        v.choice("ends", ends, {"as-given", "open", "closed"}, {.title = "Ends", .help = "Closed: the last point is joined to the first."});
    }
};

/// Weights as numbers or fractions with spaces or commas between. Throws Error naming `what` when one is no number, when there are none or more
/// than 13, or when they do not sum to 1.
std::vector<double> weightsIn(std::string_view text, const char* what);

Generator subdivideCurve(Curve input, SubdivideCurve parameters, Stage<Curve>& stage);

}  // namespace mw
