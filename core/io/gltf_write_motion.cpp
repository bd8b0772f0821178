#include "core/io/gltf_write_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/scene/scene_pose.h"

namespace mw {

namespace {

using nlohmann::json;

constexpr int floatType = 5126;

size_t addFloats(GltfBuilder& builder, std::span<const float> values, const char* type, size_t components)
{
    return builder.append(
        "accessors", {{"bufferView", builder.addArray(values)}, {"componentType", floatType}, {"count", values.size() / components}, {"type", type}});
}

// The root above each node.
std::map<NodeId, NodeId> rootsOf(const Scene& scene)
{
    std::map<NodeId, NodeId> root;
    for (const NodeId id : scene.nodes()) {
        const NodeId parent = scene.node(id).parent;
        root[id] = parent ? root.at(parent) : id;
    }
    return root;
}

std::set<NodeId> below(const Scene& scene, NodeId top)
{
    std::set<NodeId> all;
    std::vector<NodeId> open{top};
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        all.insert(id);
        const std::vector<NodeId>& children = scene.node(id).children;
        open.insert(open.end(), children.begin(), children.end());
    }
    return all;
}

}  // namespace

std::vector<std::vector<NodeId>> rootsToJoin(const Scene& scene)
{
    const std::map<NodeId, NodeId> root = rootsOf(scene);
    std::vector<std::set<NodeId>> groups;
    for (const SkinId id : scene.skins()) {
        std::set<NodeId> roots;
        for (const NodeId j : scene.find(id)->joints)
            if (const auto r = root.find(j); r != root.end()) roots.insert(r->second);
        if (roots.size() < 2) continue;
        // Skins that have a root in common share one parent.
        std::erase_if(groups, [&](const std::set<NodeId>& g) {
            const bool meet = std::any_of(g.begin(), g.end(), [&](NodeId r) { return roots.contains(r); });
            if (meet) roots.insert(g.begin(), g.end());
            return meet;
        });
        groups.push_back(std::move(roots));
    }
    std::vector<std::vector<NodeId>> out;
    for (const auto& g : groups) out.emplace_back(g.begin(), g.end());
    return out;
}

size_t addSkin(GltfBuilder& builder, const Scene& scene, const Skin& skin, const GltfPlaces& places)
{
    json out{{"joints", json::array()}};
    std::set<size_t> taken;
    std::vector<float> matrices;
    for (size_t i = 0; i < skin.joints.size(); ++i) {
        size_t node = places.nodes.at(skin.joints[i]);
        if (!taken.insert(node).second) {
            const size_t second = builder.append("nodes", {{"name", scene.node(skin.joints[i]).name}});
            builder.root["nodes"][node]["children"].push_back(second);
            node = second;
        }
        out["joints"].push_back(node);
        glm::dmat4 m = skin.inverseBind[i];
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                if (r == 3 || !std::isfinite(m[c][r])) m[c][r] = c == r ? 1 : 0;  // glTF wants it affine to the last bit
                matrices.push_back(float(m[c][r]));
            }
    }
    out["inverseBindMatrices"] = addFloats(builder, matrices, "MAT4", 16);
    if (!skin.name.empty()) out["name"] = skin.name;
    if (scene.find(skin.skeleton)) {
        const std::set<NodeId> under = below(scene, skin.skeleton);
        if (std::all_of(skin.joints.begin(), skin.joints.end(), [&](NodeId j) { return under.contains(j); }))
            out["skeleton"] = places.nodes.at(skin.skeleton);
    }
    return builder.append("skins", std::move(out));
}

void addSkeletons(GltfBuilder& builder, const Scene& scene, const GltfPlaces& places, const std::set<NodeId>& done)
{
    const std::map<NodeId, glm::dmat4> worlds = worldMatrices(scene, ScenePose{});
    for (const NodeId top : skeletonRoots(scene)) {
        Skin skin;
        skin.name = scene.node(top).name;
        const std::set<NodeId> under = below(scene, top);
        if (std::any_of(under.begin(), under.end(), [&](NodeId id) { return done.contains(id); })) continue;
        for (const NodeId id : under)
            if (scene.node(id).joint == Node::Joint::Joint) {
                skin.joints.push_back(id);
                skin.inverseBind.push_back(glm::inverse(worlds.at(id)));
            }
        if (!skin.joints.empty()) addSkin(builder, scene, skin, places);
    }
}

namespace {

using Path = Channel::Path;
using Interpolation = Channel::Interpolation;

/// Keys as glTF has them.
struct Keys {
    std::vector<float> times, values;
    Interpolation interpolation = Interpolation::Linear;
};

// What a channel drives there.
Path drivenBy(const Channel& c)
{
    if (c.path >= Path::EulerX) return Path::Rotation;
    return c.path >= Path::PositionX ? Path::Translation : c.path;
}

// Times that floats can tell apart: of equal ones the last counts.
std::vector<size_t> distinct(std::span<const double> times)
{
    std::vector<size_t> keep;
    for (size_t i = 0; i < times.size(); ++i)
        if (i + 1 == times.size() || float(times[i + 1]) > float(times[i])) keep.push_back(i);
    return keep;
}

void makeUnit(float* xyzw)
{
    double length = 0;
    for (int k = 0; k < 4; ++k) length += double(xyzw[k]) * double(xyzw[k]);
    length = std::sqrt(length);
    if (std::abs(length - 1) < 1e-5) return;
    for (int k = 0; k < 4; ++k) xyzw[k] = length > 0 ? float(double(xyzw[k]) / length) : k == 3 ? 1.f : 0.f;
}

// A channel that glTF has, too. `components` may differ from the channel's when the mesh lost or gained morph targets.
Keys direct(const Channel& c, size_t components)
{
    Keys out;
    out.interpolation = c.interpolation;
    const size_t from = size_t(c.components);
    const std::vector<size_t> keep = distinct(c.times);
    size_t first = 0, parts = 1;
    if (c.interpolation == Interpolation::Cubic) {
        const bool curve = keep.size() > 1;  // one key alone has no tangents
        parts = curve ? 3 : 1;
        first = curve ? 0 : 1;
        if (!curve) out.interpolation = Interpolation::Step;
    }
    const size_t perKey = c.interpolation == Interpolation::Cubic ? 3 : 1;
    for (const size_t k : keep) {
        out.times.push_back(float(c.times[k]));
        for (size_t p = first; p < first + parts; ++p)
            for (size_t i = 0; i < components; ++i) out.values.push_back(i < from ? float(c.values[(perKey * k + p) * from + i]) : 0.f);
    }
    if (c.path == Path::Rotation)
        for (size_t k = 0; k < keep.size(); ++k) makeUnit(out.values.data() + 4 * (parts * k + parts / 2));
    return out;
}

// How many pieces between two times follow the way that the channels take: straight pieces follow a spin of at most 60 degrees.
size_t pieces(std::span<const Channel* const> channels, double from, double to)
{
    constexpr double most = 64, straight = 60;
    double angle = 0, n = 1;
    for (const Channel* c : channels) {
        if (c->interpolation == Interpolation::Cubic) n = 8;
        if (c->path < Path::EulerX || c->interpolation == Interpolation::Step) continue;
        double a = 0, b = 0;
        sample(*c, from, &a);
        sample(*c, to, &b);
        angle += std::abs(b - a);
    }
    if (std::isfinite(angle)) n = std::max(n, std::ceil(angle / straight));
    return size_t(std::min(n, most));
}

// What several channels of a node make together, at all times where one of them has a key.
Keys baked(const Transform& rest, std::span<const Channel* const> channels, Path path)
{
    Keys out;
    std::vector<double> times;
    bool steps = true;
    for (const Channel* c : channels) {
        times.insert(times.end(), c->times.begin(), c->times.end());
        steps = steps && c->interpolation == Interpolation::Step;
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<double> all;
    for (size_t i = 0; i < times.size(); ++i) {
        all.push_back(times[i]);
        const size_t n = steps || i + 1 == times.size() ? 1 : pieces(channels, times[i], times[i + 1]);
        for (size_t k = 1; k < n; ++k) all.push_back(times[i] + (times[i + 1] - times[i]) * double(k) / double(n));
    }
    out.interpolation = steps ? Interpolation::Step : Interpolation::Linear;
    glm::dquat last(1, 0, 0, 0);
    for (const size_t i : distinct(all)) {
        const Transform t = sampled(rest, channels, all[i]);
        out.times.push_back(float(all[i]));
        if (path == Path::Rotation) {
            const glm::dquat q = glm::dot(last, t.rotation) < 0 ? -t.rotation : t.rotation;  // neighbours on one side of the sphere
            last = q;
            for (const double x : {q.x, q.y, q.z, q.w}) out.values.push_back(float(x));
        } else {
            const glm::dvec3& v = path == Path::Scale ? t.scale : t.translation;
            for (const double x : {v.x, v.y, v.z}) out.values.push_back(float(x));
        }
    }
    return out;
}

class AnimationWriter {
public:
    AnimationWriter(GltfBuilder& builder, const Scene& scene, const GltfPlaces& places, std::vector<Warning>& warnings)
        : builder_(builder), scene_(scene), places_(places), warnings_(warnings)
    {}
    void write(const Clip& clip);

private:
    void addKeys(json& animation, size_t node, Path path, const Keys& keys);
    void addWeights(json& animation, const Channel& c);
    size_t input(const std::vector<float>& times);

    GltfBuilder& builder_;
    const Scene& scene_;
    const GltfPlaces& places_;
    std::vector<Warning>& warnings_;
    std::map<std::vector<float>, size_t> inputs_;  // equal times are written once
    size_t lost_ = 0;
};

size_t AnimationWriter::input(const std::vector<float>& times)
{
    const auto [known, fresh] = inputs_.try_emplace(times, 0);
    if (fresh) {
        known->second = addFloats(builder_, times, "SCALAR", 1);
        json& accessor = builder_.root["accessors"][known->second];
        accessor["min"].push_back(times.front());
        accessor["max"].push_back(times.back());
    }
    return known->second;
}

void AnimationWriter::addKeys(json& animation, size_t node, Path path, const Keys& keys)
{
    const auto finite = [](const std::vector<float>& v) { return std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); }); };
    if (keys.times.empty() || !finite(keys.times) || !finite(keys.values)) {
        ++lost_;
        return;
    }
    constexpr const char* names[] = {"translation", "rotation", "scale", "weights"};
    constexpr const char* types[] = {"VEC3", "VEC4", "VEC3", "SCALAR"};
    constexpr size_t components[] = {3, 4, 3, 1};
    const auto p = size_t(path);
    json sampler{{"input", input(keys.times)}, {"output", addFloats(builder_, keys.values, types[p], components[p])}};
    if (keys.interpolation != Interpolation::Linear) sampler["interpolation"] = keys.interpolation == Interpolation::Step ? "STEP" : "CUBICSPLINE";
    animation["channels"].push_back({{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", names[p]}}}});
    animation["samplers"].push_back(std::move(sampler));
}

void AnimationWriter::addWeights(json& animation, const Channel& c)
{
    const auto shown = places_.meshes.find(c.node);
    if (shown == places_.meshes.end() || shown->second.targets == 0)
        ++lost_;
    else
        addKeys(animation, shown->second.node, c.path, direct(c, shown->second.targets));
}

void AnimationWriter::write(const Clip& clip)
{
    json animation{{"channels", json::array()}, {"samplers", json::array()}};
    if (!clip.name.empty()) animation["name"] = clip.name;
    std::map<std::pair<NodeId, Path>, std::vector<const Channel*>> by;
    for (const auto& c : clip.channels)
        if (c->keys() > 0) by[{c->node, drivenBy(*c)}].push_back(c.get());
    lost_ = 0;
    for (const auto& c : clip.channels) {
        const auto all = by.find({c->node, drivenBy(*c)});
        if (all == by.end() || all->second.front() != c.get() || !scene_.find(c->node)) continue;  // written with the first of them
        const Path path = drivenBy(*c);
        if (path == Path::Weights)
            addWeights(animation, *c);
        else if (all->second.size() == 1 && c->path == path)
            addKeys(animation, places_.nodes.at(c->node), path, direct(*c, size_t(c->components)));
        else
            addKeys(animation, places_.nodes.at(c->node), path, baked(scene_.node(c->node).local, all->second, path));
    }
    if (lost_)
        warnings_.push_back({"lost-channels",
                             "clip \"" + clip.name + "\": " + std::to_string(lost_) +
                                 " channels were left out: they drive morph targets that are not in the file, or have numbers that are none",
                             {}});
    if (!animation["channels"].empty()) builder_.append("animations", std::move(animation));
}

}  // namespace

void addAnimations(GltfBuilder& builder, const Scene& scene, const GltfPlaces& places, std::vector<Warning>& warnings)
{
    AnimationWriter writer(builder, scene, places, warnings);
    for (const ClipId id : scene.clips()) writer.write(*scene.find(id));
}

}  // namespace mw
