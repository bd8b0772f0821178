// Inverse kinematics by forward and backward reaching: joints are moved along lines, their angles found at the end.
#pragma once
#include "core/character/kinematic_chain.h"
#include "core/steps/stage.h"

namespace mw {

/// Aristidou and Lasenby 2011, book section 8.2.3. Forward pass: the end is put on the target, and each joint towards the root is drawn along
/// the line to its neighbour until the link has its length again. Backward pass: the root is put back, and the same towards the end. Links may
/// differ. A target out of reach: the chain is straightened towards it. A chain in line with its target is bent a little first. At last each
/// joint is given the smallest turn that brings its bone where it was found to be; joints that are not in the chain move with it.
/// While it runs the pose shows joints where they are, so that links have other lengths; the result has turns alone. It carries the
/// target. O(iterations * links).
struct Fabrik : ChainAim {
    int64_t iterations = 50;
    double tolerance = 1e-3;

    template <class V>
    void describe(V& v)
    {
        ChainAim::describe(v);
        v.integer("iterations", iterations, {.title = "Iterations", .help = "Most rounds of both passes.", .min = 1, .max = 100000, .softMax = 200});
        v.number("tolerance", tolerance,
                 {.title = "Tolerance", .help = "Distance from the target at which it stops.", .unit = "m", .min = 0, .max = 1e6, .softMax = 0.1});
    }
};

Generator fabrik(Pose input, Fabrik parameters, Stage<Pose>& stage);

}  // namespace mw
