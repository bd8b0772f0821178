// Scene edits, history, change notices and evaluation.
#include "core/scene/document.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

namespace mw {
namespace {

Mesh triangle(float size = 1)
{
    return Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, Array<uint32_t>{0, 1, 2});
}

NodeId addTriangle(Scene& s, const std::string& name, NodeId parent = {})
{
    Node n;
    n.name = name;
    MeshObject object;
    object.name = name;
    object.base = triangle();
    n.mesh = s.add(object);
    return s.add(n, parent);
}

TEST(Scene, TreeAndWorldMatrices)
{
    Scene s;
    Node group;
    group.name = "group";
    group.local.translation = {1, 2, 3};
    group.local.rotation = glm::angleAxis(glm::radians(90.0), glm::dvec3(0, 1, 0));
    const NodeId g = s.add(group), a = addTriangle(s, "a", g), b = addTriangle(s, "b", a);
    EXPECT_EQ(s.nodes(), (std::vector<NodeId>{g, a, b}));
    const glm::dvec4 p = s.worldFromLocal(b) * glm::dvec4(1, 0, 0, 1);  // +X turned a quarter about +Y is -Z
    EXPECT_NEAR(p.x, 1, 1e-12);
    EXPECT_NEAR(p.y, 2, 1e-12);
    EXPECT_NEAR(p.z, 2, 1e-12);
    EXPECT_THROW(s.reparent(g, b), Error);
    s.reparent(b, {});
    EXPECT_EQ(s.roots(), (std::vector<NodeId>{g, b}));
    s.remove(g);
    EXPECT_EQ(s.nodes(), std::vector<NodeId>{b});
    EXPECT_EQ(s.meshes().size(), 1u) << "a payload nobody uses goes with its node";
}

TEST(Scene, CopiesAreIndependentAndMergeRenames)
{
    Scene s;
    const NodeId a = addTriangle(s, "a");
    const Scene copy = s;
    Node changed = s.node(a);
    changed.name = "other";
    s.set(a, changed);
    EXPECT_EQ(copy.node(a).name, "a");
    EXPECT_NE(contentHash(copy), contentHash(s));
    Scene both = copy;
    const auto added = both.merge(s);
    ASSERT_EQ(added.size(), 1u);
    EXPECT_NE(added[0], a);
    EXPECT_EQ(both.node(added[0]).name, "other");
    EXPECT_NE(both.node(added[0]).mesh, both.node(a).mesh);
    EXPECT_EQ(both.meshes().size(), 2u);
}

TEST(Scene, TransformsFromMatrices)
{
    Transform t;
    t.translation = {3, -1, 2};
    t.rotation = glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7));
    for (const glm::dvec3 scale : {glm::dvec3(1, 2, 3), glm::dvec3(-1, 2, 3)}) {
        t.scale = scale;
        bool exact = false;
        const glm::dmat4 back = transformOf(t.matrix(), &exact).matrix();
        EXPECT_TRUE(exact);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) EXPECT_NEAR(back[c][r], t.matrix()[c][r], 1e-9);
    }
    glm::dmat4 shear(1);
    shear[1][0] = 0.5;
    bool exact = true;
    transformOf(shear, &exact);
    EXPECT_FALSE(exact);
}

TEST(Scene, RestoredRefusesWhatDoesNotFit)
{
    Scene::Parts parts;
    parts.nodes[{1}] = Node{"a", {}, {}, {NodeId{2}}, true, {}, {}};
    parts.roots = {{1}};
    EXPECT_THROW(Scene::restored(parts), Error);
    parts.nodes[{2}] = Node{"b", {}, NodeId{1}, {}, true, {}, {}};
    EXPECT_EQ(Scene::restored(parts).nodes().size(), 2u);
    parts.nodes[{2}].mesh = {9};
    EXPECT_THROW(Scene::restored(parts), Error);
}

TEST(Document, HistoryUndoRedoAndNotices)
{
    Document d;
    std::vector<Change> heard;
    const auto token = d.subscribe([&](const Change& c) { heard.push_back(c); });
    Scene s = d.scene();
    const NodeId a = addTriangle(s, "a");
    d.commit("Add a", s);
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_TRUE(heard[0].aspects & Aspect::Tree);
    EXPECT_TRUE(heard[0].nodes.contains(a));
    EXPECT_TRUE(d.modified());
    EXPECT_EQ(d.undoName(), "Add a");

    Node moved = d.scene().node(a);
    moved.local.translation.x = 5;
    Scene t = d.scene();
    t.set(a, moved);
    d.commit("a: move", t);
    EXPECT_TRUE(heard.back().aspects & Aspect::Transform);
    EXPECT_FALSE(heard.back().aspects & Aspect::Tree);

    const uint64_t after = contentHash(d.scene());
    d.undo();
    EXPECT_EQ(contentHash(d.scene()), contentHash(s));
    EXPECT_EQ(d.redoName(), "a: move");
    d.redo();
    EXPECT_EQ(contentHash(d.scene()), after);
    d.goTo(0);
    EXPECT_TRUE(d.scene().nodes().empty());
    EXPECT_FALSE(d.modified());
    EXPECT_FALSE(d.canUndo());
}

TEST(Document, PreviewIsInNoHistory)
{
    Document d;
    Scene s = d.scene();
    const NodeId a = addTriangle(s, "a");
    d.commit("Add a", s);
    Scene dragged = s;
    Node n = s.node(a);
    n.local.translation.x = 9;
    dragged.set(a, n);
    d.preview(dragged);
    EXPECT_EQ(d.scene().node(a).local.translation.x, 9);
    EXPECT_EQ(d.history().size(), 2u);
    d.cancelPreview();
    EXPECT_EQ(d.scene().node(a).local.translation.x, 0);
}

TEST(Document, SelectionOfElementsGoesWithItsMesh)
{
    Document d;
    Scene s = d.scene();
    const NodeId a = addTriangle(s, "a");
    d.commit("Add a", s);
    Selection sel;
    sel.nodes = {a};
    sel.elementsOf = a;
    sel.elements = {ElementKind::Vertex, {0, 2}};
    d.select(sel);
    Scene t = d.scene();
    MeshObject object = *t.find(t.node(a).mesh);
    object.base = triangle(2);
    t.set(t.node(a).mesh, object);
    d.commit("a: other mesh", t);
    EXPECT_TRUE(d.selection().has(a));
    EXPECT_FALSE(d.selection().elementsOf);
    d.undo();
    EXPECT_EQ(d.selection().elements.indices.size(), 2u) << "the selection rides with its entry";
    Scene u = d.scene();
    u.remove(a);
    d.commit("Delete a", u);
    EXPECT_TRUE(d.selection().nodes.empty());
}

TEST(Document, TheSavedStateIsRemembered)
{
    Document d;
    Scene s = d.scene();
    addTriangle(s, "a");
    d.commit("Add a", s);
    d.saved("a.glb");
    EXPECT_FALSE(d.modified());
    d.undo();
    EXPECT_TRUE(d.modified());
    addTriangle(s, "b");
    d.commit("Add b", s);  // cuts the saved state off
    EXPECT_TRUE(d.modified());
    d.undo();
    EXPECT_TRUE(d.modified());
}

TEST(Evaluation, UnknownOperationsAreSaidAndWhatFollowsWaits)
{
    MeshObject object;
    object.base = triangle();
    object.stack.push_back({{7}, "from-the-future", {}, true});
    object.stack.push_back({{8}, "from-the-future", {}, true});
    object.stack.push_back({{9}, "from-the-future", {}, false});
    const Evaluation e = Evaluator().evaluate(object);
    EXPECT_NE(e.levels[0].error.find("from-the-future"), std::string::npos);
    EXPECT_TRUE(e.levels[1].waits);
    EXPECT_FALSE(e.levels[2].waits);
    EXPECT_EQ(contentHash(e.result()), contentHash(object.base));
}

}  // namespace
}  // namespace mw
