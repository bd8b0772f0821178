// Everything a scene shows as one mesh in world space.
#include <glm/gtc/constants.hpp>

#include "core/mesh/topology.h"

#include "helpers.h"

namespace mw::test {
namespace {

Mesh tetrahedron()
{
    Mesh m = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Array<uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    Array<float> normals, numbers;
    for (size_t c = 0; c < m.cornerCount(); ++c) {
        for (int k = 0; k < 3; ++k) normals.push_back(m.faceNormals()[c / 3][k]);
        numbers.push_back(float(c));
    }
    return m.with(floatAttribute("normal", Domain::Corner, 3, normals)).with(floatAttribute("crease", Domain::Corner, 1, numbers));
}

NodeId add(Scene& scene, MeshId mesh, const Transform& t, NodeId parent = {}, const char* name = "node")
{
    Node n;
    n.name = name;
    n.mesh = mesh;
    n.local = t;
    return scene.add(std::move(n), parent);
}

TEST(Flatten, OneNodeWithoutTransformSharesItsArrays)
{
    const Mesh m = tetrahedron();
    const Mesh f = flattened(sceneOf(m, "t")).mesh;
    EXPECT_EQ(f.positions().id(), m.positions().id());
    EXPECT_EQ(contentHash(f), contentHash(m));
}

TEST(Flatten, MirrorsTurnFacesRoundAndNormalsStayOutside)
{
    Scene scene;
    Transform t;
    t.scale = {-2, 1, 3};
    t.rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    add(scene, scene.add(MeshObject{"t", tetrahedron(), {}, {}}), t);
    const Mesh f = flattened(scene).mesh;
    ASSERT_TRUE(checkMesh(f));
    EXPECT_NEAR(enclosedVolume(f), 1.0, 1e-6);  // 1/6 times 6, still positive
    const Attribute &normal = *f.find("normal"), &crease = *f.find("crease");
    for (size_t c = 0; c < f.cornerCount(); ++c)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(normal.at(c, k), f.faceNormals()[c / 3][k], 1e-6);
    // The edge from corner c to the next keeps its value, whichever way it is run along.
    const Mesh m = tetrahedron();
    for (size_t face = 0; face < 4; ++face)
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                const uint32_t a = f.face(face)[i], b = f.face(face)[(i + 1) % 3], p = m.face(face)[j], q = m.face(face)[(j + 1) % 3];
                if (a == q && b == p) {
                    EXPECT_EQ(crease.at(3 * face + i, 0), double(3 * face + j));
                }
            }
}

TEST(Flatten, JoinsAttributesMaterialsAndGroups)
{
    Scene scene;
    Material red, blue;
    red.name = "red";
    blue.name = "blue";
    const MaterialId r = scene.add(red), b = scene.add(blue);
    Mesh triangle = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Array<uint32_t>{0, 1, 2});
    triangle = triangle.with(floatAttribute("color", Domain::Vertex, 3, Array<float>{0, 0, 0, 0, 0, 0, 0, 0, 0}));
    const MeshId one = scene.add(MeshObject{"t", tetrahedron(), {r}, {}}), two = scene.add(MeshObject{"s", triangle, {b}, {}});
    Transform up;
    up.translation = {0, 0, 10};
    const NodeId parent = add(scene, {}, up, {}, "parent");
    add(scene, one, {}, {}, "first");
    add(scene, two, up, parent, "second");
    Node hidden;
    hidden.mesh = one;
    hidden.visible = false;
    const NodeId h = scene.add(hidden);
    add(scene, one, {}, h, "below a hidden one");
    const Flattened f = flattened(scene);
    ASSERT_TRUE(checkMesh(f.mesh));
    EXPECT_EQ(f.mesh.vertexCount(), 7u);
    EXPECT_EQ(f.mesh.faceCount(), 5u);
    EXPECT_EQ(f.mesh.bounds().max.z, 20);
    ASSERT_EQ(f.materials.size(), 2u);
    const Mesh& m = f.mesh;
    const auto material = [&](size_t face) { return f.materials[size_t(m.find("material")->integers()[face])]; };
    const auto group = [&](size_t face) { return m.groupNames()[size_t(m.find("group")->integers()[face])]; };
    for (size_t face = 0; face < 5; ++face) {
        const bool second = m.positions()[m.face(face)[0]].z > 9;
        EXPECT_EQ(material(face), second ? b : r);
        EXPECT_EQ(group(face), second ? "second" : "first");
        EXPECT_EQ(m.find("color")->at(m.face(face)[0], 0), second ? 0 : 1);
        if (second) {
            EXPECT_EQ(m.find("normal", Domain::Corner)->at(3 * face, 2), 1);  // made up from the faces
        }
    }
}

TEST(Flatten, WritersWriteTheEvaluatedScene)
{
    Scene scene;
    MeshObject o{"t", tetrahedron(), {}, {}};
    Transform t;
    t.translation = {5, 0, 0};
    add(scene, scene.add(std::move(o)), t);
    const Folder folder;
    for (const char* name : {"a.obj", "a.ply"}) {
        writeFile(scene, folder.path / name);
        EXPECT_EQ(meshOf(readFile(folder.path / name)).bounds().min.x, 5);
    }
}

TEST(Flatten, TerrainsAreWrittenAsMeshesInEveryFormat)
{
    Scene scene;
    TerrainObject o;
    o.terrain.name = "island";
    const float heights[] = {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0.5f, 0};
    o.terrain.map = HeightMap(3, 4, heights);
    o.terrain.extent = 20;
    o.terrain.maximumHeight = 7;
    const TerrainId terrain = scene.add(std::move(o));
    for (double x : {0.0, 100.0}) {
        Node n;
        n.name = "land";
        n.terrain = terrain;
        n.local.translation = {x, 0, 0};
        scene.add(std::move(n));
    }
    const Folder folder;
    for (const char* name : {"a.obj", "a.ply", "a.glb", "a.gltf"}) {
        writeFile(scene, folder.path / name);
        const Mesh all = flattened(readFile(folder.path / name).scene).mesh;
        EXPECT_EQ(all.faceCount(), 2u * 12) << name;
        EXPECT_EQ(all.bounds().min, glm::dvec3(-10, 0, -15)) << name;
        EXPECT_EQ(all.bounds().max, glm::dvec3(110, 7, 15)) << name;
        EXPECT_TRUE(all.find("color")) << name;
    }
    EXPECT_EQ(readFile(folder.path / "a.glb").scene.meshes().size(), 1u) << "two nodes share it";
    writeFile(scene, folder.path / "p.glb", {.project = true});
    const Imported back = readFile(folder.path / "p.glb");
    EXPECT_TRUE(back.project);
    EXPECT_EQ(contentHash(back.scene), contentHash(scene)) << "a project keeps the heights and knows no mesh of them";
    writeFile(scene, folder.path / "few.ply", {.terrainTriangles = 2});
    EXPECT_LE(flattened(readFile(folder.path / "few.ply").scene).mesh.faceCount(), 2u * 6);
}

}  // namespace
}  // namespace mw::test
