// What is written, as tinygltf (another program's reader) sees it, and as our own reader gets it back.
#include <filesystem>
#include <fstream>
#include <map>
#include <tiny_gltf.h>

#include "core/io/gltf_container.h"
#include "core/mesh/topology.h"

#include "data.h"
#include "samples.h"

namespace mw {
namespace {

using nlohmann::json;
using test::onlyMesh;

tinygltf::Model loaded(const std::vector<uint8_t>& glb)
{
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(reader.LoadBinaryFromMemory(&model, &error, &warning, glb.data(), unsigned(glb.size()))) << error;
    EXPECT_EQ(error, "");
    EXPECT_EQ(warning, "");
    return model;
}

// The vectors of an accessor of floats.
std::vector<std::vector<float>> floatsOf(const tinygltf::Model& m, int accessor)
{
    const tinygltf::Accessor& a = m.accessors[size_t(accessor)];
    const tinygltf::BufferView& v = m.bufferViews[size_t(a.bufferView)];
    const size_t n = size_t(tinygltf::GetNumComponentsInType(uint32_t(a.type)));
    EXPECT_EQ(a.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
    std::vector<std::vector<float>> out(a.count, std::vector<float>(n));
    for (size_t i = 0; i < a.count; ++i)
        std::memcpy(out[i].data(), m.buffers[0].data.data() + v.byteOffset + a.byteOffset + i * size_t(a.ByteStride(v)), 4 * n);
    return out;
}

Imported again(const Scene& scene, std::vector<Warning>* warnings = nullptr)
{
    return readGltf(glbOf(scene, {}, warnings), {});
}

// Sorted (position, attribute) of every triangle corner: what is drawn, whatever the numbering.
std::multimap<std::vector<float>, int> drawn(const Mesh& m, const char* attribute)
{
    std::multimap<std::vector<float>, int> out;
    const auto& t = m.triangulation();
    const Attribute* a = m.find(attribute);
    for (size_t i = 0; i < t.vertices.size(); ++i) {
        const glm::vec3 p = m.positions()[t.vertices[i]];
        std::vector<float> key{p.x, p.y, p.z};
        for (int k = 0; a && k < a->components; ++k) key.push_back(float(a->at(a->domain == Domain::Vertex ? t.vertices[i] : t.corners[i], k)));
        out.emplace(key, 0);
    }
    return out;
}

TEST(GltfWrite, CubeAsAnotherReaderSeesIt)
{
    const auto glb = glbOf(test::richScene());
    const tinygltf::Model m = loaded(glb);
    EXPECT_EQ(m.asset.generator, "Meshwright");
    ASSERT_EQ(m.meshes.size(), 1u);
    ASSERT_EQ(m.meshes[0].primitives.size(), 2u);
    size_t indices = 0;
    for (const auto& p : m.meshes[0].primitives) {
        indices += m.accessors[size_t(p.indices)].count;
        EXPECT_EQ(m.accessors[size_t(p.indices)].componentType, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        for (const auto& n : floatsOf(m, p.attributes.at("NORMAL"))) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
        EXPECT_TRUE(p.attributes.count("TEXCOORD_0") && p.attributes.count("COLOR_0"));
        // The v of ours is 0 or 0.75; that of the file grows downwards.
        for (const auto& uv : floatsOf(m, p.attributes.at("TEXCOORD_0"))) EXPECT_TRUE(uv[1] == 1 || uv[1] == 0.25f);
    }
    EXPECT_TRUE(m.meshes[0].primitives[0].attributes.count("TANGENT"));  // its material has a normal map
    EXPECT_EQ(indices, 36u);
    ASSERT_EQ(m.nodes.size(), 3u);
    EXPECT_EQ(m.nodes[0].mesh, m.nodes[1].mesh);
    EXPECT_EQ(m.nodes[2].mesh, -1);  // hidden
    ASSERT_EQ(m.images.size(), 1u);
    EXPECT_EQ(m.images[0].width, 1);
    EXPECT_EQ(m.materials[1].alphaMode, "BLEND");
}

TEST(GltfWrite, CornersComeBack)
{
    std::vector<Warning> warnings;
    const Imported in = again(test::sceneWith(test::cube()), &warnings);
    EXPECT_TRUE(test::warned(warnings, "lost-attributes"));  // crease and group
    EXPECT_TRUE(test::warned(warnings, "lost-groups"));
    const Mesh back = onlyMesh(in.scene).base, cube = test::cube();
    EXPECT_EQ(back.vertexCount(), 8u);
    EXPECT_EQ(back.faceCount(), 12u);
    EXPECT_EQ(back.topology().euler, 2);
    for (const char* a : {"texcoord", "color"}) EXPECT_EQ(drawn(back, a), drawn(cube, a)) << a;
}

// With one slot, vertices and triangles keep their numbers.
TEST(GltfWrite, NumberingComesBack)
{
    for (const int n : {1, 7, 300}) {  // 300: more than 65535 vertices
        const Mesh sheet = test::sheet(n);
        const Mesh back = onlyMesh(again(test::sceneWith(sheet)).scene).base;
        ASSERT_EQ(back.vertexCount(), sheet.vertexCount());
        ASSERT_EQ(back.faceCount(), sheet.faceCount());
        EXPECT_TRUE(std::equal(sheet.positions().begin(), sheet.positions().end(), back.positions().begin()));
        EXPECT_TRUE(std::equal(sheet.cornerVertex().begin(), sheet.cornerVertex().end(), back.cornerVertex().begin()));
        const auto uv = sheet.find("texcoord")->floats(), uvBack = back.find("texcoord")->floats();
        for (size_t i = 0; i < uv.size(); ++i) ASSERT_NEAR(uv[i], uvBack[i], 1e-7);
    }
}

TEST(GltfWrite, ColoursOfBytesStayBytes)
{
    Mesh m = test::sheet(1).without("texcoord");
    Array<float> c;
    for (int i = 0; i < 12; ++i) c.push_back(float(i * 20) / 255);
    Attribute color = floatAttribute("color", Domain::Vertex, 3, c);
    color.stored = Scalar::UInt8;
    const Mesh back = onlyMesh(again(test::sceneWith(m.with(color))).scene).base;
    const Attribute* a = back.find("color", Domain::Corner);
    ASSERT_TRUE(a);
    EXPECT_EQ(a->stored, Scalar::UInt8);
    EXPECT_EQ(a->components, 3);
    EXPECT_EQ(drawn(back, "color"), drawn(m.with(color), "color"));
}

TEST(GltfWrite, MorphTargetsComeBack)
{
    Mesh m = test::sheet(2);
    Array<float> move(3 * m.vertexCount(), 0.25f);
    move[4] = -1;
    m = m.with(floatAttribute("morph:smile \xC3\xA9", Domain::Vertex, 3, move));
    const Mesh back = onlyMesh(again(test::sceneWith(m)).scene).base;
    const Attribute* a = back.find("morph:smile \xC3\xA9", Domain::Vertex);
    ASSERT_TRUE(a);
    EXPECT_TRUE(std::equal(move.begin(), move.end(), a->floats().begin(), a->floats().end()));
}

TEST(GltfWrite, ColoursOfMorphTargetsComeBack)
{
    for (const int k : {3, 4}) {
        Mesh m = test::sheet(2);
        const size_t n = m.vertexCount();
        m = m.with(floatAttribute("color", Domain::Vertex, k, Array<float>(size_t(k) * n, 0.25f)));
        m = m.with(floatAttribute("morph:red", Domain::Vertex, 3, Array<float>(3 * n, 1.f)));
        m = m.with(floatAttribute("morph-color:red", Domain::Vertex, k, Array<float>(size_t(k) * n, -0.125f)));
        const Mesh back = onlyMesh(again(test::sceneWith(m)).scene).base;
        const Attribute* a = back.find("morph-color:red");
        ASSERT_TRUE(a);
        EXPECT_EQ(a->components, k);
        for (size_t i = 0; i < a->size(); ++i) EXPECT_EQ(a->at(i, 0), -0.125);
        // Two targets of which one has colours: none is written, as programs expect the same of all.
        const Mesh two = m.with(floatAttribute("morph:other", Domain::Vertex, 3, Array<float>(3 * n, 1.f)));
        EXPECT_FALSE(onlyMesh(again(test::sceneWith(two)).scene).base.find("morph-color:red"));
    }
}

TEST(GltfWrite, LoosePointsAndLines)
{
    const Mesh m = test::sheet(1);
    Array<glm::vec3> p(m.positions().begin(), m.positions().end());
    p.insert(p.end(), {{5, 5, 5}, {6, 5, 5}, {7, 7, 7}});
    const Mesh mixed =
        Mesh(p, Array<uint32_t>(m.faceStart().begin(), m.faceStart().end()), Array<uint32_t>(m.cornerVertex().begin(), m.cornerVertex().end()))
            .withLines(Array<uint32_t>{4, 5});
    const Mesh back = onlyMesh(again(test::sceneWith(mixed)).scene).base;
    EXPECT_EQ(back.vertexCount(), 7u);
    EXPECT_EQ(back.faceCount(), 2u);
    ASSERT_EQ(back.lines().size(), 2u);
    EXPECT_EQ(back.positions()[back.lines()[0]], glm::vec3(5, 5, 5));
    EXPECT_EQ(back.topology().isolatedVertices.size(), 3u);
    // A cloud of points alone keeps colours on its vertices.
    const Mesh cloud =
        Mesh(Array<glm::vec3>{{0, 0, 0}, {0, 0, 0}}, {}, {}).with(floatAttribute("color", Domain::Vertex, 3, test::numbers({1, 0, 0, 0, 0.5f, 1})));
    const Mesh cloudBack = onlyMesh(again(test::sceneWith(cloud)).scene).base;
    EXPECT_EQ(cloudBack.vertexCount(), 2u);  // nothing is welded without faces
    ASSERT_TRUE(cloudBack.find("color", Domain::Vertex));
    EXPECT_EQ(cloudBack.find("color")->floats()[4], 0.5f);
}

TEST(GltfWrite, FurtherSetsAndOwnAttributes)
{
    Mesh m = test::sheet(1);
    m = m.with(floatAttribute("texcoord2", Domain::Corner, 2, Array<float>(12, 0.5f)));  // leaves a gap at 1
    m = m.with(floatAttribute("heat", Domain::Vertex, 1, test::numbers({1, 2, 3, 4})))
            .with(integerAttribute("ring-2", Domain::Corner, 2, Array<int32_t>(12, 9)));
    const Mesh back = onlyMesh(again(test::sceneWith(m)).scene).base;
    ASSERT_TRUE(back.find("texcoord2", Domain::Corner));
    EXPECT_EQ(back.find("texcoord2")->floats()[0], 0.5f);
    ASSERT_TRUE(back.find("_HEAT"));
    EXPECT_EQ(drawn(back, "_HEAT"), drawn(m, "heat"));
    EXPECT_TRUE(back.find("_RING_2"));
}

TEST(GltfWrite, MaterialsComeBack)
{
    const Scene s = test::richScene();
    const Imported in = again(s);
    ASSERT_EQ(in.scene.materials().size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        const Material &a = *s.find(s.materials()[i]), &b = *in.scene.find(in.scene.materials()[i]);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.baseColor, b.baseColor);
        EXPECT_NEAR(glm::length(a.emissive - b.emissive), 0, 1e-12);
        EXPECT_EQ(a.doubleSided, b.doubleSided);
        EXPECT_EQ(a.alpha, b.alpha);
        EXPECT_EQ(a.baseColorTexture.repeat, b.baseColorTexture.repeat);
        EXPECT_EQ(a.extras, b.extras);
    }
    EXPECT_EQ(*in.scene.find(in.scene.images()[0])->bytes, *test::pixel());
}

TEST(GltfWrite, NothingAtAll)
{
    EXPECT_TRUE(again(Scene()).scene.nodes().empty());
    Scene s = test::sceneWith(Mesh());
    EXPECT_EQ(again(s).scene.nodes().size(), 1u);
    EXPECT_TRUE(again(s).scene.meshes().empty());
    Mesh degenerate(Array<glm::vec3>{{0, 0, 0}, {0, 0, 0}}, Array<uint32_t>{0, 2, 5}, Array<uint32_t>{0, 1, 0, 0, 1});
    EXPECT_NO_THROW(again(test::sceneWith(degenerate)));
}

TEST(GltfWrite, TextFileWithItsBinBeside)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mw_gltf_write";
    std::filesystem::create_directories(folder);
    const Scene s = test::richScene();
    writeGltf(s, folder / "a b.gltf");
    writeGltf(s, folder / "a.glb");
    EXPECT_TRUE(std::filesystem::exists(folder / "a b.bin"));
    const Imported text = readGltf(folder / "a b.gltf"), binary = readGltf(folder / "a.glb");
    EXPECT_EQ(contentHash(text.scene), contentHash(binary.scene));
    EXPECT_EQ(text.format, "glTF 2.0");
    EXPECT_EQ(binary.format, "glTF 2.0 (binary)");
    EXPECT_THROW(writeGltf(s, folder / "no" / "such" / "folder.glb"), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);  // nothing temporary is left
    std::filesystem::remove_all(folder);
}

// Every real file, written again, means the same to us: counts, and where each corner lies.
TEST(GltfWrite, RealFilesComeBack)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* file : {"gltf/BoxTextured.glb", "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf",
                             "gltf/MorphPrimitivesTest/MorphPrimitivesTest.gltf", "characters/cesium_man.gltf", "characters/robot.glb"}) {
        const Imported first = readGltf(data / file);
        const Imported second = again(first.scene);
        ASSERT_EQ(second.scene.meshes().size(), first.scene.meshes().size());
        EXPECT_EQ(second.scene.nodes().size(), first.scene.nodes().size());
        for (size_t i = 0; i < first.scene.meshes().size(); ++i) {
            const Mesh &a = first.scene.find(first.scene.meshes()[i])->base, &b = second.scene.find(second.scene.meshes()[i])->base;
            EXPECT_EQ(a.faceCount(), b.faceCount()) << file;
            EXPECT_EQ(drawn(a, ""), drawn(b, "")) << file;
        }
    }
}

}  // namespace
}  // namespace mw
