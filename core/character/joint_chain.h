// A chain of links in the plane z = 0, and a target for its end: what the solvers of inverse kinematics are tried on first.
#pragma once
#include "core/character/pose.h"
#include "core/steps/stage.h"

namespace mw {

/// Joints "joint 0" (at the origin) to "joint n-1", each turned about z against the one before, and the end "tip". O(links).
struct JointChain {
    int64_t links = 4;
    std::string lengths = "1", angles = "75 -35";
    glm::dvec3 target{2.2, 0.9, 0};

    template <class V>
    void describe(V& v)
    {
        v.integer("links", links, {.title = "Links", .help = "How many bones follow each other.", .min = 1, .max = 1000, .softMax = 16});
        v.text("lengths", lengths,
               {.title = "Lengths", .help = "Of the links from the root on, with spaces between, in metres; the last one goes for all that follow."});
        v.text("angles", angles,
               {.title = "Angles",
                .help = "Of each link against the one before, with spaces between, in degrees; the last one goes for all that follow."});
        v.point("target", target, {.title = "Target", .help = "Where the tip is wanted; with z = 0 all happens in the plane.", .unit = "m"});
    }
};

Generator jointChain(JointChain parameters, Stage<Pose>& stage);

}  // namespace mw
