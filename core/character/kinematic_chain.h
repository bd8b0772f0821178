// What the solvers of inverse kinematics share: which joints are a chain, where its end is wanted, and turns of joints said in the world.
#pragma once
#include <string>
#include <vector>

#include "core/character/pose.h"

namespace mw {

/// Which end of what chain goes where; the parameters of every solver.
struct ChainAim {
    enum class Aim { Auto, Point };

    std::string effector, root;
    glm::dvec3 target{0};
    Aim aim = Aim::Auto;

    template <class V>
    void describe(V& v)
    {
        v.text("effector", effector,
               {.title = "End joint",
                .help = "The joint that is to reach the target: its name, or #INDEX. Empty: the one the pose has a target for, else the last."});
        v.text("root", root, {.title = "Root", .help = "Where the chain begins; it stays in place. Empty: as far up as no joint branches off."});
        v.point("target", target,
                {.title = "Target", .help = "World space. 0/0/0: the pose's own target, or, when it has none, one within reach.", .unit = "m"});
        v.choice(
            "aim", aim, {"auto", "point"},
            {.title = "Aim", .help = "auto: 0/0/0 stands for the pose's own target. point: the target is taken as it is given.", .advanced = true});
    }
};

/// Joints from the root of the chain to its end, each the parent of the next.
struct KinematicChain {
    std::vector<uint32_t> joints;
    glm::dvec3 target{0};

    uint32_t end() const { return joints.back(); }
    /// World places of its joints.
    std::vector<glm::dvec3> places(const Pose& p) const;
};
/// Throws Error when a joint is unknown, or nothing lies between root and end.
KinematicChain chainOf(const Pose& pose, const ChainAim& aim);
/// Lengths of links between places.
std::vector<double> linkLengths(const std::vector<glm::dvec3>& places);

enum class Reach { Yes, TooFar, TooNear };
/// Whether links of these lengths can span a distance. Too near: one link is longer than the distance and all others together.
Reach reachOf(const std::vector<double>& lengths, double distance);
/// True when all places and the target lie on one line: no turn would then lead sideways.
bool isInLine(const std::vector<glm::dvec3>& places, glm::dvec3 target);

/// The smallest rotation that turns one direction into another; of opposite ones half a turn about any axis across. Identity when one is 0.
glm::dquat smallestTurn(glm::dvec3 from, glm::dvec3 to);
/// A unit vector at right angles to another: in the plane z = 0 where that is possible.
glm::dvec3 across(glm::dvec3 direction);
/// A turn of the world as a factor on the left of a joint's own rotation: W^-1 Rw W, W the world matrix of its parent. Scales and mirrors of W
/// are allowed for; shear is not.
glm::dquat localTurn(const glm::dmat4& worldOfParent, const glm::dquat& turn);
/// Turns a joint of a pose about its own place in the world.
void turnJoint(Pose& pose, uint32_t joint, const glm::dquat& turn);

}  // namespace mw
