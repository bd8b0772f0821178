// What glTF files mean to us: real files against the figures of their makers, and each rule on the smallest file that shows it.
#include <cstring>
#include <fstream>
#include <map>

#include "core/mesh/topology.h"

#include "data.h"
#include "samples.h"

namespace mw {
namespace {

using nlohmann::json;
using test::onlyMesh;
using test::triangleGlb;

Imported read(const std::vector<uint8_t>& glb)
{
    return readGltf(glb, {});
}

struct Known {
    const char* file;
    size_t meshes, faces, nodes, welded, targets;
    bool skin, texcoord;
};

// Faces and nodes as the data set states them; welded vertices counted once by hand where that is possible (cubes: 8).
class RealFiles : public testing::TestWithParam<Known> {};

TEST_P(RealFiles, AreReadWithTheirCounts)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Known& k = GetParam();
    const Imported in = readGltf(data / k.file);
    EXPECT_EQ(in.scene.meshes().size(), k.meshes);
    EXPECT_EQ(in.scene.nodes().size(), k.nodes);
    size_t faces = 0;
    for (const MeshId id : in.scene.meshes()) {
        const Mesh& m = in.scene.find(id)->base;
        faces += m.faceCount();
        EXPECT_TRUE(m.isTriangles());
        EXPECT_EQ(m.find("joints", Domain::Vertex) != nullptr, k.skin);
        EXPECT_EQ(m.find("texcoord", Domain::Corner) != nullptr, k.texcoord);
        size_t targets = 0;
        for (const Attribute& a : m.attributes()) targets += a.name.starts_with("morph:");
        EXPECT_EQ(targets, k.targets);
        if (k.welded) {
            EXPECT_EQ(m.vertexCount(), k.welded);
        }
    }
    EXPECT_EQ(faces, k.faces);
    EXPECT_EQ(!in.scene.skins().empty(), k.skin);
}

INSTANTIATE_TEST_SUITE_P(Data, RealFiles,
                         testing::Values(Known{"gltf/BoxTextured/BoxTextured.gltf", 1, 12, 2, 8, 0, false, true},
                                         Known{"gltf/BoxTextured.glb", 1, 12, 2, 8, 0, false, true},
                                         Known{"gltf/BoxTextured_embedded.gltf", 1, 12, 2, 8, 0, false, true},
                                         Known{"gltf/AnimatedMorphCube/AnimatedMorphCube.gltf", 1, 12, 1, 8, 2, false, false},
                                         Known{"gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf", 1, 960, 1, 0, 2, false, false},
                                         Known{"gltf/SimpleMorph/SimpleMorph.gltf", 1, 1, 1, 3, 2, false, false},
                                         Known{"gltf/MorphPrimitivesTest/MorphPrimitivesTest.gltf", 1, 32, 2, 0, 1, false, true},
                                         Known{"characters/cesium_man.gltf", 1, 4672, 22, 0, 0, true, true},
                                         Known{"characters/rigged_simple.gltf", 1, 188, 5, 0, 0, true, false},
                                         Known{"characters/simple_skin.gltf", 1, 8, 3, 10, 0, true, false},
                                         Known{"characters/robot.glb", 14, 3238, 58, 0, 0, true, false}));

TEST(GltfRead, BoxIsOneClosedSurfaceAfterWelding)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* file : {"gltf/BoxTextured/BoxTextured.gltf", "gltf/BoxTextured.glb", "gltf/BoxTextured_embedded.gltf"}) {
        const Imported in = readGltf(data / file);
        const MeshObject& o = onlyMesh(in.scene);
        EXPECT_EQ(o.base.topology().euler, 2);
        EXPECT_TRUE(o.base.topology().closed);
        ASSERT_EQ(o.materials.size(), 1u);
        const Material* m = in.scene.find(o.materials[0]);
        ASSERT_TRUE(m && m->baseColorTexture.image);
        EXPECT_EQ(in.scene.find(m->baseColorTexture.image)->mimeType, "image/png");
        EXPECT_EQ(m->name, "Texture");
        EXPECT_EQ(m->metallic, 0);
    }
}

// The mean of what a sphere encloses is known; its seams and poles are closed by welding.
TEST(GltfRead, MorphSphereIsClosed)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readGltf(data / "gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf");
    const Mesh& m = onlyMesh(in.scene).base;
    EXPECT_EQ(m.topology().euler, 2);
    EXPECT_EQ(m.topology().boundaryEdges, 0u);
    EXPECT_EQ(m.topology().components, 1u);
}

TEST(GltfRead, MorphTargetsHaveNamesAndNormals)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readGltf(data / "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf");
    const Mesh& m = onlyMesh(in.scene).base;
    EXPECT_NE(m.find("morph:target0", Domain::Vertex), nullptr);  // the file names none
    EXPECT_NE(m.find("morph:target1", Domain::Vertex), nullptr);
    EXPECT_NE(m.find("morph-normal:target1", Domain::Corner), nullptr);
}

TEST(GltfRead, WeightsSumToOne)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readGltf(data / "characters/robot.glb");
    for (const MeshId id : in.scene.meshes()) {
        const Attribute* w = in.scene.find(id)->base.find("weights");
        for (size_t v = 0; v < w->size(); ++v) {
            double sum = 0;
            for (int k = 0; k < w->components; ++k) sum += w->at(v, k);
            ASSERT_NEAR(sum, 1, 1e-3);
        }
    }
}

// Two triangles that share an edge by position only; the third differs in a joint and must stay apart.
TEST(GltfRead, WeldsWherePositionAndSkinAreEqual)
{
    const auto glb = triangleGlb([](json& j, std::vector<uint8_t>& bin) {
        const float p[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, -0.f, 0, 0, -1, 0};
        bin.assign(72 + 24 + 96, 0);
        std::memcpy(bin.data(), p, 72);
        bin[72 + 4 * 4] = 7;  // vertex 4 lies where 0 does, but on joint 7
        for (int v = 0; v < 6; ++v) {
            const float one = 1;
            std::memcpy(bin.data() + 96 + 16 * v, &one, 4);
        }
        j["buffers"][0]["byteLength"] = bin.size();
        j["bufferViews"] = {{{"buffer", 0}, {"byteLength", 72}},
                            {{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 24}},
                            {{"buffer", 0}, {"byteOffset", 96}, {"byteLength", 96}}};
        j["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 6}, {"type", "VEC3"}},
                          {{"bufferView", 1}, {"componentType", 5121}, {"count", 6}, {"type", "VEC4"}},
                          {{"bufferView", 2}, {"componentType", 5126}, {"count", 6}, {"type", "VEC4"}}};
        j["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}}};
    });
    const Imported in = read(glb);
    const Mesh& m = onlyMesh(in.scene).base;
    EXPECT_EQ(m.faceCount(), 2u);
    EXPECT_EQ(m.vertexCount(), 5u);  // 1 and 3 became one, 0 and 4 did not
    EXPECT_EQ(m.find("joints")->integers()[4 * 3], 7);
}

TEST(GltfRead, StripsAndFansTurnTheSameWay)
{
    for (const int mode : {5, 6}) {
        const auto glb = triangleGlb([&](json& j, std::vector<uint8_t>& bin) {
            // A strip goes zigzag, a fan goes round; both make the unit square, seen from +z.
            const float strip[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, fan[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
            bin.assign(48, 0);
            std::memcpy(bin.data(), mode == 5 ? strip : fan, 48);
            j["buffers"][0]["byteLength"] = 48;
            j["bufferViews"] = {{{"buffer", 0}, {"byteLength", 48}}};
            j["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}};
            j["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", mode}};
        });
        const Imported in = read(glb);
        const Mesh& m = onlyMesh(in.scene).base;
        ASSERT_EQ(m.faceCount(), 2u);
        for (size_t f = 0; f < 2; ++f) EXPECT_FLOAT_EQ(m.faceNormals()[f].z, 1);
        EXPECT_DOUBLE_EQ(surfaceArea(m), 1);
    }
}

TEST(GltfRead, PointsAndLines)
{
    for (const int mode : {0, 1, 2, 3}) {
        const Imported in = read(triangleGlb([&](json& j, auto&) { j["meshes"][0]["primitives"][0]["mode"] = mode; }));
        const Mesh& m = onlyMesh(in.scene).base;
        EXPECT_EQ(m.faceCount(), 0u);
        EXPECT_EQ(m.vertexCount(), 3u);
        EXPECT_EQ(m.lines().size(), size_t(mode == 0 ? 0 : mode == 1 ? 2 : mode == 2 ? 6 : 4));
    }
}

// KHR_mesh_quantization: positions as normalised shorts, read as numbers.
TEST(GltfRead, QuantizedPositions)
{
    const auto glb = triangleGlb([](json& j, std::vector<uint8_t>& bin) {
        const int16_t p[] = {-32768, 0, 0, 0, 32767, 0, 0, 0, 0, -32767, 0, 0};
        std::memcpy(bin.data(), p, sizeof p);
        j["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 24}, {"byteStride", 8}};
        j["accessors"][0]["componentType"] = 5122;
        j["accessors"][0]["normalized"] = true;
        j["extensionsUsed"] = j["extensionsRequired"] = {"KHR_mesh_quantization"};
    });
    const Imported in = read(glb);
    const Mesh& m = onlyMesh(in.scene).base;
    EXPECT_EQ(m.positions()[0], glm::vec3(-1, 0, 0));
    EXPECT_EQ(m.positions()[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(m.positions()[2], glm::vec3(0, -1, 0));
    EXPECT_TRUE(in.warnings.empty());
}

TEST(GltfRead, SparseAccessors)
{
    const auto glb = triangleGlb([](json& j, std::vector<uint8_t>& bin) {
        const float moved[] = {5, 6, 7};
        bin.resize(64, 0);
        std::memcpy(bin.data() + 44, moved, 12);
        bin[56] = 1;
        j["buffers"][0]["byteLength"] = 64;
        j["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 44}, {"byteLength", 12}});
        j["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 56}, {"byteLength", 1}});
        j["accessors"][0]["sparse"] = {{"count", 1}, {"indices", {{"bufferView", 3}, {"componentType", 5121}}}, {"values", {{"bufferView", 2}}}};
    });
    const Imported in = read(glb);
    EXPECT_EQ(onlyMesh(in.scene).base.positions()[1], glm::vec3(5, 6, 7));
    EXPECT_EQ(onlyMesh(in.scene).base.positions()[2], glm::vec3(0, 1, 0));
}

TEST(GltfRead, NodesShareAMeshAndKeepExtras)
{
    const Imported in = read(triangleGlb([](json& j, auto&) {
        j["nodes"] = {{{"mesh", 0}, {"children", {1}}, {"name", "a"}}, {{"mesh", 0}, {"translation", {1, 2, 3}}, {"extras", {{"k", 1}}}}};
    }));
    EXPECT_EQ(in.scene.meshes().size(), 1u);
    ASSERT_EQ(in.scene.nodes().size(), 2u);
    const Node& child = in.scene.node(in.scene.nodes()[1]);
    EXPECT_EQ(child.extras, "{\"k\":1}");
    EXPECT_EQ(child.local.translation, glm::dvec3(1, 2, 3));
    EXPECT_EQ(child.parent, in.scene.nodes()[0]);
    EXPECT_EQ(in.scene.users(child.mesh), 2u);
}

TEST(GltfRead, MatrixBecomesTransform)
{
    const Imported in = read(triangleGlb([](json& j, auto&) { j["nodes"][0]["matrix"] = {0, 0, -2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 5, 6, 7, 1}; }));
    const glm::dvec4 p = in.scene.worldFromLocal(in.scene.roots()[0]) * glm::dvec4(1, 1, 1, 1);
    EXPECT_NEAR(glm::length(p - glm::dvec4(9, 9, 5, 1)), 0, 1e-12);
}

TEST(GltfRead, OddNumbersAreMendedAndTold)
{
    const Imported in = read(triangleGlb([](json& j, std::vector<uint8_t>& bin) {
        const float nan = std::nanf("");
        std::memcpy(bin.data() + 4, &nan, 4);
        j["nodes"][0]["rotation"] = {0, 0, 0, 0};
    }));
    EXPECT_TRUE(test::warned(in.warnings, "nan-position"));
    EXPECT_TRUE(test::warned(in.warnings, "bad-rotation"));
    EXPECT_EQ(onlyMesh(in.scene).base.positions()[0], glm::vec3(0));
}

TEST(GltfRead, UnusedVerticesAreToldSharedBuffersAreNot)
{
    const auto doubled = [](json& j) { j["meshes"][0]["primitives"].push_back(j["meshes"][0]["primitives"][0]); };
    const Imported shared = read(triangleGlb([&](json& j, auto&) { doubled(j); }));
    EXPECT_TRUE(shared.warnings.empty());
    EXPECT_EQ(onlyMesh(shared.scene).base.vertexCount(), 3u);
    const Imported unused = read(triangleGlb([&](json&, std::vector<uint8_t>& bin) { bin[40] = 0; }));
    EXPECT_TRUE(test::warned(unused.warnings, "unused-vertices"));
    EXPECT_EQ(onlyMesh(unused.scene).base.vertexCount(), 2u);
}

TEST(GltfRead, FilesOutsideTheFolderAreRefused)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mw_gltf_inside";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "in side.bin") << std::string(44, '\0');
    std::ofstream(folder.parent_path() / "mw_outside.bin") << std::string(44, '\0');
    std::error_code ignored;
    std::filesystem::create_symlink("../mw_outside.bin", folder / "link.bin", ignored);
    const auto with = [&](const std::string& uri) { return readGltf(triangleGlb([&](json& j, auto&) { j["buffers"][0]["uri"] = uri; }), folder); };
    EXPECT_NO_THROW(with("in%20side.bin"));
    EXPECT_NO_THROW(with("in side.bin"));
    for (const std::string uri : {"../mw_outside.bin", "%2e%2e/mw_outside.bin", "..%5Cmw_outside.bin", "/etc/passwd", "file:///etc/passwd",
                                  "http://x.org/a.bin", "link.bin", "", ".", "in%20side.bin%00.png", "data:text/plain,hello", "data:;base64,@@@@"})
        EXPECT_THROW(with(uri), Error) << uri;
    EXPECT_THROW(readGltf(triangleGlb([&](json& j, auto&) { j["buffers"][0]["uri"] = "in side.bin"; }), {}), Error);
    std::filesystem::remove_all(folder);
}

TEST(GltfRead, MissingPictureIsOnlyAWarning)
{
    const Imported in = read(triangleGlb([](json& j, auto&) {
        j["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
        j["textures"] = {{{"source", 0}}};
        j["images"] = {{{"uri", "no_such.png"}}};
        j["meshes"][0]["primitives"][0]["material"] = 0;
    }));
    EXPECT_TRUE(test::warned(in.warnings, "missing-image"));
    EXPECT_EQ(in.scene.materials().size(), 1u);
    EXPECT_TRUE(in.scene.images().empty());
}

}  // namespace
}  // namespace mw
