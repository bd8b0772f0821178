// The mannequin as a scene: mesh, joints, skin, clips.
#include "core/character/mannequin.h"
#include "core/scene/samples.h"

namespace mw {

namespace {

std::vector<NodeId> addJoints(Scene& scene, const Skeleton& skeleton, NodeId root)
{
    std::vector<NodeId> ids;
    for (const Joint& j : skeleton.joints) {
        Node n;
        n.name = j.name;
        n.local = j.rest;
        n.joint = j.end ? Node::Joint::EndSite : Node::Joint::Joint;
        ids.push_back(scene.add(std::move(n), j.parent == none ? root : ids[j.parent]));
    }
    return ids;
}

Clip clipOf(const MannequinMotion& motion, const std::vector<NodeId>& joints)
{
    Clip clip;
    clip.name = motion.name;
    const Shared<double> times(Array<double>(motion.times.begin(), motion.times.end()));
    Array<double> places;
    for (const glm::dvec3& p : motion.hips) places.insert(places.end(), {p.x, p.y, p.z});
    clip.channels.push_back(
        std::make_shared<const Channel>(Channel{joints[0], Channel::Path::Translation, Channel::Interpolation::Linear, 3, times, places}));
    for (size_t j = 0; j < motion.rotations.size(); ++j) {
        if (motion.rotations[j].empty()) continue;
        Array<double> turns;
        for (const glm::dquat& q : motion.rotations[j]) turns.insert(turns.end(), {q.x, q.y, q.z, q.w});
        clip.channels.push_back(
            std::make_shared<const Channel>(Channel{joints[j], Channel::Path::Rotation, Channel::Interpolation::Linear, 4, times, turns}));
    }
    return clip;
}

}  // namespace

Scene mannequinScene()
{
    const Mannequin m = mannequin();
    Scene scene;
    Node root;
    root.name = "Mannequin";
    const NodeId top = scene.add(std::move(root));
    const std::vector<NodeId> joints = addJoints(scene, m.skeleton, top);
    Skin skin;
    skin.name = "Mannequin";
    for (size_t j = 0; j < joints.size(); ++j)
        if (!m.skeleton.joints[j].end) {
            skin.joints.push_back(joints[j]);
            skin.inverseBind.push_back(m.inverseBind[j]);
        }
    Material wood;
    wood.name = "Beech";
    wood.baseColor = {0.66, 0.47, 0.30, 1};
    wood.roughness = 0.55;
    MeshObject body;
    body.name = "Body";
    body.base = m.mesh;
    body.materials.push_back(scene.add(std::move(wood)));
    Node shown;
    shown.name = "Body";
    shown.mesh = scene.add(std::move(body));
    shown.skin = scene.add(std::move(skin));
    scene.add(std::move(shown), top);
    for (const MannequinMotion& motion : m.motions) scene.add(clipOf(motion, joints));
    return scene;
}

}  // namespace mw
