// Posing on the graphics card against posing on the CPU; what is sent for it; bones, their colours, and picking what is posed.
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "core/io/io.h"
#include "render/bones.h"
#include "render/draw_context.h"

#include "data.h"
#include "shapes.h"

namespace mw {
namespace {

using namespace test;

constexpr glm::ivec2 size{160, 120};

/// A tube along Y from 0 to 4 of quads, its rings weighted between joints at heights 0 to 4 (five slots a vertex, so that lists are no multiple
/// of four), with hard normals at corners, texture coordinates, and two morph targets of which one turns the normals.
Mesh tube()
{
    constexpr uint32_t sides = 8, rings = 17;
    constexpr int joints = 5;
    Array<glm::vec3> p;
    Array<int32_t> slots;
    Array<float> weights, bulge, lean;
    for (uint32_t r = 0; r < rings; ++r) {
        for (uint32_t s = 0; s < sides; ++s) {
            const float a = 2 * std::numbers::pi_v<float> * float(s) / sides, y = 0.25f * float(r);
            p.emplace_back(std::cos(a), y, std::sin(a));
            float sum = 0, w[joints];
            for (int j = 0; j < joints; ++j) sum += w[j] = std::max(0.f, 1.5f - std::abs(y - float(j)));
            for (int j = 0; j < joints; ++j) {
                slots.push_back(j);
                weights.push_back(w[j] / sum);
            }
            bulge.insert(bulge.end(), {0.5f * std::cos(a), 0, 0.5f * std::sin(a)});
            lean.insert(lean.end(), {0.3f * y, 0, 0});
        }
    }
    Array<uint32_t> start{0u}, corners;
    Array<float> normals, uv, turned;
    for (uint32_t r = 0; r + 1 < rings; ++r) {
        for (uint32_t s = 0; s < sides; ++s) {
            const uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides;
            corners.insert(corners.end(), {a, a + sides, b + sides, b});
            start.push_back(uint32_t(corners.size()));
            const float middle = 2 * std::numbers::pi_v<float> * (float(s) + 0.5f) / sides;
            for (int k = 0; k < 4; ++k) {
                normals.insert(normals.end(), {std::cos(middle), 0, std::sin(middle)});
                uv.insert(uv.end(), {float(s) / sides, float(r) / rings});
                turned.insert(turned.end(), {0, 0.1f * float(s), 0});
            }
        }
    }
    return Mesh(std::move(p), std::move(start), std::move(corners))
        .with(integerAttribute("joints", Domain::Vertex, joints, std::move(slots)))
        .with(floatAttribute("weights", Domain::Vertex, joints, std::move(weights)))
        .with(floatAttribute("normal", Domain::Corner, 3, std::move(normals)))
        .with(floatAttribute("texcoord", Domain::Corner, 2, std::move(uv)))
        .with(floatAttribute("morph:bulge", Domain::Vertex, 3, std::move(bulge)))
        .with(floatAttribute("morph:lean", Domain::Vertex, 3, std::move(lean)))
        .with(floatAttribute("morph-normal:lean", Domain::Corner, 3, std::move(turned)));
}

/// Each joint bends by `degrees` more than the one below it, about Z; the last one is scaled, too.
MeshPose bent(double degrees, std::vector<float> morphWeights = {})
{
    MeshPose pose;
    glm::dmat4 world(1);
    for (int j = 0; j < 5; ++j) {
        const glm::dmat4 inverseBind = glm::translate(glm::dmat4(1), glm::dvec3(0, -j, 0));
        if (j) world = glm::translate(world, glm::dvec3(0, 1, 0));
        world = glm::rotate(world, glm::radians(degrees), glm::dvec3(0, 0, 1));
        const glm::dmat4 scaled = j == 4 ? glm::scale(world, glm::dvec3(1, 2, 0.5)) : world;
        pose.joints.push_back(glm::mat4(scaled * inverseBind));
    }
    pose.morphWeights = std::move(morphWeights);
    return pose;
}

std::vector<glm::vec3> content(GLuint buffer, size_t n)
{
    std::vector<glm::vec3> out(n);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, GLsizeiptr(n * sizeof(glm::vec3)), out.data());
    return out;
}

/// Without a window there is no framebuffer, and nothing is drawn, until a picture was.
void bindSomeFramebuffer(Offscreen& context)
{
    context.draw(frameWith(sphere(0)), 8, 8);
}

/// Every drawn vertex is where, and has the normal that, posed() says.
void expectAsOnTheCpu(DrawObject o, int texcoordSet)
{
    GpuState gpu;
    Frame frame;
    frame.objects = {o};
    DrawContext c(gpu, frame, size);
    glBindVertexArray(gpu.vertexArray.id());
    SurfaceWants wants;
    wants.texcoordSets[0] = texcoordSet;
    const BoundSurface s = bindSurface(c, o, wants);
    const Mesh expected = posed(o.mesh, *o.pose);
    const std::vector<glm::vec3> at = content(s.buffers.positions, s.buffers.vertices), normals = content(s.buffers.normals, s.buffers.vertices);
    const double scale = expected.bounds().diagonal();
    const Attribute* normal = s.layout->normal ? expected.find("normal", s.layout->normal->domain) : nullptr;
    double farthest = 0, mostTurned = 0;
    for (size_t i = 0; i < at.size(); ++i) {
        const uint32_t v = s.layout->vertexOf.empty() ? uint32_t(i) : s.layout->vertexOf[i];
        farthest = std::max(farthest, double(glm::distance(at[i], expected.positions()[v])));
        if (!normal) continue;
        const size_t element = normal->domain == Domain::Corner ? s.layout->cornerOf[i] : v;
        const float* n = normal->floats().data() + 3 * element;
        mostTurned = std::max(mostTurned, double(glm::distance(normals[i], glm::vec3(n[0], n[1], n[2]))));
    }
    EXPECT_LE(farthest, 1e-5 * scale);
    EXPECT_LE(mostTurned, 2e-5);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    // What no split concerns: wires, ids and marks.
    const std::vector<glm::vec3> plain = content(c.positions(o), o.mesh.vertexCount());
    const Shared<glm::vec3> places = c.places(o);
    const Bounds bounds = worldBounds(o);
    for (size_t v = 0; v < plain.size(); ++v) {
        ASSERT_LE(glm::distance(plain[v], expected.positions()[v]), 1e-5 * scale);
        ASSERT_EQ(places[v], expected.positions()[v]);
        const glm::dvec3 world(o.worldFromLocal * glm::dvec4(glm::dvec3(places[v]), 1));
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(world[k], bounds.min[k] - 1e-5 * scale);
            ASSERT_LE(world[k], bounds.max[k] + 1e-5 * scale);
        }
    }
}

DrawObject objectOf(Mesh mesh, MeshPose pose)
{
    DrawObject o;
    o.node = NodeId{7};
    o.mesh = std::move(mesh);
    o.pose = std::make_shared<MeshPose>(std::move(pose));
    return o;
}

TEST(Pose, TubeAsOnTheCpu)
{
    Offscreen context(true);
    bindSomeFramebuffer(context);
    for (const double degrees : {0.0, 20.0, -75.0}) {
        for (const std::vector<float>& morphs : {std::vector<float>{}, {0.7f, 0.f}, {0.25f, -1.5f}}) {
            SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(morphs.size()) + " morphs");
            expectAsOnTheCpu(objectOf(tube(), bent(degrees, morphs)), 0);
            expectAsOnTheCpu(objectOf(tube().without("normal"), bent(degrees, morphs)), -1);
        }
    }
    MeshPose morphOnly;
    morphOnly.morphWeights = {1, 0.5f};
    expectAsOnTheCpu(objectOf(tube(), morphOnly), -1);
    EXPECT_EQ(context.messages(), std::vector<std::string>{});
}

TEST(Pose, OnlyMatricesAreSentFromFrameToFrame)
{
    Offscreen context(true);
    Frame f = frameWith(tube(), 12);
    f.options.wireOverlay = true;
    f.objects[0].selected = true;
    const auto bytes = [&](double degrees, std::vector<float> morphs) {
        f.objects[0].pose = std::make_shared<MeshPose>(bent(degrees, std::move(morphs)));
        context.draw(f, size.x, size.y);
        return context.renderer().counts().uploadedBytes;
    };
    const size_t first = bytes(0, {1, 0});
    EXPECT_GT(first, f.objects[0].mesh.vertexCount() * sizeof(glm::vec3));
    const size_t targets = 16, matrices = 5 * 48;
    // Twice: the surface has split vertices, the wires have not.
    EXPECT_EQ(bytes(10, {1, 0}), 2 * (targets + matrices));
    EXPECT_EQ(bytes(20, {}), 2 * matrices);
    EXPECT_EQ(bytes(20, {}), 0u);  // the same pose, though another object holds it
    f.camera.azimuth = 1;
    EXPECT_EQ(bytes(20, {}), 0u);
    EXPECT_EQ(context.messages(), std::vector<std::string>{});
}

TEST(Pose, PicksWhatIsWhereItWasMoved)
{
    Offscreen context;
    Frame f = frameWith(tube(), 14);
    f.camera.target = {0, 2, 0};
    MeshPose away;
    for (int i = 0; i < 5; ++i) away.joints.push_back(glm::translate(glm::mat4(1), glm::vec3(3, 0, 0)));
    f.objects[0].pose = std::make_shared<MeshPose>(away);
    const auto pixelOf = [&](glm::dvec3 world) {
        const glm::dvec3 p = f.camera.project(world, glm::dvec2(size));
        return glm::dvec2(p.x, p.y);
    };
    EXPECT_FALSE(context.renderer().pick(f, size, pixelOf({0, 2, 0})));
    const auto hit = context.renderer().pick(f, size, pixelOf({3, 2, 0.92}));
    ASSERT_TRUE(hit && hit->face != none);
    EXPECT_NEAR(hit->atWorld.x, 3, 0.1);
    EXPECT_NEAR(hit->atWorld.z, std::cos(std::numbers::pi / 8), 0.1);
    // Back again: the id buffer is drawn anew although mesh and camera are the same.
    f.objects[0].pose = nullptr;
    EXPECT_TRUE(context.renderer().pick(f, size, pixelOf({0, 2, 0})));
}

TEST(Pose, FilesAsOnTheCpu)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    Offscreen context(true);
    bindSomeFramebuffer(context);
    for (const char* file : {"characters/cesium_man.gltf", "characters/robot.glb", "characters/rigged_simple.gltf", "characters/simple_skin.gltf",
                             "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf", "gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf"}) {
        SCOPED_TRACE(file);
        const Imported in = readFile(data / file);
        ASSERT_FALSE(in.scene.clips().empty());
        const Clip& clip = *in.scene.find(in.scene.clips().back());
        for (const double part : {0.0, 0.31, 0.77}) {
            const ScenePose pose = poseAt(in.scene, clip, part * duration(clip));
            const Frame f = frameOf(
                in.scene, [&](MeshId id) { return in.scene.find(id)->base; }, pose);
            size_t posedObjects = 0;
            for (const DrawObject& o : f.objects) {
                if (!o.pose) continue;
                expectAsOnTheCpu(o, 0);
                ++posedObjects;
            }
            EXPECT_GE(posedObjects + (part == 0.0), 1u);  // morph weights may begin at 0
        }
    }
    EXPECT_EQ(context.messages(), std::vector<std::string>{});
}

TEST(Bones, DifferencesOfKnownPairs)
{
    EXPECT_NEAR(colorDifference({0, 0, 0}, {1, 1, 1}), 100, 0.01);
    EXPECT_NEAR(colorDifference({1, 0, 0}, {0, 1, 0}), 86.61, 0.05);
    EXPECT_NEAR(colorDifference({1, 0, 0}, {0, 0, 1}), 52.88, 0.05);
    EXPECT_EQ(colorDifference({0.3f, 0.5f, 0.1f}, {0.3f, 0.5f, 0.1f}), 0);
}

/// A hand: root, palm, four fingers of two joints each, each with an end site.
Scene hand(std::vector<NodeId>& joints)
{
    Scene s;
    const auto add = [&](glm::dvec3 at, NodeId parent, Node::Joint kind = Node::Joint::Joint) {
        Node n;
        n.local.translation = at;
        n.joint = kind;
        joints.push_back(s.add(n, parent));
        return joints.back();
    };
    const NodeId root = add({0, 0, 0}, {}), palm = add({0, 1, 0}, root);
    for (int i = 0; i < 4; ++i) add({0, 0.5, 0}, add({0, 0.5, 0}, add({0.4 * i - 0.6, 1, 0}, palm)), Node::Joint::EndSite);
    return s;
}

TEST(Bones, RelativesAreTold)
{
    std::vector<NodeId> joints;
    const Scene s = hand(joints);
    const auto colors = boneColors(s);
    ASSERT_EQ(colors.size(), joints.size());
    for (const NodeId id : joints) {
        const NodeId parent = s.node(id).parent;
        if (!parent) continue;
        std::set<NodeId> relatives{parent};
        if (s.node(parent).parent) relatives.insert(s.node(parent).parent);
        for (const NodeId sibling : s.node(parent).children)
            if (sibling != id) relatives.insert(sibling);
        for (const NodeId r : relatives) EXPECT_GE(colorDifference(colors.at(id), colors.at(r)), 25);
    }
}

TEST(Bones, FromJointToJoint)
{
    std::vector<NodeId> joints;
    Scene s = hand(joints);
    const auto noMesh = [](MeshId) { return Mesh(); };
    Frame f = frameOf(s, noMesh);
    EXPECT_EQ(f.bones.size(), 13u);  // one to each node but the root: end sites are ends, no stubs
    size_t ofPalm = 0;
    for (const DrawBone& b : f.bones) {
        if (b.node != joints[1]) continue;
        ++ofPalm;
        EXPECT_EQ(b.head, glm::vec3(0, 1, 0));
        EXPECT_EQ(b.tail.y, 2);
    }
    EXPECT_EQ(ofPalm, 4u);
    f.camera.azimuth = f.camera.elevation = 0;
    f.camera.target = {0, 1.5, 0};
    f.camera.distance = 8;
    const glm::dvec3 pixel = f.camera.project({0, 1, 0}, glm::dvec2(size));
    EXPECT_EQ(jointAt(f, size, {pixel.x + 3, pixel.y}), joints[1]);
    EXPECT_FALSE(jointAt(f, size, {2, 2}));
    ScenePose pose;
    pose.locals[joints[0]].translation = {10, 0, 0};
    const Bounds moved = boundsOf(frameOf(s, noMesh, pose));
    EXPECT_NEAR(moved.min.x, 9.4, 1e-6);
    EXPECT_NEAR(moved.max.y, 3, 1e-6);
    Node palm = s.node(joints[1]);
    palm.visible = false;
    s.set(joints[1], palm);
    EXPECT_EQ(frameOf(s, noMesh).bones.size(), 1u);  // the root alone, as a point
}

TEST(Bones, ShowThroughTheMesh)
{
    Offscreen context(true);
    Frame f = frameWith(sphere(3), 5);
    f.options.theme = Theme::Dark;
    f.bones.push_back({NodeId{9}, {0, -0.8f, 0}, {0, 0.8f, 0}, {0, 1, 0, 1}});
    const Picture p = context.draw(f, 200, 160);
    const glm::ivec4 inside = at(p, f.camera, {0, -0.4, 0});
    EXPECT_GT(inside.g, inside.r + 60);
    EXPECT_GT(inside.g, inside.b + 60);
    EXPECT_EQ(context.messages(), std::vector<std::string>{});
}

}  // namespace
}  // namespace mw
