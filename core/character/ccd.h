// Inverse kinematics by cyclic coordinate descent: one joint after the other turns the end towards the target.
#pragma once
#include "core/character/kinematic_chain.h"
#include "core/steps/stage.h"

namespace mw {

/// Wang and Chen 1991, book section 8.2.1. From the last joint to the root, each turns by the angle between its directions to the end and to
/// the target; then again from the last. A joint's stored rotation R becomes (W^-1 Rw W) R, W the world rotation of its parent and Rw the turn
/// as the world sees it: the end never gets further from the target. Joints that are not in the chain move with it. A chain in line with its
/// target is bent a little first. The result carries the target. O(iterations * links^2).
struct Ccd : ChainAim {
    int64_t iterations = 100;
    double tolerance = 1e-3, limit = 180;

    template <class V>
    void describe(V& v)
    {
        ChainAim::describe(v);
        v.integer("iterations", iterations, {.title = "Iterations", .help = "Most rounds over all joints.", .min = 1, .max = 100000, .softMax = 200});
        v.number("tolerance", tolerance,
                 {.title = "Tolerance", .help = "Distance from the target at which it stops.", .unit = "m", .min = 0, .max = 1e6, .softMax = 0.1});
        v.number("limit", limit, {.title = "Largest turn", .help = "Of a joint in one step.", .unit = "°", .min = 0.1, .max = 180});
    }
};

Generator ccd(Pose input, Ccd parameters, Stage<Pose>& stage);

}  // namespace mw
