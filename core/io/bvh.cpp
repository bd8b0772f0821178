// From what a BVH file says to a scene: joints become nodes, columns of the motion become channels that share their times.
#include "core/io/bvh.h"

#include "core/io/bvh_data.h"

namespace mw {

namespace {

/// Nodes are made in one go: adding them one by one would copy a parent for each of its children.
Scene skeletonOf(const BvhData& data)
{
    const auto idOf = [](uint32_t joint) { return NodeId{joint + 1}; };
    Scene::Parts parts;
    for (uint32_t i = 0; i < data.joints.size(); ++i) {
        const BvhData::Joint& j = data.joints[i];
        Node n;
        n.name = j.name;
        n.local.translation = j.offset;
        n.joint = j.end ? Node::Joint::EndSite : Node::Joint::Joint;
        if (j.parent != none) {
            n.parent = idOf(j.parent);
            parts.nodes.at(n.parent).children.push_back(idOf(i));
        } else {
            parts.roots.push_back(idOf(i));
        }
        parts.nodes.emplace(idOf(i), std::move(n));
    }
    return Scene::restored(std::move(parts));
}

Clip clipOf(const BvhData& data, std::string name)
{
    Clip clip;
    clip.name = std::move(name);
    clip.frameTime = data.frameTime;
    Array<double> times(data.rows);
    for (size_t i = 0; i < data.rows; ++i) times[i] = double(i) * data.frameTime;
    const Shared<double> shared(std::move(times));
    size_t column = 0;
    for (uint32_t j = 0; j < data.joints.size(); ++j)
        for (const Channel::Path path : data.joints[j].channels) {
            Channel c;
            c.node = NodeId{j + 1};
            c.path = path;
            c.components = 1;
            c.times = shared;
            Array<double> values(data.rows);
            for (size_t i = 0; i < data.rows; ++i) values[i] = data.values[i * data.channels + column];
            c.values = std::move(values);
            clip.channels.push_back(std::make_shared<const Channel>(std::move(c)));
            ++column;
        }
    return clip;
}

}  // namespace

Imported readBvh(const std::filesystem::path& file, Progress* progress)
{
    const FileBytes bytes = plainText(readBytes(file), file.string());
    BvhData data = parseBvh(bytes, file.string(), progress);
    Imported in;
    in.format = "BVH";
    in.units = "unknown";
    in.scene = skeletonOf(data);
    if (data.rows > 0) in.scene.add(clipOf(data, file.stem().string()));
    in.warnings = std::move(data.warnings);
    return in;
}

}  // namespace mw
