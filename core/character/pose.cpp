#include "core/character/pose.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/error.h"
#include "core/math/hash.h"

namespace mw {

std::vector<glm::dmat4> worldMatrices(const Pose& p)
{
    std::vector<glm::dmat4> world(p.size());
    for (size_t i = 0; i < p.size(); ++i) {
        const uint32_t parent = p.skeleton->joints[i].parent;
        world[i] = (parent == none ? p.worldFromParent : world[parent]) * p.locals[i].matrix();
    }
    return world;
}

std::vector<glm::dvec3> jointPlaces(const Pose& p)
{
    std::vector<glm::dvec3> places;
    for (const glm::dmat4& m : worldMatrices(p)) places.emplace_back(m[3]);
    return places;
}

namespace {

std::string lower(std::string_view s)
{
    std::string out(s);
    std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return out;
}

// Joints in the order of their numbers: end sites come last.
std::vector<uint32_t> numbered(const Skeleton& s)
{
    std::vector<uint32_t> order;
    for (const bool ends : {false, true})
        for (uint32_t i = 0; i < s.joints.size(); ++i)
            if (s.joints[i].end == ends) order.push_back(i);
    return order;
}

// Joints that have the text in their name, or all when none has; a few of them.
std::string namesNear(const Skeleton& s, std::string_view wanted)
{
    constexpr size_t most = 12;
    std::vector<std::string> near;
    for (const bool any : {false, true}) {
        for (uint32_t i = 0; i < s.joints.size(); ++i)
            if (any || lower(s.joints[i].name).find(lower(wanted)) != std::string::npos) near.push_back(calledBy(s, i));
        if (!near.empty()) break;
    }
    std::string list;
    for (size_t i = 0; i < std::min(most, near.size()); ++i) list += (i ? ", " : "") + near[i];
    return list + (near.size() > most ? ", ..." : "");
}

}  // namespace

uint32_t jointOf(const Skeleton& s, std::string_view name)
{
    if (s.joints.empty()) throw Error("there is no joint \"" + std::string(name.substr(0, 64)) + "\"; the skeleton is empty");
    const std::vector<uint32_t> order = numbered(s);
    std::vector<uint32_t> same;  // numbers
    for (uint32_t k = 0; k < order.size(); ++k)
        if (s.joints[order[k]].name == name) same.push_back(k);
    if (same.size() == 1) return order[same[0]];
    if (same.size() > 1) {
        std::string list;
        for (const uint32_t k : same) list += (list.empty() ? "#" : ", #") + std::to_string(k);
        throw Error(std::to_string(same.size()) + " joints are called \"" + std::string(name) + "\": give one by its number, " + list);
    }
    uint32_t index = 0;
    if (name.size() > 1 && name[0] == '#') {
        const auto [end, failure] = std::from_chars(name.data() + 1, name.data() + name.size(), index);
        if (failure == std::errc() && end == name.data() + name.size() && index < order.size()) return order[index];
        throw Error("there is no joint " + std::string(name.substr(0, 32)) + "; the skeleton has #0 to #" + std::to_string(order.size() - 1));
    }
    throw Error("there is no joint \"" + std::string(name.substr(0, 64)) + "\"; there are " + namesNear(s, name));
}

std::string calledBy(const Skeleton& s, uint32_t joint)
{
    const std::string& name = s.joints[joint].name;
    const auto same = std::count_if(s.joints.begin(), s.joints.end(), [&](const Joint& j) { return j.name == name; });
    if (same == 1 && !name.empty()) return name;
    const std::vector<uint32_t> order = numbered(s);
    return "#" + std::to_string(std::find(order.begin(), order.end(), joint) - order.begin());
}

size_t byteSize(const Pose& p)
{
    return sizeof p + p.locals.size() * sizeof(Transform) + p.targets.size() * sizeof(PoseTarget);
}

uint64_t contentHash(const Pose& p)
{
    Hasher h;
    if (p.skeleton)
        for (const Joint& j : p.skeleton->joints) {
            h.text(j.name);
            h.number(j.parent);
            h.bytes(&j.rest, sizeof j.rest);
        }
    h.array(std::span<const Transform>(p.locals));
    h.bytes(&p.worldFromParent, sizeof p.worldFromParent);
    for (const PoseTarget& t : p.targets) {
        h.number(t.joint);
        h.bytes(&t.at, sizeof t.at);
    }
    return h.value();
}

}  // namespace mw
