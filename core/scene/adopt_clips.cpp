#include "core/scene/adopt_clips.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mw {

namespace {

/// Nodes by name; those whose name is taken twice are none.
std::map<std::string, NodeId> byName(const Scene& scene)
{
    std::map<std::string, NodeId> found;
    for (const NodeId id : scene.nodes()) {
        const auto [known, fresh] = found.try_emplace(scene.node(id).name, id);
        if (!fresh) known->second = {};
    }
    found.erase("");
    return found;
}

bool sameBone(const Node& a, const Node& b)
{
    const double x = glm::length(a.local.translation), y = glm::length(b.local.translation);
    return std::abs(x - y) <= 0.05 * std::max(x, y);
}

/// For each node the clip drives, the one of the same name; empty when too few fit.
std::map<NodeId, NodeId> partners(const Scene& scene, const std::map<std::string, NodeId>& names, const Scene& motion, const Clip& clip)
{
    std::map<NodeId, NodeId> all, found;
    size_t same = 0;
    for (const auto& channel : clip.channels) {
        if (!all.try_emplace(channel->node).second) continue;
        const Node& from = motion.node(channel->node);
        const auto to = names.find(from.name);
        if (to == names.end() || !to->second) continue;
        found[channel->node] = to->second;
        same += sameBone(from, scene.node(to->second));
    }
    size_t joints = 0;
    for (const auto& [name, node] : names) joints += node && scene.node(node).joint == Node::Joint::Joint;
    const size_t wanted = joints ? std::min(all.size(), joints) : all.size();  // a recording also drives cameras and markers
    const bool fits = !found.empty() && 10 * found.size() >= 9 * wanted && 5 * same >= 4 * found.size();
    return fits ? found : std::map<NodeId, NodeId>();
}

}  // namespace

std::vector<ClipId> adoptClips(Scene& scene, const Scene& motion)
{
    const std::map<std::string, NodeId> names = byName(scene);
    std::vector<ClipId> added;
    for (const ClipId id : motion.clips()) {
        const Clip& clip = *motion.find(id);
        const std::map<NodeId, NodeId> to = partners(scene, names, motion, clip);
        if (to.empty()) continue;
        Clip taken{clip.name, {}, clip.frameTime};
        for (const auto& channel : clip.channels) {
            const auto node = to.find(channel->node);
            if (node == to.end()) continue;
            Channel moved = *channel;
            moved.node = node->second;
            taken.channels.push_back(std::make_shared<const Channel>(std::move(moved)));
        }
        added.push_back(scene.add(std::move(taken)));
    }
    return added;
}

}  // namespace mw
