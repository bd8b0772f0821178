#include "core/scene/animate_morph.h"

#include <algorithm>

#include "core/error.h"

namespace mw {

namespace {

constexpr double usualSeconds = 4;

std::string freeClipName(const Scene& scene, const std::string& name)
{
    const std::vector<ClipId> clips = scene.clips();
    const auto taken = [&](const std::string& n) {
        return std::any_of(clips.begin(), clips.end(), [&](ClipId c) { return scene.find(c)->name == n; });
    };
    std::string free = name;
    for (int i = 2; taken(free); ++i) free = name + " " + std::to_string(i);
    return free;
}

}  // namespace

size_t morphTargets(const MeshObject& object)
{
    const std::vector<Attribute>& a = object.base.attributes();
    const auto base =
        std::count_if(a.begin(), a.end(), [](const Attribute& x) { return x.domain == Domain::Vertex && x.name.starts_with(names::morph); });
    const auto made = std::count_if(object.stack.begin(), object.stack.end(), [](const Modifier& m) { return m.operation == "morph" && m.enabled; });
    return size_t(base + made);
}

bool playsMorphs(const Scene& scene, NodeId node)
{
    for (const ClipId id : scene.clips())
        for (const auto& c : scene.find(id)->channels)
            if (c->node == node && c->path == Channel::Path::Weights && c->keys() > 0) return true;
    return false;
}

Clip morphClip(const Scene& scene, NodeId node, size_t target, double seconds)
{
    const MeshObject* object = scene.find(scene.node(node).mesh);
    const size_t targets = object ? morphTargets(*object) : 0;
    const std::string& name = scene.node(node).name;
    if (targets == 0) throw Error("\"" + name + "\" has no morph targets; the operation morph makes one");
    if (target > targets) throw Error("\"" + name + "\" has no morph target " + std::to_string(target) + ": it has " + std::to_string(targets));
    const size_t driven = target == 0 ? targets - 1 : target - 1;
    Channel c;
    c.node = node;
    c.path = Channel::Path::Weights;
    c.components = int(targets);
    c.times = Array<double>{0, seconds / 2, seconds};
    Array<double> values(3 * targets, 0.0);
    values[targets + driven] = 1;
    c.values = std::move(values);
    Clip clip;
    clip.name = freeClipName(scene, name.empty() ? "Morph" : name + " morph");
    clip.channels.push_back(std::make_shared<const Channel>(std::move(c)));
    return clip;
}

std::vector<ClipId> animateNewMorphs(Scene& scene, MeshId mesh, size_t before)
{
    std::vector<ClipId> made;
    if (morphTargets(*scene.find(mesh)) <= before) return made;
    for (const NodeId id : scene.nodes())
        if (scene.node(id).mesh == mesh && !playsMorphs(scene, id)) made.push_back(scene.add(morphClip(scene, id, 0, usualSeconds)));
    return made;
}

}  // namespace mw
