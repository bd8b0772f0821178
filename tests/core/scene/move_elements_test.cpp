// Moving elements of a base mesh as an edit: where vertices go, what is shared, what is said of a wrong call.
#include "core/scene/move_elements.h"

#include <gtest/gtest.h>

#include "core/scene/edit.h"

namespace mw {
namespace {

Document icosphere()
{
    Scene s;
    MeshObject object;
    object.base = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(2)}}));
    Array<float> normals(3 * object.base.cornerCount(), 0.f);
    object.base = object.base.with(floatAttribute("normal", Domain::Corner, 3, std::move(normals)));
    const MeshId mesh = s.add(std::move(object));
    Node n;
    n.name = "ball";
    n.mesh = mesh;
    s.add(n);
    Document d;
    d.open(std::move(s), {}, "Open");
    return d;
}

const Mesh& base(const Document& d)
{
    return d.scene().find(d.scene().meshes().front())->base;
}

TEST(MoveElements, MovesTheseVerticesAndSharesTheFaces)
{
    Document d = icosphere();
    const Mesh before = base(d);
    d.select({{d.scene().nodes().front()}, d.scene().nodes().front(), {ElementKind::Face, {0, 5}}});
    const EditCall call = parsedEdit("move-elements:node=ball,kind=face,elements=0;5,x=2/0/0,by=0/1/0");
    commitEdit(d, call);
    const Mesh& after = base(d);
    EXPECT_EQ(after.cornerVertex().id(), before.cornerVertex().id());
    EXPECT_EQ(after.faceStart().id(), before.faceStart().id());
    EXPECT_EQ(after.find("normal"), nullptr);
    std::vector<uint8_t> in(before.vertexCount(), 0);
    for (const uint32_t f : {0u, 5u})
        for (const uint32_t v : before.face(f)) in[v] = 1;
    for (uint32_t v = 0; v < before.vertexCount(); ++v) {
        const glm::vec3 p = before.positions()[v];
        EXPECT_EQ(after.positions()[v], in[v] ? glm::vec3(2 * p.x, p.y + 1, p.z) : p) << v;
    }
    EXPECT_EQ(d.undoName(), "ball: move faces");
    EXPECT_EQ(d.selection().elements.indices, (std::vector<uint32_t>{0, 5}));  // they are still the same faces
    EXPECT_EQ(parsedEdit(commandText(call)), call);
    d.undo();
    EXPECT_EQ(base(d).positions().id(), before.positions().id());
}

TEST(MoveElements, EdgesAreTheirVertices)
{
    Document d = icosphere();
    EXPECT_EQ(verticesOf(base(d), {ElementKind::Edge, {3, 7, 3, 9}}), (std::vector<uint32_t>{3, 7, 9}));
    EXPECT_EQ(verticesOf(base(d), {ElementKind::Vertex, {9, 4, 4'000'000'000u}}), (std::vector<uint32_t>{4, 9}));
}

TEST(MoveElements, SaysWhatDoesNotFit)
{
    Document d = icosphere();
    const Scene scene = d.scene();
    const auto fails = [&](const char* text, const char* said) {
        try {
            edited(scene, parsedEdit(text));
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
        }
    };
    fails("move-elements:node=ball,elements=0-999999999", "999999999");
    fails("move-elements:node=cube,elements=0", "cube");
    fails("move-elements:node=ball,elements=0,by=1e300/0/0", "vertex 0");
    fails("move-elements:node=ball,elements=abc", "abc");
}

}  // namespace
}  // namespace mw
