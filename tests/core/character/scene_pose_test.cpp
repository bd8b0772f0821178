// Worlds, skeletons and frozen scenes of hand-made scenes.
#include "core/scene/scene_pose.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace mw {
namespace {

constexpr double quarter = 1.5707963267948966;

void expectAt(const glm::dvec3& p, const glm::dvec3& q, double tolerance = 1e-6)
{
    EXPECT_LE(glm::length(p - q), tolerance) << p.x << " " << p.y << " " << p.z << " instead of " << q.x << " " << q.y << " " << q.z;
}

/// An arm of two bones of length 1 along x below a holder at (0, 0, 5); a skinned strip along it; the elbow turns a quarter about z in a second.
struct Arm {
    Scene scene;
    NodeId holder, shoulder, gap, elbow, hand, strip, ball;
    Clip clip;
    Arm();
};

NodeId addNode(Scene& s, const char* name, NodeId parent, glm::dvec3 at, Node::Joint joint)
{
    Node n;
    n.name = name;
    n.local.translation = at;
    n.joint = joint;
    return s.add(n, parent);
}

Arm::Arm()
{
    using enum Node::Joint;
    holder = addNode(scene, "holder", {}, {0, 0, 5}, No);
    shoulder = addNode(scene, "shoulder", holder, {0, 0, 0}, Joint);
    gap = addNode(scene, "gap", shoulder, {0.5, 0, 0}, No);
    elbow = addNode(scene, "elbow", gap, {0.5, 0, 0}, Joint);
    hand = addNode(scene, "hand", elbow, {1, 0, 0}, EndSite);

    Mesh m = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Array<uint32_t>{0, 1, 2});
    m = m.with(integerAttribute("joints", Domain::Vertex, 4, {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
    m = m.with(floatAttribute("weights", Domain::Vertex, 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
    m = m.with(floatAttribute("morph:tall", Domain::Vertex, 3, {0, 1, 0, 0, 0, 0, 0, 0, 0}));
    Node n;
    n.name = "strip";
    n.local.translation = {100, 100, 100};  // does not count: it is skinned
    n.mesh = scene.add(MeshObject{"strip", m, {}, {}});
    n.skin = scene.add(Skin{"skin", {shoulder, elbow}, {glm::dmat4(1), glm::translate(glm::dmat4(1), glm::dvec3(-1, 0, 0))}, {}});
    strip = scene.add(n, holder);
    Node b;
    b.name = "ball";
    b.mesh = scene.add(MeshObject{"ball", Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Array<uint32_t>{0, 1, 2}), {}, {}});
    ball = scene.add(b, elbow);

    clip.name = "bend";
    Channel turn;
    turn.node = elbow;
    turn.path = Channel::Path::EulerZ;
    turn.components = 1;
    turn.times = Array<double>{0, 1};
    turn.values = Array<double>{0, 90};
    Channel grow = turn;
    grow.node = strip;
    grow.path = Channel::Path::Weights;
    grow.values = Array<double>{0, 2};
    clip.channels = {std::make_shared<const Channel>(turn), std::make_shared<const Channel>(grow)};
}

TEST(ScenePose, WorldsFollowTheClip)
{
    const Arm arm;
    const auto rest = worldMatrices(arm.scene, {});
    expectAt(rest.at(arm.hand)[3], {2, 0, 5});
    const ScenePose pose = poseAt(arm.scene, arm.clip, 1);
    const auto worlds = worldMatrices(arm.scene, pose);
    expectAt(worlds.at(arm.elbow)[3], {1, 0, 5});
    expectAt(worlds.at(arm.hand)[3], {1, 1, 5});
    EXPECT_EQ(pose.weights.at(arm.strip), std::vector<double>{2});
    EXPECT_EQ(worldFromMesh(arm.scene, arm.strip, worlds), glm::dmat4(1));
    EXPECT_EQ(worldFromMesh(arm.scene, arm.ball, worlds), worlds.at(arm.ball));
}

TEST(ScenePose, MeshPoseOnlyWhereSomethingMoves)
{
    const Arm arm;
    const auto mesh = [&](NodeId n) { return arm.scene.find(arm.scene.node(n).mesh)->base; };
    const auto worlds = worldMatrices(arm.scene, {});
    EXPECT_EQ(meshPose(arm.scene, arm.ball, mesh(arm.ball), {}, worlds), nullptr);
    const auto p = meshPose(arm.scene, arm.strip, mesh(arm.strip), {}, worlds);
    ASSERT_TRUE(p);
    EXPECT_EQ(p->joints.size(), 2u);
    EXPECT_TRUE(p->morphWeights.empty());
    expectAt(glm::dvec3(p->joints[1] * glm::vec4(2, 0, 0, 1)), {2, 0, 5});
}

TEST(ScenePose, SkeletonsLeaveOutWhatIsHeld)
{
    const Arm arm;
    EXPECT_EQ(skeletonRoots(arm.scene), std::vector<NodeId>{arm.shoulder});
    const Pose p = poseOf(arm.scene, arm.shoulder, poseAt(arm.scene, arm.clip, 1));
    ASSERT_EQ(p.size(), 4u) << "shoulder, gap, elbow, hand; not the ball";
    EXPECT_EQ(p.skeleton->joints[2].name, "elbow");
    EXPECT_EQ(p.skeleton->joints[2].parent, 1u);
    EXPECT_TRUE(p.skeleton->joints[3].end);
    expectAt(jointPlaces(p)[3], {1, 1, 5});
}

TEST(ScenePose, KeyedLeadsFromOnePoseToTheOther)
{
    const Arm arm;
    const Pose from = poseOf(arm.scene, arm.shoulder);
    Pose to = from;
    to.locals[0].rotation = glm::angleAxis(quarter, glm::dvec3(0, 0, 1));
    to.locals[2].translation = {0, 0, 3};
    Scene s = arm.scene;
    const Clip clip = keyed(from, to, 2, "reach");
    EXPECT_EQ(clip.name, "reach");
    EXPECT_EQ(duration(clip), 2);
    const auto start = worldMatrices(s, poseAt(s, clip, 0)), end = worldMatrices(s, poseAt(s, clip, 2)), half = worldMatrices(s, poseAt(s, clip, 1));
    for (size_t i = 0; i < from.size(); ++i) {
        expectAt(start.at(from.skeleton->joints[i].node)[3], jointPlaces(from)[i], 1e-12);
        expectAt(end.at(from.skeleton->joints[i].node)[3], jointPlaces(to)[i], 1e-12);
    }
    expectAt(half.at(arm.gap)[3], {0.5 * std::sqrt(0.5), 0.5 * std::sqrt(0.5), 5}, 1e-12);
}

TEST(ScenePose, FrozenStandsWhereItWas)
{
    const Arm arm;
    const auto shown = [&](MeshId id) { return arm.scene.find(id)->base; };
    const Scene f = frozen(arm.scene, poseAt(arm.scene, arm.clip, 1), shown);
    EXPECT_TRUE(f.skins().empty());
    EXPECT_TRUE(f.clips().empty());
    ASSERT_EQ(f.meshes().size(), 2u);
    int found = 0;
    for (const NodeId id : f.nodes()) {
        const Node& n = f.node(id);
        EXPECT_EQ(n.joint, Node::Joint::No);
        const MeshObject* o = f.find(n.mesh);
        if (!o) continue;
        ++found;
        const glm::dmat4 world = f.worldFromLocal(id);
        const auto at = [&](size_t v) { return glm::dvec3(world * glm::dvec4(o->base.positions()[v], 1)); };
        EXPECT_TRUE(o->base.attributes().empty());
        if (n.name == "strip") {
            expectAt(at(0), {0, 2, 5});  // grown by 2 in the mesh, then carried by the shoulder
            expectAt(at(1), {1, 0, 5});
            expectAt(at(2), {1, 1, 5});
        } else {
            expectAt(at(0), {1, 0, 5});
            expectAt(at(1), {1, 1, 5});
        }
    }
    EXPECT_EQ(found, 2);
    expectAt(f.worldFromLocal(arm.hand)[3], {1, 1, 5});
}

TEST(ScenePose, HiddenStaysHidden)
{
    Arm arm;
    Node n = arm.scene.node(arm.holder);
    n.visible = false;
    arm.scene.set(arm.holder, n);
    const Scene f = frozen(arm.scene, {}, [&](MeshId id) { return arm.scene.find(id)->base; });
    for (const NodeId root : f.roots()) EXPECT_FALSE(f.node(root).visible);
}

// A chain far deeper than any stack allows.
TEST(ScenePose, DeepTrees)
{
    Scene s;
    NodeId last;
    const int depth = 200000;
    for (int i = 0; i < depth; ++i) last = addNode(s, "j", last, {0, 1, 0}, Node::Joint::Joint);
    expectAt(worldMatrices(s, {}).at(last)[3], {0, depth, 0});
    ASSERT_EQ(skeletonRoots(s).size(), 1u);
    const Pose p = poseOf(s, s.roots()[0]);
    ASSERT_EQ(p.size(), size_t(depth));
    expectAt(jointPlaces(p).back(), {0, depth, 0});
    EXPECT_EQ(frozen(s, {}, [](MeshId) { return Mesh(); }).nodes().size(), size_t(depth));
}

}  // namespace
}  // namespace mw
