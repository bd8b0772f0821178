// The ways between two orientations: by angles, by straight lines between quaternions, and along the great arc.
#pragma once
#include "core/math/rotations.h"
#include "core/steps/stage.h"

namespace mw {

/// Book section 6.5. The paths come one after the other: "euler" mixes the three angles (6.34), "nlerp" mixes the quaternions and normalises
/// (6.35), "slerp" goes along the arc at constant speed (6.38). Angles about x, y and z; the order is that of an intrinsic sequence, so "zyx"
/// turns about z first and then about the turned y: the product Rz Ry Rx. O(samples).
struct InterpolateRotation {
    enum class Order { Xyz, Xzy, Yxz, Yzx, Zxy, Zyx };

    glm::dvec3 from{0, 0, 0}, to{170, 80, -120};
    Order order = Order::Zyx;
    int64_t samples = 24;
    bool shorter = true;

    template <class V>
    void describe(V& v)
    {
        v.point("from", from, {.title = "From", .help = "Angles about x, y and z at the start.", .unit = "°"});
        v.point("to", to,
                {.title = "To", .help = "Angles about x, y and z at the end. Beyond 180 the angles go round more than the body does.", .unit = "°"});
        v.choice("order", order, {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"},
                 {.title = "Order", .help = "In which the three rotations are multiplied, first one leftmost."});
        v.integer("samples", samples,
                  {.title = "Samples", .help = "Orientations on each path, ends included.", .min = 2, .max = 10000, .softMax = 100});
        v.flag("shorter", shorter,
               {.title = "Shorter way",
                .help = "A quaternion and its negative are one orientation: take the one that is nearer. Off: the long way round."});
    }
};

Generator interpolateRotation(InterpolateRotation parameters, Stage<Rotations>& stage);

/// The axis of the body whose tip goes furthest from start to end: its way over the unit sphere is the one to look at.
glm::dvec3 tracedAxis(const Rotations& r);

}  // namespace mw
