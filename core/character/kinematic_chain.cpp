#include "core/character/kinematic_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"

namespace mw {

namespace {

glm::dmat4 worldOf(const Pose& p, uint32_t joint)
{
    glm::dmat4 m(1);
    for (; joint != none; joint = p.skeleton->joints[joint].parent) m = p.locals[joint].matrix() * m;
    return p.worldFromParent * m;
}

glm::dmat4 worldOfParent(const Pose& p, uint32_t joint)
{
    const uint32_t parent = p.skeleton->joints[joint].parent;
    return parent == none ? p.worldFromParent : worldOf(p, parent);
}

uint32_t endOf(const Pose& pose, const ChainAim& aim)
{
    if (!aim.effector.empty()) return jointOf(*pose.skeleton, aim.effector);
    return pose.targets.empty() ? uint32_t(pose.size() - 1) : pose.targets.front().joint;
}

// As far up as a joint is its parent's only child; at least one link.
uint32_t rootAbove(const Skeleton& s, uint32_t end)
{
    std::vector<uint32_t> children(s.joints.size());
    for (const Joint& j : s.joints)
        if (j.parent != none) ++children[j.parent];
    uint32_t root = s.joints[end].parent;
    while (children[root] == 1 && s.joints[root].parent != none && children[s.joints[root].parent] == 1) root = s.joints[root].parent;
    return root;
}

// Where a chain can go: a good part of its reach from the root, up and forward of where it points now.
glm::dvec3 withinReach(const std::vector<glm::dvec3>& places)
{
    double reach = 0;
    for (const double d : linkLengths(places)) reach += d;
    const glm::dvec3 now = places.back() - places.front();
    const double length = glm::length(now);
    const glm::dvec3 direction = (length > 0 ? now / length : glm::dvec3(0)) + glm::dvec3(0, 0.5, 0.7);
    const double share = places.size() > 2 ? 0.75 : 1;  // a single link reaches one distance only
    return places.front() + share * reach * glm::normalize(direction);
}

}  // namespace

std::vector<glm::dvec3> KinematicChain::places(const Pose& p) const
{
    std::vector<glm::dvec3> out;
    glm::dmat4 m = worldOfParent(p, joints.front());
    for (const uint32_t j : joints) {
        m = m * p.locals[j].matrix();
        out.emplace_back(m[3]);
    }
    return out;
}

KinematicChain chainOf(const Pose& pose, const ChainAim& aim)
{
    if (!pose.skeleton || pose.size() == 0) throw Error("the skeleton has no joints; take one that has a chain of them");
    const Skeleton& s = *pose.skeleton;
    const uint32_t end = endOf(pose, aim);
    const auto name = [&](uint32_t j) { return "\"" + s.joints[j].name + "\""; };
    if (s.joints[end].parent == none) throw Error("the end joint " + name(end) + " is a root: name one further down");
    const uint32_t root = aim.root.empty() ? rootAbove(s, end) : jointOf(s, aim.root);
    KinematicChain chain;
    for (uint32_t j = end; j != none; j = s.joints[j].parent) {
        chain.joints.push_back(j);
        if (j == root) break;
    }
    if (chain.joints.back() != root || chain.joints.size() < 2)
        throw Error("the root " + name(root) + " is not above the end joint " + name(end) + ": name one of its ancestors");
    std::reverse(chain.joints.begin(), chain.joints.end());

    const auto own = std::find_if(pose.targets.begin(), pose.targets.end(), [&](const PoseTarget& t) { return t.joint == end; });
    if (aim.aim == ChainAim::Aim::Point || aim.target != glm::dvec3(0))
        chain.target = aim.target;
    else
        chain.target = own != pose.targets.end() ? own->at : withinReach(chain.places(pose));
    return chain;
}

std::vector<double> linkLengths(const std::vector<glm::dvec3>& places)
{
    std::vector<double> d;
    for (size_t i = 0; i + 1 < places.size(); ++i) d.push_back(glm::distance(places[i], places[i + 1]));
    return d;
}

Reach reachOf(const std::vector<double>& lengths, double distance)
{
    double sum = 0, longest = 0;
    for (const double d : lengths) {
        sum += d;
        longest = std::max(longest, d);
    }
    if (distance > sum) return Reach::TooFar;
    return longest - (sum - longest) > distance ? Reach::TooNear : Reach::Yes;
}

bool isInLine(const std::vector<glm::dvec3>& places, glm::dvec3 target)
{
    double reach = 0;
    for (const double d : linkLengths(places)) reach += d;
    glm::dvec3 line = target - places.front();
    if (glm::length(line) < 1e-9 * reach) line = places.back() - places.front();
    if (glm::length(line) == 0) return reach == 0;
    line = glm::normalize(line);
    return std::all_of(places.begin(), places.end(),
                       [&](const glm::dvec3& p) { return glm::length(glm::cross(p - places.front(), line)) < 1e-4 * reach; });
}

glm::dvec3 across(glm::dvec3 direction)
{
    glm::dvec3 a = glm::cross(glm::dvec3(0, 0, 1), direction);
    if (glm::length(a) < 1e-6 * glm::length(direction)) a = glm::cross(glm::dvec3(1, 0, 0), direction);
    return glm::length(a) > 0 ? glm::normalize(a) : glm::dvec3(0, 1, 0);
}

glm::dquat smallestTurn(glm::dvec3 from, glm::dvec3 to)
{
    const double a = glm::length(from), b = glm::length(to);
    if (!(a > 0) || !(b > 0)) return {1, 0, 0, 0};
    from /= a;
    to /= b;
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), angle = std::atan2(sine, glm::dot(from, to));
    if (sine == 0 && angle == 0) return {1, 0, 0, 0};
    // Half a turn within the plane z = 0 stays there: its axis is z.
    const glm::dvec3 half = std::abs(from.z) < 0.9 ? glm::normalize(glm::dvec3(0, 0, 1) - from.z * from) : across(from);
    const glm::dvec3 unit = sine > 1e-12 ? axis / sine : half;
    return {std::cos(angle / 2), std::sin(angle / 2) * unit};
}

glm::dquat localTurn(const glm::dmat4& worldOfParent, const glm::dquat& turn)
{
    const Transform parent = transformOf(worldOfParent);
    const glm::dquat q = glm::conjugate(parent.rotation) * turn * parent.rotation;
    if (parent.scale.x > 0) return q;
    return {q.w, q.x, -q.y, -q.z};  // seen in the mirror x -> -x
}

void turnJoint(Pose& pose, uint32_t joint, const glm::dquat& turn)
{
    glm::dquat& r = pose.locals[joint].rotation;
    r = glm::normalize(localTurn(worldOfParent(pose, joint), turn) * r);
}

}  // namespace mw
