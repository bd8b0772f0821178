#include "core/character/fabrik.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace mw {

namespace {

using Places = std::vector<glm::dvec3>;

/// Drawn along the line to its neighbour until the link is as long as it was. On the neighbour itself there is no line: it stays.
glm::dvec3 drawn(glm::dvec3 joint, glm::dvec3 neighbour, double length)
{
    const glm::dvec3 line = joint - neighbour;
    const double now = glm::length(line);
    return now > 0 ? neighbour + length / now * line : neighbour + glm::dvec3(length, 0, 0);
}

/// Turns the joints of a chain, root first, each by the smallest angle that points its bone to the next place. `turns` receives the angles.
Pose turned(Pose pose, const KinematicChain& chain, const Places& place, std::vector<double>* turns)
{
    for (size_t i = 0; i + 1 < chain.joints.size(); ++i) {
        const Places now = chain.places(pose);
        const glm::dquat turn = smallestTurn(now[i + 1] - now[i], place[i + 1] - place[i]);
        turnJoint(pose, chain.joints[i], turn);
        if (turns) turns->push_back(2 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w)));
    }
    return pose;
}

/// The pose whose chain has its joints at these very places, however far apart.
Pose stretched(const Pose& input, const KinematicChain& chain, const Places& place)
{
    Pose pose = turned(input, chain, place, nullptr);
    for (size_t i = 0; i < chain.joints.size(); ++i) {
        const uint32_t joint = chain.joints[i], parent = pose.skeleton->joints[joint].parent;
        const glm::dmat4 worldOfParent = parent == none ? pose.worldFromParent : worldMatrices(pose)[parent];
        pose.locals[joint].translation = glm::dvec3(glm::inverse(worldOfParent) * glm::dvec4(place[i], 1));
    }
    return pose;
}

// Inner joints to one side, by a tenth of their link: any start will do that is not on the line.
void bend(Places& place, const std::vector<double>& lengths, glm::dvec3 target)
{
    glm::dvec3 line = target - place.front();
    if (glm::length(line) == 0) line = place.back() - place.front();
    const glm::dvec3 side = across(line);
    for (size_t i = 1; i + 1 < place.size(); ++i) place[i] += 0.1 * lengths[i - 1] * side;
}

}  // namespace

Generator fabrik(Pose input, Fabrik p, Stage<Pose>& stage)
{
    const KinematicChain chain = chainOf(input, p);
    Pose begun = std::move(input);
    begun.targets = {{chain.end(), chain.target}};
    Places place = chain.places(begun);
    const std::vector<double> length = linkLengths(place);
    const size_t n = length.size();
    const glm::dvec3 root = place.front();
    const glm::vec3 target(chain.target);
    stage.show([&] { return stretched(begun, chain, place); });

    double reach = 0;
    for (const double d : length) reach += d;
    const Reach within = reachOf(length, glm::distance(root, chain.target));
    double error = glm::distance(place.back(), chain.target);
    co_yield Step("aim")
        .element(ElementKind::Joint, chain.joints.front(), Role::Neighbour, "R")
        .element(ElementKind::Joint, chain.end(), Role::Current, "E")
        .point(target, Role::New, "T")
        .number("links", double(n))
        .number("reach", reach)
        .number("distance", glm::distance(root, chain.target))
        .number("within", double(within))
        .number("error", error);

    if (within == Reach::TooFar) {
        const glm::dvec3 direction = glm::normalize(chain.target - root);
        for (size_t i = 1; i <= n; ++i) {
            place[i] = place[i - 1] + length[i - 1] * direction;
            error = glm::distance(place.back(), chain.target);
            co_yield Step("straighten")
                .element(ElementKind::Joint, chain.joints[i], Role::New, "P")
                .element(ElementKind::Joint, chain.joints[i - 1], Role::Current, "Q")
                .segment(glm::vec3(root), target, Role::Neighbour)
                .point(target, Role::Neighbour, "T")
                .number("joint", double(i))
                .number("length", length[i - 1])
                .number("error", error)
                .progress(double(i) / double(n));
        }
    } else if (error > p.tolerance && isInLine(place, chain.target)) {
        bend(place, length, chain.target);
        co_yield Step("bend").ring(ElementKind::Joint, Role::Current, chain.joints).point(target, Role::Neighbour, "T").number("error", error);
    }

    for (int64_t round = 0; within != Reach::TooFar && round < p.iterations && error > p.tolerance; ++round) {
        const double before = error;
        for (size_t i = n + 1; i-- > 0;) {
            const glm::vec3 old(place[i]);
            place[i] = i == n ? chain.target : drawn(place[i], place[i + 1], length[i]);
            const char* phase = i == n ? "to target" : "forward";
            const uint32_t next = chain.joints[std::min(i + 1, n)];
            co_yield Step(phase)
                .segment(old, glm::vec3(place[i]), Role::Removed)
                .element(ElementKind::Joint, next, Role::Current, "Q")
                .element(ElementKind::Joint, chain.joints[i], Role::New, "P")
                .point(target, Role::Neighbour, "T")
                .number("round", double(round + 1))
                .number("joint", double(i))
                .number("length", length[std::min(i, n - 1)])
                .number("moved", glm::distance(glm::dvec3(old), place[i]))
                .number("error", before)
                .progress(double(round) / double(p.iterations));
        }
        for (size_t i = 0; i <= n; ++i) {
            const glm::vec3 old(place[i]);
            place[i] = i == 0 ? root : drawn(place[i], place[i - 1], length[i - 1]);
            const char* phase = i == 0 ? "to root" : "backward";
            const size_t link = i ? i - 1 : 0;
            const uint32_t next = chain.joints[link];
            co_yield Step(phase)
                .segment(old, glm::vec3(place[i]), Role::Removed)
                .element(ElementKind::Joint, next, Role::Current, "Q")
                .element(ElementKind::Joint, chain.joints[i], Role::New, "P")
                .point(target, Role::Neighbour, "T")
                .number("round", double(round + 1))
                .number("joint", double(i))
                .number("length", length[link])
                .number("moved", glm::distance(glm::dvec3(old), place[i]))
                .number("error", before)
                .progress((double(round) + 0.5) / double(p.iterations));
        }
        error = glm::distance(place.back(), chain.target);
        co_yield Step("round")
            .element(ElementKind::Joint, chain.end(), Role::Current, "E")
            .point(target, Role::Neighbour, "T")
            .number("round", double(round + 1))
            .number("error", error)
            .number("gained", before - error)
            .progress(double(round + 1) / double(p.iterations));
        if (round > 0 && std::abs(before - error) < 1e-12 * reach) break;  // it stands still: the target is too near for one long link
    }

    std::vector<double> angle;
    Pose result = turned(begun, chain, place, &angle);
    for (size_t i = 0; i < n; ++i)
        co_yield Step("turn")
            .edge(chain.joints[i], chain.joints[i + 1], Role::Current)
            .element(ElementKind::Joint, chain.joints[i], Role::Current, "J")
            .element(ElementKind::Joint, chain.joints[i + 1], Role::New, "P")
            .number("joint", double(i))
            .number("angle", glm::degrees(angle[i]))
            .number("error", error)
            .progress(1);
    stage.finish(std::move(result));
}

}  // namespace mw
