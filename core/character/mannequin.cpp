#include "core/character/mannequin.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace mw {

// Slots of the skin come first, ends of bones last.
Skeleton mannequinSkeleton()
{
    struct Place {
        const char *name, *parent;
        glm::dvec3 at;
        bool end = false;
    };
    const double s = std::sqrt(0.5);
    const glm::dvec3 shoulder(0.172, 1.405, -0.018), along(s, -s, 0), palm(-s, -s, 0);
    const glm::dvec3 elbow = shoulder + 0.28 * along, wrist = shoulder + 0.535 * along, tip = shoulder + 0.70 * along + 0.014 * palm;
    const std::vector<Place> places{
        {"Hips", "", {0, 0.955, 0}},
        {"Spine", "Hips", {0, 1.06, 0.002}},
        {"Chest", "Spine", {0, 1.20, 0}},
        {"Neck", "Chest", {0, 1.46, -0.022}},
        {"Head", "Neck", {0, 1.565, -0.004}},
        {"Shoulder", "Chest", {0.035, 1.415, -0.015}},
        {"UpperArm", "Shoulder", shoulder},
        {"LowerArm", "UpperArm", elbow},
        {"Hand", "LowerArm", wrist},
        {"UpperLeg", "Hips", {0.096, 0.905, 0}},
        {"LowerLeg", "UpperLeg", {0.100, 0.495, 0}},
        {"Foot", "LowerLeg", {0.104, 0.085, 0}},
        {"Toes", "Foot", {0.108, 0.022, 0.125}},
        {"HeadEnd", "Head", {0, 1.75, 0}, true},
        {"HandEnd", "Hand", tip, true},
        {"ToesEnd", "Toes", {0.111, 0.017, 0.195}, true},
    };
    Skeleton skeleton;
    std::map<std::string, std::pair<uint32_t, glm::dvec3>> known;
    const auto add = [&](const std::string& name, const std::string& parent, const glm::dvec3& at, bool end) {
        Joint j;
        j.name = name;
        j.end = end;
        const auto above = known.find(parent);
        if (above != known.end()) j.parent = above->second.first;
        j.rest.translation = at - (above != known.end() ? above->second.second : glm::dvec3(0));
        known[name] = {uint32_t(skeleton.joints.size()), at};
        skeleton.joints.push_back(std::move(j));
    };
    const auto central = [](const Place& p) { return p.at.x == 0; };
    for (const bool end : {false, true}) {
        for (const Place& p : places)
            if (p.end == end && central(p)) add(p.name, p.parent, p.at, end);
        for (const std::string side : {"Left", "Right"})
            for (const Place& p : places) {
                if (p.end != end || central(p)) continue;
                const bool inner = std::string_view(p.parent) == "Chest" || std::string_view(p.parent) == "Hips";
                add(side + p.name, (inner ? "" : side) + p.parent, side == "Left" ? p.at : p.at * glm::dvec3(-1, 1, 1), end);
            }
    }
    return skeleton;
}

Mannequin mannequin()
{
    Mannequin m;
    m.skeleton = mannequinSkeleton();
    std::vector<glm::dvec3> at;
    for (const Joint& j : m.skeleton.joints) {
        at.push_back((j.parent == none ? glm::dvec3(0) : at[j.parent]) + j.rest.translation);
        m.inverseBind.push_back(glm::translate(glm::dmat4(1), -at.back()));
    }
    m.mesh = withBoneHeat(mannequinBody(), m.skeleton);
    m.motions = mannequinMotions(m.skeleton, m.mesh);
    return m;
}

}  // namespace mw
