// Edits of nodes and base meshes, against what geometry says: areas and volumes add up, Euler characteristics follow.
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numeric>

#include "core/mesh/topology.h"
#include "core/scene/edit.h"
#include "core/terrain/brush.h"

namespace mw {
namespace {

Document withEdits(std::initializer_list<const char*> edits)
{
    Document d;
    for (const char* text : edits) commitEdit(d, parsedEdit(text));
    return d;
}

const Mesh& meshOf(const Document& d, const char* node)
{
    return d.scene().find(d.scene().node(nodeOf(d.scene(), node)).mesh)->base;
}

std::string refusal(Document& d, const char* text)
{
    const uint64_t before = contentHash(d.scene());
    try {
        commitEdit(d, parsedEdit(text));
    } catch (const Error& e) {
        EXPECT_EQ(contentHash(d.scene()), before);
        return e.what();
    }
    return "accepted";
}

TEST(EditMesh, JoinKeepsWhereEverythingStands)
{
    Document d = withEdits({"add:op=icosphere,with=subdivisions=2,name=a", "add:op=icosphere,with=subdivisions=1,name=b",
                            "transform:node=a,position=3/0/0,rotation=20/30/40,scale=2/2/2", "transform:node=b,position=0/5/0,scale=1/1/-3"});
    const double areaA = surfaceArea(meshOf(d, "a")), volumeA = enclosedVolume(meshOf(d, "a")), volumeB = enclosedVolume(meshOf(d, "b"));
    const size_t faces = meshOf(d, "a").faceCount() + meshOf(d, "b").faceCount();
    commitEdit(d, parsedEdit("join:nodes=b+a"));
    ASSERT_EQ(d.scene().nodes().size(), 1u);
    EXPECT_EQ(d.undoName(), "a: join 2 meshes");
    EXPECT_EQ(meshOf(d, "a").faceCount(), faces);
    EXPECT_EQ(meshOf(d, "a").topology().components, 2u);
    // In a's space a is as it was; b's volume is 3 times its own in the world, and a's space is 8 times as fine. A mirrored part stays right side
    // out.
    EXPECT_NEAR(enclosedVolume(meshOf(d, "a")), volumeA + volumeB * 3 / 8, 1e-4);
    const Mesh joined = meshOf(d, "a");
    commitEdit(d, parsedEdit("separate:node=a,by=components"));
    ASSERT_EQ(d.scene().nodes().size(), 2u);
    EXPECT_EQ(d.selection().nodes.size(), 2u);
    EXPECT_NEAR(surfaceArea(meshOf(d, "a")), areaA, 1e-4);
    EXPECT_NEAR(enclosedVolume(meshOf(d, "a 2")), volumeB * 3 / 8, 1e-4);
    commitEdit(d, parsedEdit("join:nodes=a 2+a"));
    EXPECT_EQ(contentHash(meshOf(d, "a")), contentHash(joined)) << "apart and together again is the same";
    d.goTo(4);
    EXPECT_EQ(d.scene().nodes().size(), 2u);
}

TEST(EditMesh, SeparatedFacesAndTheRestMakeTheWhole)
{
    Document d = withEdits({"add:op=icosphere,with=subdivisions=3,name=ball"});
    const double area = surfaceArea(meshOf(d, "ball"));
    commitEdit(d, parsedEdit("separate:node=ball,faces=0-99;105"));
    EXPECT_EQ(d.undoName(), "ball: separate 101 faces");
    EXPECT_EQ(meshOf(d, "ball 2").faceCount(), 101u);
    EXPECT_EQ(meshOf(d, "ball").faceCount(), 1280u - 101);
    EXPECT_NEAR(surfaceArea(meshOf(d, "ball")) + surfaceArea(meshOf(d, "ball 2")), area, 1e-5);
    EXPECT_TRUE(meshOf(d, "ball 2").topology().isolatedVertices.empty());
    EXPECT_TRUE(meshOf(d, "ball").topology().isolatedVertices.empty());
    EXPECT_EQ(refusal(d, "separate:node=ball"), "no faces are named; select some");
    EXPECT_NE(refusal(d, "separate:node=ball,faces=1179").find("1179"), std::string::npos);
    EXPECT_EQ(refusal(d, "separate:node=ball 2,faces=0-100"), "these are all its faces: nothing would be left");
    EXPECT_EQ(refusal(d, "separate:node=ball,by=materials"), "it has one material only");
    commitEdit(d, parsedEdit("new-material:node=ball,name=red,color=1/0/0,faces=0-9"));
    commitEdit(d, parsedEdit("separate:node=ball,by=materials"));
    EXPECT_EQ(meshOf(d, "ball").faceCount() + meshOf(d, "ball 3").faceCount(), 1179u);
    const Node& part = d.scene().node(nodeOf(d.scene(), "ball 3"));
    EXPECT_EQ(meshOf(d, "ball 3").faceCount(), 1169u) << "parts in order of their first face";
    EXPECT_EQ(d.scene().find(part.mesh)->materials.size(), 1u);
}

TEST(EditMesh, DeletedElementsTakeWithThemWhatHangsOnThem)
{
    const auto counts = [](const char* text) {
        Document d = withEdits({"add:op=icosphere,with=subdivisions=2,name=ball", text});
        const TopologyReport& t = meshOf(d, "ball").topology();
        EXPECT_TRUE(t.isolatedVertices.empty());
        return std::array{t.vertices, t.edges, t.faces, t.boundaryLoops.size()};
    };
    // 162 vertices, 480 edges, 320 triangles; vertex 0 has valence 5.
    EXPECT_EQ(counts("delete-elements:node=ball,elements=7"), (std::array<size_t, 4>{162, 480, 319, 1}));
    EXPECT_EQ(counts("delete-elements:node=ball,kind=vertices,elements=0"), (std::array<size_t, 4>{161, 475, 315, 1}));
    Document d = withEdits({"add:op=icosphere,with=subdivisions=2,name=ball"});
    const auto edges = meshOf(d, "ball").edges();
    const std::string edge = std::to_string(edges[0]) + "~" + std::to_string(edges[1]);
    EXPECT_EQ(counts(("delete-elements:node=ball,kind=edges,elements=" + edge).c_str()), (std::array<size_t, 4>{162, 479, 318, 1}));
    commitEdit(d, parsedEdit("modify:node=ball,op=smooth"));
    EXPECT_EQ(refusal(d, "delete-elements:node=ball,elements=7"), "\"ball\" has modifiers; apply its stack first");
    commitEdit(d, parsedEdit("apply-modifiers:node=ball"));
    commitEdit(d, parsedEdit("delete-elements:node=ball,elements=0-319"));
    EXPECT_EQ(meshOf(d, "ball").vertexCount(), 0u);
}

TEST(EditMesh, CopiesAreOwnOrLinked)
{
    Document d = withEdits({"add:op=icosphere,name=ball", "duplicate:nodes=ball", "duplicate:nodes=ball,linked=true"});
    const Scene& s = d.scene();
    const auto mesh = [&](const char* name) { return d.scene().node(nodeOf(d.scene(), name)).mesh; };
    EXPECT_NE(mesh("ball"), mesh("ball 2"));
    EXPECT_EQ(mesh("ball"), mesh("ball 3"));
    EXPECT_EQ(s.find(mesh("ball"))->base.positions().id(), s.find(mesh("ball 2"))->base.positions().id()) << "copies cost nothing";
    commitEdit(d, parsedEdit("own-copy:nodes=ball 3"));
    EXPECT_NE(mesh("ball"), mesh("ball 3"));
    EXPECT_EQ(d.scene().users(mesh("ball")), 1u);
}

TEST(EditMesh, NodesStayInPlaceWhenTheyMoveInTheTree)
{
    Document d = withEdits({"add:op=icosphere,name=a", "add:op=icosphere,name=b", "transform:node=a,position=1/2/3,rotation=10/20/30,scale=2/2/2",
                            "transform:node=b,position=-4/0/1,rotation=0/0/90"});
    const auto world = [&](const char* name) { return d.scene().worldFromLocal(nodeOf(d.scene(), name)) * glm::dvec4(0.3, 0.2, -0.7, 1); };
    const glm::dvec4 b = world("b");
    commitEdit(d, parsedEdit("reparent:nodes=b,to=a"));
    EXPECT_EQ(d.undoName(), "b: below a");
    EXPECT_LT(glm::distance(world("b"), b), 1e-12);
    EXPECT_NE(refusal(d, "reparent:nodes=a,to=b").find("below itself"), std::string::npos);
    commitEdit(d, parsedEdit("group:nodes=b,name=Set"));
    EXPECT_LT(glm::distance(world("b"), b), 1e-12);
    EXPECT_EQ(d.scene().node(nodeOf(d.scene(), "Set")).parent, nodeOf(d.scene(), "a"));
    commitEdit(d, parsedEdit("reparent:nodes=Set,keep=false"));
    EXPECT_GT(glm::distance(world("b"), b), 0.1);
    commitEdit(d, parsedEdit("delete:nodes=Set"));
    EXPECT_EQ(d.scene().nodes().size(), 1u);
}

TEST(EditMesh, JointsOfAMeshThatStaysAreKept)
{
    Document d = withEdits({"import:file=sample:mannequin"});
    const Scene& s = d.scene();
    std::string joints, body;
    for (const NodeId n : s.nodes()) {
        if (s.node(n).joint == Node::Joint::Joint && joints.empty()) joints = nodeText(s, n);
        if (s.node(n).skin) body = nodeText(s, n);
    }
    EXPECT_NE(refusal(d, ("delete:nodes=" + joints).c_str()).find("is a joint that moves"), std::string::npos);
    EXPECT_NE(refusal(d, ("join:nodes=" + body).c_str()).find("two or more"), std::string::npos);
    commitEdit(d, parsedEdit("add:name=ball"));
    EXPECT_NE(refusal(d, ("join:nodes=ball+" + body).c_str()).find("bound to a skeleton"), std::string::npos);
    // A copied character has a skeleton of its own, which the clips move, too.
    const size_t channels = d.scene().find(d.scene().clips()[0])->channels.size();
    std::string tops;
    for (const NodeId n : d.scene().roots()) tops += (tops.empty() ? "" : "+") + nodeText(d.scene(), n);
    commitEdit(d, {"duplicate", {{"nodes", tops}}});
    EXPECT_EQ(d.scene().skins().size(), 2u);
    EXPECT_NE(d.scene().find(d.scene().skins()[0])->joints[0], d.scene().find(d.scene().skins()[1])->joints[0]);
    EXPECT_EQ(d.scene().find(d.scene().clips()[0])->channels.size(), 2 * channels);
}

TEST(EditTerrain, AStrokeGivesWhatTheBrushGives)
{
    Document d = withEdits({"new-terrain:with=size=129", "stroke:node=Terrain,radius=60,strength=0.8,points=-100/20;35.5/20;80/-60.25"});
    const auto terrain = [&] { return d.scene().find(d.scene().terrains()[0])->terrain; };
    const Terrain painted = terrain();
    EXPECT_EQ(d.undoName(), "Terrain: raise");
    d.undo();
    Brush brush{Brush::Kind::Raise, 60, 0.8};
    double carry = -1;
    const std::vector<glm::dvec2> way{{-100, 20}, {35.5, 20}, {80, -60.25}};
    EXPECT_EQ(contentHash(stroked(terrain(), brush, way, carry)), contentHash(painted.map));
    commitEdit(d, parsedEdit("set-terrain:node=Terrain,with=waterLevel=40"));
    EXPECT_EQ(d.undoName(), "Terrain: water level 40 m");
    EXPECT_EQ(terrain().maximumHeight, 180);
    for (const char* wrong : {"stroke:node=Terrain", "stroke:node=Terrain,points=1", "stroke:node=Terrain,points=1/2;nan/3",
                              "stroke:node=Terrain,points=1/2;1e300/3", "stroke:node=Terrain,radius=0.001,points=-400/0;400/0"}) {
        EXPECT_NE(refusal(d, wrong), "accepted") << wrong;
    }
}

TEST(Edit, EntriesAreNamedObjectFirst)
{
    Document d = withEdits({"add:name=ball", "modify:node=ball,op=decimate-quadric,with=\"stop=faces,faces=20000\""});
    EXPECT_EQ(d.undoName(), "ball: add Simplify by quadrics");
    commitEdit(d, parsedEdit("set-modifier:node=ball,with=\"stop=faces,faces=12345\""));
    EXPECT_EQ(d.undoName(), "Simplify by quadrics: faces 12,345");
    commitEdit(d, parsedEdit("enable-modifier:node=ball,enabled=false"));
    EXPECT_EQ(d.undoName(), "Simplify by quadrics: off");
    commitEdit(d, parsedEdit("delete:nodes=ball"));
    EXPECT_EQ(d.undoName(), "ball: delete");
}

TEST(Document, HistoryIsBoundedAndItsCallsStay)
{
    Document d = withEdits({"add:op=icosphere,with=subdivisions=5,name=ball"});
    const size_t one = d.scene().bytes();
    d.boundHistory(one);  // each application makes positions anew, about a quarter of it
    for (int i = 0; i < 10; ++i) {
        commitEdit(d, {"modify", {{"node", std::string("ball")}, {"op", std::string("smooth")}}});
        commitEdit(d, parsedEdit("apply-modifiers:node=ball"));
    }
    const size_t entries = d.history().size();
    EXPECT_LE(entries, 12u);
    EXPECT_EQ(entries + d.forgotten().size(), 22u);
    for (const auto& e : d.forgotten()) EXPECT_FALSE(e.scene);
    ASSERT_GT(d.forgotten().size(), 1u);
    EXPECT_EQ(d.forgotten()[1].calls.size(), 1u);
    while (d.canUndo()) d.undo();
    EXPECT_FALSE(d.scene().meshes().empty());
}

}  // namespace
}  // namespace mw
