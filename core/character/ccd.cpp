#include "core/character/ccd.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace mw {

namespace {

/// The turn that brings the end nearest to the target, about one joint.
struct Turn {
    double angle = 0;
    glm::dvec3 axis{0, 0, 1};
    glm::dquat rotation{1, 0, 0, 0};
};

Turn turnAbout(glm::dvec3 joint, glm::dvec3 end, glm::dvec3 target, double limit)
{
    Turn t;
    const glm::dquat whole = smallestTurn(end - joint, target - joint);
    const glm::dvec3 v(whole.x, whole.y, whole.z);
    const double sine = glm::length(v);
    if (sine == 0) return t;
    t.angle = std::min(2 * std::atan2(sine, whole.w), limit);
    t.axis = v / sine;
    t.rotation = glm::angleAxis(t.angle, t.axis);
    return t;
}

// Inner joints a little to one side, the more the nearer they are to the end: any start will do that is not on the line.
void bend(Pose& pose, const KinematicChain& chain)
{
    const std::vector<glm::dvec3> places = chain.places(pose);
    const glm::dvec3 link = places.back() - places.front();
    const glm::dvec3 side = across(link), axis = glm::length(link) > 0 ? glm::normalize(glm::cross(link, side)) : glm::dvec3(0, 0, 1);
    for (size_t i = 0; i + 1 < chain.joints.size(); ++i) turnJoint(pose, chain.joints[i], glm::angleAxis(glm::radians(10.0), axis));
}

}  // namespace

Generator ccd(Pose input, Ccd p, Stage<Pose>& stage)
{
    const KinematicChain chain = chainOf(input, p);
    Pose pose = std::move(input);
    pose.targets = {{chain.end(), chain.target}};
    stage.show([&] { return pose; });

    std::vector<glm::dvec3> place = chain.places(pose);
    const std::vector<double> lengths = linkLengths(place);
    double reach = 0;
    for (const double d : lengths) reach += d;
    const glm::vec3 target(chain.target);
    const Reach within = reachOf(lengths, glm::distance(place.front(), chain.target));
    double error = glm::distance(place.back(), chain.target);
    const double begun = std::max(error, 1e-300);
    co_yield Step("aim")
        .element(ElementKind::Joint, chain.joints.front(), Role::Neighbour, "J0")
        .element(ElementKind::Joint, chain.end(), Role::Current, "E")
        .point(target, Role::New, "T")
        .number("links", double(lengths.size()))
        .number("reach", reach)
        .number("distance", glm::distance(place.front(), chain.target))
        .number("within", double(within))
        .number("error", error);

    if (within == Reach::Yes && error > p.tolerance && isInLine(place, chain.target)) {
        bend(pose, chain);
        place = chain.places(pose);
        error = glm::distance(place.back(), chain.target);
        co_yield Step("bend").ring(ElementKind::Joint, Role::Current, chain.joints).point(target, Role::Neighbour, "T").number("error", error);
    }

    for (int64_t round = 0; round < p.iterations && error > p.tolerance; ++round) {
        const double before = error;
        for (size_t i = chain.joints.size() - 1; i-- > 0 && error > p.tolerance;) {
            const uint32_t joint = chain.joints[i];
            const glm::vec3 at(place[i]), from(place.back());
            const Turn turn = turnAbout(place[i], place.back(), chain.target, glm::radians(p.limit));
            turnJoint(pose, joint, turn.rotation);
            place = chain.places(pose);
            error = glm::distance(place.back(), chain.target);
            co_yield Step("turn")
                .element(ElementKind::Joint, joint, Role::Current, "J")
                .segment(at, from, Role::Removed, "u")
                .segment(at, target, Role::Neighbour, "v")
                .element(ElementKind::Joint, chain.end(), Role::New, "E")
                .point(target, Role::Neighbour, "T")
                .number("round", double(round + 1))
                .number("joint", double(i))
                .number("angle", glm::degrees(turn.angle))
                .number("axis x", turn.axis.x)
                .number("axis y", turn.axis.y)
                .number("axis z", turn.axis.z)
                .number("error", error)
                .progress(double(round) / double(p.iterations));
        }
        co_yield Step("round")
            .element(ElementKind::Joint, chain.end(), Role::Current, "E")
            .point(target, Role::Neighbour, "T")
            .number("round", double(round + 1))
            .number("error", error)
            .number("gained", before - error)
            .progress(double(round + 1) / double(p.iterations));
        if (before - error < 1e-12 * begun) break;  // it stands still: the target is out of reach
    }
    stage.finish(std::move(pose));
}

}  // namespace mw
