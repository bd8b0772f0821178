// Modifiers that work with the mesh of another node: what they see, when they are computed again, and circles.
#include <gtest/gtest.h>

#include "core/catalog/others.h"
#include "core/math/closest.h"
#include "core/mesh/triangle_tree.h"
#include "core/scene/evaluation.h"

namespace mw {
namespace {

Modifier modifier(const std::string& operation, const ParameterValues& values)
{
    Modifier m;
    m.operation = operation;
    m.values = values;
    return m;
}

struct Pair {
    Scene scene;
    MeshId first, second;

    explicit Pair(const std::string& other = "second")
    {
        first = add("first", "icosphere:subdivisions=3", {{"project-onto", {{"other", other}}}});
        second = add("second", "torus", {});
    }
    MeshId add(const std::string& name, const char* source, std::vector<std::pair<std::string, ParameterValues>> stack)
    {
        MeshObject object;
        object.name = name;
        object.base = *meshOfSource(source);
        for (auto& [operation, values] : stack) object.stack.push_back(modifier(operation, values));
        Node node;
        node.name = name;
        node.mesh = scene.add(std::move(object));
        const MeshId id = node.mesh;
        scene.add(std::move(node));
        return id;
    }
    void replace(MeshId id, Mesh base)
    {
        MeshObject object = *scene.find(id);
        object.base = std::move(base);
        scene.set(id, std::move(object));
    }
};

double farthestFrom(const Mesh& mesh, const Mesh& surface)
{
    const TriangleTree tree(surface);
    double worst = 0;
    for (const glm::vec3& p : mesh.positions()) worst = std::max(worst, std::sqrt(tree.closest(p).distance2));
    return worst;
}

TEST(OtherMeshes, AreSeenAsTheirNodesShowThem)
{
    Pair p;
    Evaluator evaluator;
    const Evaluation e = evaluator.evaluate(*p.scene.find(p.first), nullptr, {}, &p.scene);
    ASSERT_TRUE(e.levels.at(0).error.empty()) << e.levels[0].error;
    EXPECT_LT(farthestFrom(e.result(), p.scene.find(p.second)->base), 1e-6);
    // With a modifier of its own the other one shows something else.
    MeshObject object = *p.scene.find(p.second);
    object.stack.push_back(modifier("decimate-quadric", {{"ratio", 0.1}}));
    p.scene.set(p.second, object);
    const Mesh shown = *evaluator.meshOf(p.scene, "second");
    EXPECT_LT(shown.faceCount(), object.base.faceCount() * 2 / 5);
    const Evaluation again = evaluator.evaluate(*p.scene.find(p.first), nullptr, {}, &p.scene);
    EXPECT_FALSE(again.levels[0].cached);
    EXPECT_LT(farthestFrom(again.result(), shown), 1e-6);
}

TEST(OtherMeshes, AreWorkedWithAgainOnceTheyHaveChanged)
{
    Pair p;
    Evaluator evaluator;
    const auto evaluate = [&] { return evaluator.evaluate(*p.scene.find(p.first), nullptr, {}, &p.scene); };
    EXPECT_FALSE(evaluate().levels[0].cached);
    EXPECT_TRUE(evaluate().levels[0].cached);
    p.replace(p.second, *meshOfSource("box"));
    const Evaluation changed = evaluate();
    EXPECT_FALSE(changed.levels[0].cached);
    EXPECT_LT(farthestFrom(changed.result(), *meshOfSource("box")), 1e-6);
    EXPECT_TRUE(evaluate().levels[0].cached);
}

TEST(OtherMeshes, CirclesAreToldAndEndNothingElse)
{
    Pair p;
    MeshObject object = *p.scene.find(p.second);
    object.stack.push_back(modifier("project-onto", {{"other", std::string("first")}}));
    p.scene.set(p.second, object);
    Evaluator evaluator;
    const Evaluation e = evaluator.evaluate(*p.scene.find(p.first), nullptr, {}, &p.scene);
    ASSERT_FALSE(e.levels[0].error.empty());
    EXPECT_NE(e.levels[0].error.find("first"), std::string::npos) << e.levels[0].error;
    EXPECT_EQ(e.result().positions().id(), p.scene.find(p.first)->base.positions().id()) << "the last good mesh stays";
    Pair itself("first");
    EXPECT_FALSE(evaluator.evaluate(*itself.scene.find(itself.first), nullptr, {}, &itself.scene).levels[0].error.empty());
}

TEST(OtherMeshes, MayBeSourcesAndMustBeThere)
{
    Pair source("box:segments=1");
    Evaluator evaluator;
    const Evaluation e = evaluator.evaluate(*source.scene.find(source.first), nullptr, {}, &source.scene);
    EXPECT_TRUE(e.levels[0].error.empty());
    EXPECT_LT(farthestFrom(e.result(), *meshOfSource("box:segments=1")), 1e-6);
    Pair nobody("nobody");
    const Evaluation none = evaluator.evaluate(*nobody.scene.find(nobody.first), nullptr, {}, &nobody.scene);
    EXPECT_NE(none.levels[0].error.find("nobody"), std::string::npos) << none.levels[0].error;
}

}  // namespace
}  // namespace mw
