// Broken files: an Error that says where and what to do, or a usable scene; never a crash, a hang, or memory without bound.
#include <chrono>
#include <fstream>
#include <random>

#include "core/scene/scene_pose.h"

#include "data.h"
#include "samples.h"

namespace mw {
namespace {

using nlohmann::json;
using test::triangleGlb;

// Whatever moves must be safe to play: joints that are there, weights of slots that are there, times that ascend, a value for each.
void checkMotion(const Scene& s)
{
    for (const NodeId n : s.nodes()) {
        const Skin* skin = s.find(s.node(n).skin);
        if (!skin) continue;
        EXPECT_EQ(skin->joints.size(), skin->inverseBind.size());
        const MeshObject* o = s.find(s.node(n).mesh);
        const Attribute* joints = o ? o->base.find("joints") : nullptr;
        for (const int32_t j : joints ? joints->integers() : std::span<const int32_t>())
            if (j < 0 || size_t(j) >= skin->joints.size()) ADD_FAILURE() << "slot " << j << " of " << skin->joints.size();
    }
    for (const ClipId id : s.clips()) {
        const Clip& clip = *s.find(id);
        for (const auto& c : clip.channels) {
            if (!s.find(c->node)) ADD_FAILURE() << "channel without its node";
            const size_t perKey = c->interpolation == Channel::Interpolation::Cubic ? 3 : 1;
            if (c->values.size() != c->keys() * perKey * size_t(c->components)) ADD_FAILURE() << "wrong number of values";
            for (size_t k = 0; k < c->keys(); ++k)
                if (!(c->times[k] >= 0) || !std::isfinite(c->times[k]) || (k && c->times[k] < c->times[k - 1])) ADD_FAILURE() << "times";
        }
        poseAt(s, clip, duration(clip) / 2);
    }
}

// What came of it: the text of the Error, or empty when it was read. Whatever was read must be a valid mesh.
std::string outcome(std::span<const uint8_t> content)
{
    try {
        const Imported in = readGltf(content, {});
        for (const MeshId id : in.scene.meshes()) {
            const Mesh& m = in.scene.find(id)->base;
            for (const uint32_t v : m.cornerVertex())
                if (v >= m.vertexCount()) ADD_FAILURE() << "vertex out of range";
            for (const glm::vec3& p : m.positions())
                if (!std::isfinite(p.x + p.y + p.z) && !(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
                    ADD_FAILURE() << "position is no number";
            for (const Attribute& a : m.attributes())
                if (a.size() != m.count(a.domain)) ADD_FAILURE() << a.name << " has a wrong size";
        }
        if (!in.project) checkMotion(in.scene);
        for (const NodeId n : in.scene.nodes())
            if (in.scene.node(n).mesh && !in.scene.find(in.scene.node(n).mesh)) ADD_FAILURE() << "node without its mesh";
        return {};
    } catch (const Error& e) {
        EXPECT_GT(e.reason().size(), 10u);
        return e.what();
    }
}

class MalformedFiles : public testing::TestWithParam<const char*> {};

TEST_P(MalformedFiles, AreRefused)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto file = data / "malformed" / GetParam();
    const auto begin = std::chrono::steady_clock::now();
    try {
        readGltf(file);
        FAIL() << "was read";
    } catch (const Error& e) {
        EXPECT_EQ(e.file(), file.string());
        EXPECT_NE(e.reason().find(';'), std::string::npos) << e.reason() << " has no remedy";
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

INSTANTIATE_TEST_SUITE_P(Data, MalformedFiles,
                         testing::Values("empty.gltf", "empty.glb", "wrong_magic.glb", "truncated.gltf", "accessor_huge_count.gltf",
                                         "bufferview_past_end.gltf", "missing_bin.gltf", "node_cycle.gltf", "mesh_index_out_of_range.gltf",
                                         "truncated.glb", "length_lies.glb", "not_json.gltf", "assimp/IndexOutOfRange.gltf",
                                         "assimp/RecursiveNodes.gltf", "assimp/badArray.gltf", "assimp/badUint.gltf", "assimp/NoScene.gltf"));

TEST(GltfMalformed, TheControlIsRead)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readGltf(data / "malformed/valid_triangle.gltf");
    EXPECT_EQ(test::onlyMesh(in.scene).base.faceCount(), 1u);
    EXPECT_TRUE(in.warnings.empty());
}

// Each edit breaks one number; the message must name the place.
struct Fault {
    const char *pointer, *value, *place;
};

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, NameTheirPlace)
{
    const Fault& f = GetParam();
    const std::string said = outcome(triangleGlb([&](json& j, auto&) { j[json::json_pointer(f.pointer)] = json::parse(f.value); }));
    EXPECT_NE(said.find(f.place), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(
    Each, Faults,
    testing::Values(Fault{"/asset/version", "\"1.0\"", "/asset/version"},
                    Fault{"/accessors/0/count", "4000000000", "/accessors/0: count 4000000000 needs 48 GB"},
                    Fault{"/accessors/0/count", "-1", "/accessors/0/count"}, Fault{"/accessors/0/count", "1.5", "/accessors/0/count"},
                    Fault{"/accessors/0/count", "1e300", "/accessors/0/count"}, Fault{"/accessors/0/byteOffset", "4", "/accessors/0"},
                    Fault{"/accessors/0/byteOffset", "9007199254740992", "/accessors/0"}, Fault{"/accessors/0/type", "\"VEC5\"", "/accessors/0/type"},
                    Fault{"/accessors/0/type", "\"SCALAR\"", "POSITION"}, Fault{"/accessors/0/componentType", "5124", "/accessors/0/componentType"},
                    Fault{"/accessors/0/min", "[0]", "/accessors/0/min"}, Fault{"/accessors/0/max", "[0,\"1\",2]", "/accessors/0/max/1"},
                    Fault{"/accessors/1/componentType", "5126", "/accessors/1"}, Fault{"/accessors/0/bufferView", "7", "/accessors/0/bufferView"},
                    Fault{"/bufferViews/0/buffer", "1", "/bufferViews/0/buffer"}, Fault{"/bufferViews/0/byteLength", "45", "/bufferViews/0"},
                    Fault{"/bufferViews/0/byteOffset", "9007199254740992", "/bufferViews/0"}, Fault{"/bufferViews/0/byteStride", "4", "/accessors/0"},
                    Fault{"/bufferViews/0/byteStride", "1000", "/bufferViews/0"}, Fault{"/buffers/0/byteLength", "1000", "/buffers/0"},
                    Fault{"/nodes/0/mesh", "1", "/nodes/0/mesh"}, Fault{"/nodes/0/children", "[0]", "/nodes"},
                    Fault{"/nodes/0/children", "[9]", "/nodes/0/children/0"}, Fault{"/nodes/0/children", "{}", "/nodes/0/children"},
                    Fault{"/nodes/0/rotation", "[0,1]", "/nodes/0/rotation"}, Fault{"/nodes/0/matrix", "[1,2,3]", "/nodes/0/matrix"},
                    Fault{"/nodes/0/name", "5", "/nodes/0/name"}, Fault{"/nodes/0/skin", "0", "/nodes/0/skin"},
                    Fault{"/scenes/0/nodes", "[0,0]", "/scenes/0/nodes/1"}, Fault{"/scenes/0/nodes", "[3]", "/scenes/0/nodes/0"},
                    Fault{"/scene", "2", "/scene"}, Fault{"/meshes/0/primitives", "{}", "/meshes/0/primitives"},
                    Fault{"/meshes/0/primitives/0/mode", "7", "/meshes/0/primitives/0/mode"},
                    Fault{"/meshes/0/primitives/0/material", "0", "/meshes/0/primitives/0/material"},
                    Fault{"/meshes/0/primitives/0/indices", "4", "/meshes/0/primitives/0/indices"},
                    Fault{"/meshes/0/primitives/0/attributes/NORMAL", "4", "/meshes/0/primitives/0/attributes/NORMAL"},
                    Fault{"/skins", "[{\"joints\":[4]}]", "/skins/0/joints/0"},
                    Fault{"/extensionsRequired", "[\"KHR_draco_mesh_compression\"]", "without compression"}));

TEST(GltfMalformed, IndicesBeyondTheVertices)
{
    const std::string said = outcome(triangleGlb([](json&, std::vector<uint8_t>& bin) { bin[40] = 3; }));
    EXPECT_NE(said.find("/meshes/0/primitives/0/indices: entry 2 is vertex 3 of 3"), std::string::npos) << said;
}

// The same one array of matrices, times or values for very many skins and channels: it is decoded once, or refused.
TEST(GltfMalformed, MotionThatIsUsedAgainAndAgain)
{
    const auto glb = [](size_t count, const char* list, const char* entry) {
        return triangleGlb([&](json& j, std::vector<uint8_t>& bin) {
            bin.resize(48 + 64 * 4000, 0);
            const size_t size = bin.size() - 48;
            for (size_t i = 0; i < size / 4; ++i) {
                const auto x = float(i);
                std::memcpy(bin.data() + 48 + 4 * i, &x, 4);
            }
            j["buffers"][0]["byteLength"] = bin.size();
            j["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 48}, {"byteLength", size}});
            j["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 4000}, {"type", "MAT4"}});
            j["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 21333}, {"type", "SCALAR"}});
            j["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 21333}, {"type", "VEC3"}});
            const json one = json::parse(entry);
            for (size_t i = 0; i < count; ++i) j[list].push_back(one);
        });
    };
    const std::string skin = R"({"inverseBindMatrices": 2, "joints": [0)" + [] {
        std::string more;
        for (int i = 1; i < 100; ++i) more += ",0";
        return more + "]}";
    }();
    outcome(glb(20000, "skins", skin.c_str()));
    EXPECT_EQ(outcome(glb(2000, "animations",
                          R"({"samplers": [{"input": 3, "output": 4}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "scale"}}]})")),
              "");
}

TEST(GltfMalformed, DeepAndBulkyJson)
{
    const auto text = [](std::string s) { return std::vector<uint8_t>(s.begin(), s.end()); };
    EXPECT_NE(outcome(text("{\"a\":" + std::string(1000000, '['))), "");
    std::string many = "{\"asset\":{\"version\":\"2.0\"},\"x\":[";
    for (int i = 0; i < 10000000; ++i) many += "1,";
    EXPECT_NE(outcome(text(many + "1]}")).find("more values"), std::string::npos);
}

// Small files that mean far more memory than they have bytes.
TEST(GltfMalformed, AmplificationIsBounded)
{
    const std::string zeros = outcome(triangleGlb([](json& j, auto&) {
        j["accessors"][0].erase("bufferView");
        j["accessors"][0]["count"] = 4000000000u;
        j["meshes"][0]["primitives"][0].erase("indices");
    }));
    EXPECT_NE(zeros, "");
    const std::string again = outcome(triangleGlb([](json& j, std::vector<uint8_t>& bin) {
        bin.resize(44 + 2000000, 0);
        j["buffers"][0]["byteLength"] = bin.size();
        j["bufferViews"][1]["byteLength"] = 2000000;
        j["accessors"][1]["count"] = 1000000;
        const json p = j["meshes"][0]["primitives"][0];
        for (int i = 0; i < 5000; ++i) j["meshes"][0]["primitives"].push_back(p);
    }));
    EXPECT_NE(again.find("again and again"), std::string::npos) << again;
}

TEST(GltfMalformed, EveryTruncationIsRefused)
{
    for (const int kind : {0, 1, 2, 3}) {
        const std::vector<uint8_t> whole = glbOf(kind < 2 ? test::richScene() : test::movingScene(), {kind % 2 == 1});
        const size_t step = std::max<size_t>(whole.size() / 400, 1);
        for (size_t n = 0; n < whole.size(); n += n < 64 ? 1 : step) EXPECT_NE(outcome({whole.data(), n}), "") << n << " bytes";
        EXPECT_EQ(outcome(whole), "");
    }
}

// Bytes and words changed by chance, in the JSON and in the data.
TEST(GltfMalformed, RandomMutationsNeverCrash)
{
    std::mt19937 random(20240607);
    std::vector<std::vector<uint8_t>> seeds{glbOf(test::richScene(), {false}), glbOf(test::richScene(), {true}), triangleGlb([](json&, auto&) {}),
                                            glbOf(test::movingScene(), {false}), glbOf(test::movingScene(), {true})};
    for (const auto& seed : seeds)
        for (int round = 0; round < 1500; ++round) {
            std::vector<uint8_t> content = seed;
            const int changes = 1 + int(random() % 4);
            for (int c = 0; c < changes; ++c) {
                const size_t at = random() % content.size();
                switch (random() % 4) {
                    case 0:
                        content[at] = uint8_t(random());
                        break;
                    case 1:
                        content[at] ^= uint8_t(1 << random() % 8);
                        break;
                    case 2:
                        content[at] = uint8_t('0' + random() % 10);
                        break;
                    default:
                        for (size_t k = at; k < std::min(at + 4, content.size()); ++k) content[k] = 0xFF;
                }
            }
            outcome(content);
        }
}

// The structure stays JSON, but values change places and types.
TEST(GltfMalformed, RandomJsonNeverCrashes)
{
    std::mt19937 random(7);
    const std::vector<const char*> values{"0", "1", "-1", "4294967295", "1e308", "[]", "{}", "\"\"", "null", "true", "[0]", "{\"a\":1}", "5126", "3"};
    for (const int kind : {0, 1, 2, 3}) {
        const auto glb = glbOf(kind < 2 ? test::richScene() : test::movingScene(), {kind % 2 == 1});
        const size_t size = glb[12] | glb[13] << 8 | glb[14] << 16;
        const json whole = json::parse(glb.begin() + 20, glb.begin() + 20 + std::ptrdiff_t(size));
        const std::span<const uint8_t> bin(glb.data() + 28 + size, glb.size() - 28 - size);
        const json flat = whole.flatten();
        for (int round = 0; round < 1500; ++round) {
            json j = whole;
            auto at = flat.begin();
            std::advance(at, random() % flat.size());
            json::json_pointer p(at.key());
            for (size_t up = random() % 4; up > 0 && !p.empty(); --up) p.pop_back();
            if (p.empty()) continue;
            if (random() % 3)
                j[p] = json::parse(values[random() % values.size()]);
            else if (json& parent = j[p.parent_pointer()]; parent.is_object())
                parent.erase(p.back());
            outcome(glbContent(j.dump(), bin));
        }
    }
}

}  // namespace
}  // namespace mw
