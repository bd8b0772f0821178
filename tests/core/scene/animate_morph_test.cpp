// Clips that play morph targets, of meshes as they are and of modifiers that make targets.
#include "core/scene/animate_morph.h"

#include <gtest/gtest.h>

#include "core/catalog/others.h"
#include "core/mesh/topology.h"
#include "core/scene/edit.h"
#include "core/scene/evaluation.h"
#include "core/scene/scene_pose.h"

namespace mw {
namespace {

NodeId put(Scene& scene, const char* name, Mesh mesh)
{
    Node n;
    n.name = name;
    MeshObject object;
    object.name = name;
    object.base = std::move(mesh);
    n.mesh = scene.add(std::move(object));
    return scene.add(std::move(n));
}

TEST(AnimateMorph, PlaysThereAndBackOfAModifiersResult)
{
    Scene scene;
    const NodeId ball = put(scene, "ball", *meshOfSource("icosphere:subdivisions=2"));
    put(scene, "cube", *meshOfSource("box:width=3,height=3,depth=3"));
    EXPECT_THROW(edited(scene, {"animate-morph", {{"node", std::string("ball")}}}), Error) << "nothing to play";
    scene = edited(scene, {"modify", {{"node", std::string("ball")}, {"op", std::string("morph")}, {"with", std::string("other=cube")}}});
    EXPECT_FALSE(playsMorphs(scene, ball));
    scene = edited(scene, {"animate-morph", {{"node", std::string("ball")}, {"seconds", 3.0}}});
    EXPECT_TRUE(playsMorphs(scene, ball));
    const Clip& clip = *scene.find(scene.clips().back());
    EXPECT_EQ(duration(clip), 3);
    const Evaluation e = Evaluator().evaluate(*scene.find(scene.node(ball).mesh), nullptr, {}, &scene);
    ASSERT_TRUE(e.levels[0].error.empty()) << e.levels[0].error;
    const auto volumeAt = [&](double time) {
        const ScenePose pose = poseAt(scene, clip, time);
        const auto worlds = worldMatrices(scene, pose);
        const auto posedBy = meshPose(scene, ball, e.result(), pose, worlds);
        return enclosedVolume(posedBy ? posed(e.result(), *posedBy) : e.result());
    };
    EXPECT_NEAR(volumeAt(0), enclosedVolume(scene.find(scene.node(ball).mesh)->base), 1e-5);
    EXPECT_NEAR(volumeAt(1.5), 27, 1e-4);
    EXPECT_NEAR(volumeAt(3), volumeAt(0), 1e-9);
    EXPECT_GT(volumeAt(0.75), volumeAt(0) + 1);
}

TEST(AnimateMorph, DrivesTheTargetThatIsNamed)
{
    Scene scene;
    Mesh mesh = *meshOfSource("icosphere:subdivisions=1");
    for (const char* other : {"box", "uv-sphere", "icosphere:radius=2"}) {
        const Operation& op = operation("morph");
        const ParameterValues values = parsed(op.parameters, std::string("other=\"") + other + "\"");
        mesh = std::get<Mesh>(apply(op, mesh, values, nullptr, othersOf(op, values)));
    }
    const NodeId node = put(scene, "ball", mesh);
    EXPECT_EQ(morphTargets(*scene.find(scene.node(node).mesh)), 3u);
    const Clip clip = morphClip(scene, node, 2, 1);
    const ScenePose pose = poseAt(scene, clip, 0.5);
    EXPECT_EQ(pose.weights.at(node), (std::vector<double>{0, 1, 0}));
    EXPECT_EQ(poseAt(scene, morphClip(scene, node, 0, 1), 0.5).weights.at(node), (std::vector<double>{0, 0, 1}));
    EXPECT_THROW(morphClip(scene, node, 4, 1), Error);
}

TEST(AnimateMorph, LeavesClipsThatAreThere)
{
    Scene scene;
    const NodeId node = put(scene, "ball", *meshOfSource("icosphere:subdivisions=1"));
    const MeshId mesh = scene.node(node).mesh;
    EXPECT_TRUE(animateNewMorphs(scene, mesh, 0).empty()) << "no target is new";
    MeshObject object = *scene.find(mesh);
    object.stack.push_back({scene.newModifierId(), "morph", {{"other", std::string("box")}}, true});
    scene.set(mesh, object);
    EXPECT_EQ(animateNewMorphs(scene, mesh, 0).size(), 1u);
    EXPECT_TRUE(animateNewMorphs(scene, mesh, 0).empty()) << "it plays already";
}

}  // namespace
}  // namespace mw
