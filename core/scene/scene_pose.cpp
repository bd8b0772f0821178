// World matrices, poses of meshes and skeletons at a time, and the scene frozen there. No recursion: files may nest a hundred thousand joints.
#include "core/scene/scene_pose.h"

#include <algorithm>
#include <set>

namespace mw {

namespace {

const Transform& localOf(const Scene& scene, NodeId id, const ScenePose& pose)
{
    const auto posed = pose.locals.find(id);
    return posed == pose.locals.end() ? scene.node(id).local : posed->second;
}

/// As many as the mesh has morph targets; empty when all are 0.
std::vector<float> morphWeights(const Scene& scene, NodeId node, const Mesh& shown, const ScenePose& pose)
{
    const auto posed = pose.weights.find(node);
    const std::vector<double>& given = posed == pose.weights.end() ? scene.node(node).morphWeights : posed->second;
    std::vector<float> weights;
    for (const Attribute& a : shown.attributes())
        if (a.domain == Domain::Vertex && a.name.starts_with(names::morph))
            weights.push_back(weights.size() < given.size() ? float(given[weights.size()]) : 0.f);
    if (std::all_of(weights.begin(), weights.end(), [](float w) { return w == 0; })) weights.clear();
    return weights;
}

bool isSkinned(const Mesh& m)
{
    return m.find(names::joints, Domain::Vertex) && m.find(names::weights, Domain::Vertex);
}

}  // namespace

ScenePose poseAt(const Scene& scene, const Clip& clip, double time)
{
    std::map<NodeId, std::vector<const Channel*>> driven;
    ScenePose pose;
    for (const auto& c : clip.channels) {
        if (c->keys() == 0 || !scene.find(c->node)) continue;
        if (c->path == Channel::Path::Weights) {
            std::vector<double>& weights = pose.weights[c->node];
            weights.resize(size_t(c->components));
            sample(*c, time, weights.data());
        } else {
            driven[c->node].push_back(c.get());
        }
    }
    for (const auto& [node, channels] : driven) pose.locals[node] = sampled(scene.node(node).local, channels, time);
    return pose;
}

std::map<NodeId, glm::dmat4> worldMatrices(const Scene& scene, const ScenePose& pose)
{
    std::map<NodeId, glm::dmat4> worlds;
    for (const NodeId id : scene.nodes()) {  // depth first: a parent comes before its children
        const glm::dmat4 local = localOf(scene, id, pose).matrix();
        const NodeId parent = scene.node(id).parent;
        worlds[id] = parent ? worlds.at(parent) * local : local;
    }
    return worlds;
}

std::shared_ptr<const MeshPose> meshPose(const Scene& scene, NodeId node, const Mesh& shown, const ScenePose& pose,
                                         const std::map<NodeId, glm::dmat4>& worlds)
{
    MeshPose p;
    p.morphWeights = morphWeights(scene, node, shown, pose);
    if (const Skin* skin = scene.find(scene.node(node).skin); skin && isSkinned(shown))
        for (size_t i = 0; i < skin->joints.size(); ++i) {
            const auto world = worlds.find(skin->joints[i]);  // a joint that is gone leaves its vertices where the mesh has them
            p.joints.push_back(world == worlds.end() ? glm::mat4(1.f) : glm::mat4(world->second * skin->inverseBind[i]));
        }
    if (p.joints.empty() && p.morphWeights.empty()) return nullptr;
    return std::make_shared<const MeshPose>(std::move(p));
}

glm::dmat4 worldFromMesh(const Scene& scene, NodeId node, const std::map<NodeId, glm::dmat4>& worlds)
{
    return scene.find(scene.node(node).skin) ? glm::dmat4(1) : worlds.at(node);
}

std::vector<NodeId> skeletonRoots(const Scene& scene)
{
    std::vector<NodeId> roots;
    std::set<NodeId> within;
    for (const NodeId id : scene.nodes()) {
        const Node& n = scene.node(id);
        const bool below = within.contains(n.parent);
        if (n.joint == Node::Joint::No && !below) continue;
        within.insert(id);
        if (!below) roots.push_back(id);
    }
    return roots;
}

Pose poseOf(const Scene& scene, NodeId skeletonRoot, const ScenePose& pose)
{
    std::vector<NodeId> order, open{skeletonRoot};
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        order.push_back(id);
        const std::vector<NodeId>& children = scene.node(id).children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    // Only what leads to a joint: a mesh held in a hand is no part of the skeleton.
    std::set<NodeId> needed{skeletonRoot};
    for (auto id = order.rbegin(); id != order.rend(); ++id)
        if (scene.node(*id).joint != Node::Joint::No || needed.contains(*id)) needed.insert({*id, scene.node(*id).parent});

    auto skeleton = std::make_shared<Skeleton>();
    Pose p;
    std::map<NodeId, uint32_t> number;
    for (const NodeId id : order) {
        if (!needed.contains(id)) continue;
        const Node& n = scene.node(id);
        const uint32_t parent = id == skeletonRoot ? none : number.at(n.parent);
        number[id] = uint32_t(skeleton->joints.size());
        skeleton->joints.push_back({n.name, parent, n.local, id, n.joint == Node::Joint::EndSite});
        p.locals.push_back(localOf(scene, id, pose));
    }
    for (NodeId a = scene.node(skeletonRoot).parent; a; a = scene.node(a).parent)
        p.worldFromParent = localOf(scene, a, pose).matrix() * p.worldFromParent;
    p.skeleton = std::move(skeleton);
    return p;
}

namespace {

using Numbers = std::vector<double>;

Numbers numbers(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}
Numbers numbers(const glm::dquat& q)
{
    return {q.x, q.y, q.z, q.w};
}

std::shared_ptr<const Channel> twoKeys(NodeId node, Channel::Path path, const Shared<double>& times, const Numbers& from, const Numbers& to)
{
    Channel c;
    c.node = node;
    c.path = path;
    c.components = int(from.size());
    c.times = times;
    Array<double> values(from.begin(), from.end());
    values.insert(values.end(), to.begin(), to.end());
    c.values = std::move(values);
    return std::make_shared<const Channel>(std::move(c));
}

}  // namespace

Clip keyed(const Pose& from, const Pose& to, double seconds, std::string name)
{
    Clip clip;
    clip.name = std::move(name);
    const Shared<double> times(Array<double>{0.0, seconds});
    for (size_t i = 0; i < from.size(); ++i) {
        const Joint& j = from.skeleton->joints[i];
        const Transform &a = from.locals[i], &b = to.locals[i];
        const auto add = [&](Channel::Path path, const Numbers& first, const Numbers& last) {
            clip.channels.push_back(twoKeys(j.node, path, times, first, last));
        };
        if (!j.end) add(Channel::Path::Rotation, numbers(a.rotation), numbers(b.rotation));
        if (a.translation != j.rest.translation || b.translation != j.rest.translation)
            add(Channel::Path::Translation, numbers(a.translation), numbers(b.translation));
        if (a.scale != j.rest.scale || b.scale != j.rest.scale) add(Channel::Path::Scale, numbers(a.scale), numbers(b.scale));
    }
    return clip;
}

namespace {

/// Without what only makes sense with a skin or with weights.
Mesh still(Mesh mesh)
{
    std::vector<std::string> moving;
    for (const Attribute& a : mesh.attributes())
        if (a.name == names::joints || a.name == names::weights || a.name.starts_with(names::morph) || a.name.starts_with("morph-normal:") ||
            a.name.starts_with("morph-color:"))
            moving.push_back(a.name);
    for (const std::string& name : moving) mesh = mesh.without(name);
    return mesh;
}

/// Puts together the parts of a frozen scene.
class Freezer {
public:
    Freezer(const Scene& scene, const ScenePose& pose, const std::function<Mesh(MeshId)>& shown)
        : scene_(scene), pose_(pose), shown_(shown), worlds_(worldMatrices(scene, pose))
    {}
    Scene run();

private:
    void copyPayloads();
    void freeze(NodeId id);
    void standAlone(Node node, NodeId id);
    const Mesh& meshOf(MeshId id);

    const Scene& scene_;
    const ScenePose& pose_;
    const std::function<Mesh(MeshId)>& shown_;
    const std::map<NodeId, glm::dmat4> worlds_;
    std::map<MeshId, Mesh> meshes_;  // evaluated, by id
    std::set<NodeId> hidden_;        // they or something above them
    Scene::Parts parts_;
    uint32_t next_ = 1;
};

void Freezer::copyPayloads()
{
    const auto take = [&](const auto& ids, auto& to) {
        for (const auto id : ids) {
            to[id] = *scene_.find(id);
            next_ = std::max(next_, id.value + 1);
        }
    };
    take(scene_.images(), parts_.images);
    take(scene_.materials(), parts_.materials);
    take(scene_.terrains(), parts_.terrains);
    for (const NodeId id : scene_.nodes()) next_ = std::max(next_, id.value + 1);
    for (const MeshId id : scene_.meshes()) next_ = std::max(next_, id.value + 1);
}

const Mesh& Freezer::meshOf(MeshId id)
{
    auto known = meshes_.find(id);
    if (known == meshes_.end()) known = meshes_.emplace(id, shown_(id)).first;
    return known->second;
}

void Freezer::freeze(NodeId id)
{
    Node n = scene_.node(id);
    if (!n.visible || hidden_.contains(n.parent)) hidden_.insert(id);
    n.local = localOf(scene_, id, pose_);
    n.joint = Node::Joint::No;
    n.morphWeights.clear();
    if (const MeshObject* object = scene_.find(n.mesh)) {
        const Mesh& mesh = meshOf(n.mesh);
        MeshId own = n.mesh;  // nodes that show one mesh in different poses get one each
        if (const auto pose = meshPose(scene_, id, mesh, pose_, worlds_)) {
            own = {next_++};
            parts_.meshes[own] = {object->name, still(posed(mesh, *pose)), object->materials, {}};
        } else if (!parts_.meshes.contains(own)) {
            parts_.meshes[own] = {object->name, still(mesh), object->materials, {}};
        }
        n.mesh = own;
        if (scene_.find(n.skin)) {
            standAlone(n, id);
            n.mesh = {};
        }
    }
    n.skin = {};
    parts_.nodes[id] = std::move(n);
}

/// A skinned mesh is posed in world space: it is shown by a root of its own.
void Freezer::standAlone(Node node, NodeId id)
{
    node.local = {};
    node.parent = {};
    node.children.clear();
    node.skin = {};
    node.visible = !hidden_.contains(id);
    const NodeId root{next_++};
    parts_.nodes[root] = std::move(node);
    parts_.roots.push_back(root);
}

Scene Freezer::run()
{
    copyPayloads();
    for (const NodeId id : scene_.nodes()) freeze(id);
    parts_.roots.insert(parts_.roots.begin(), scene_.roots().begin(), scene_.roots().end());
    return Scene::restored(std::move(parts_));
}

}  // namespace

Scene frozen(const Scene& scene, const ScenePose& pose, const std::function<Mesh(MeshId)>& shown)
{
    return Freezer(scene, pose, shown).run();
}

}  // namespace mw
