// Skins, animations and morph weights of glTF files: real files as tinygltf (another program's reader) finds them, each rule on a small file.
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tiny_gltf.h>

#include "core/scene/scene_pose.h"

#include "data.h"
#include "samples.h"

namespace mw {
namespace {

using nlohmann::json;

tinygltf::Model loaded(const std::filesystem::path& file)
{
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error, warning;
    const bool good = file.extension() == ".glb" ? reader.LoadBinaryFromFile(&model, &error, &warning, file.string())
                                                 : reader.LoadASCIIFromFile(&model, &error, &warning, file.string());
    EXPECT_TRUE(good) << error;
    return model;
}

// All numbers of an accessor of floats.
std::vector<float> floatsOf(const tinygltf::Model& m, int accessor)
{
    const tinygltf::Accessor& a = m.accessors[size_t(accessor)];
    const tinygltf::BufferView& v = m.bufferViews[size_t(a.bufferView)];
    const size_t n = size_t(tinygltf::GetNumComponentsInType(uint32_t(a.type)));
    EXPECT_EQ(a.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
    std::vector<float> out(a.count * n);
    for (size_t i = 0; i < a.count; ++i)
        std::memcpy(out.data() + i * n, m.buffers[size_t(v.buffer)].data.data() + v.byteOffset + a.byteOffset + i * size_t(a.ByteStride(v)), 4 * n);
    return out;
}

// The nodes of the file in depth-first order from its scene: the order of Scene::nodes().
std::vector<int> depthFirst(const tinygltf::Model& m)
{
    std::vector<int> order,
        open(m.scenes[size_t(std::max(m.defaultScene, 0))].nodes.rbegin(), m.scenes[size_t(std::max(m.defaultScene, 0))].nodes.rend());
    while (!open.empty()) {
        order.push_back(open.back());
        open.pop_back();
        const std::vector<int>& children = m.nodes[size_t(order.back())].children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

class RealMotion : public testing::TestWithParam<const char*> {};

TEST_P(RealMotion, SkinsAreThoseOfTheFile)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const tinygltf::Model m = loaded(data / GetParam());
    const Scene s = readGltf(data / GetParam()).scene;
    const std::vector<int> order = depthFirst(m);
    const std::vector<NodeId> ids = s.nodes();
    ASSERT_EQ(order.size(), ids.size());
    std::map<int, NodeId> id;
    for (size_t i = 0; i < order.size(); ++i) id[order[i]] = ids[i];
    ASSERT_EQ(s.skins().size(), m.skins.size());
    std::set<int> joints;
    for (const int n : order) {
        const tinygltf::Node& node = m.nodes[size_t(n)];
        EXPECT_EQ(s.node(id[n]).name, node.name);
        ASSERT_EQ(bool(s.node(id[n]).skin), node.skin >= 0);
        if (node.skin < 0) continue;
        const tinygltf::Skin& skin = m.skins[size_t(node.skin)];
        const Skin& ours = *s.find(s.node(id[n]).skin);
        ASSERT_EQ(ours.joints.size(), skin.joints.size());
        EXPECT_EQ(ours.name, skin.name);
        const std::vector<float> matrices = floatsOf(m, skin.inverseBindMatrices);
        for (size_t j = 0; j < skin.joints.size(); ++j) {
            EXPECT_EQ(ours.joints[j], id[skin.joints[j]]);
            joints.insert(skin.joints[j]);
            for (size_t k = 0; k < 16; ++k) ASSERT_EQ(ours.inverseBind[j][int(k / 4)][int(k % 4)], double(matrices[16 * j + k]));
        }
    }
    for (const int n : order) EXPECT_EQ(s.node(id[n]).joint, joints.contains(n) ? Node::Joint::Joint : Node::Joint::No);
}

TEST_P(RealMotion, ClipsAreThoseOfTheFile)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const tinygltf::Model m = loaded(data / GetParam());
    const Imported in = readGltf(data / GetParam());
    const Scene& s = in.scene;
    EXPECT_FALSE(test::warned(in.warnings, "bad-channel"));
    const std::vector<int> order = depthFirst(m);
    ASSERT_EQ(s.clips().size(), m.animations.size());
    for (size_t a = 0; a < m.animations.size(); ++a) {
        const tinygltf::Animation& theirs = m.animations[a];
        const Clip& clip = *s.find(s.clips()[a]);
        EXPECT_EQ(clip.name, theirs.name);
        ASSERT_EQ(clip.channels.size(), theirs.channels.size());
        std::map<int, const void*> timesOf;
        for (size_t c = 0; c < clip.channels.size(); ++c) {
            const tinygltf::AnimationChannel& channel = theirs.channels[c];
            const tinygltf::AnimationSampler& sampler = theirs.samplers[size_t(channel.sampler)];
            const Channel& ours = *clip.channels[c];
            const auto at = std::find(order.begin(), order.end(), channel.target_node) - order.begin();
            EXPECT_EQ(ours.node, s.nodes()[size_t(at)]);
            const std::map<std::string, Channel::Path> paths{{"translation", Channel::Path::Translation},
                                                             {"rotation", Channel::Path::Rotation},
                                                             {"scale", Channel::Path::Scale},
                                                             {"weights", Channel::Path::Weights}};
            EXPECT_EQ(ours.path, paths.at(channel.target_path));
            const std::vector<float> times = floatsOf(m, sampler.input), values = floatsOf(m, sampler.output);
            EXPECT_TRUE(std::equal(times.begin(), times.end(), ours.times.begin(), ours.times.end()));
            EXPECT_TRUE(std::equal(values.begin(), values.end(), ours.values.begin(), ours.values.end()));
            EXPECT_EQ(timesOf.try_emplace(sampler.input, ours.times.id()).first->second, ours.times.id());  // shared as the file shares them
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Data, RealMotion,
                         testing::Values("characters/cesium_man.gltf", "characters/rigged_simple.gltf", "characters/simple_skin.gltf",
                                         "characters/robot.glb", "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf",
                                         "gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf", "gltf/SimpleMorph/SimpleMorph.gltf",
                                         "gltf/MorphPrimitivesTest/MorphPrimitivesTest.gltf"));

TEST(GltfMotion, DefaultWeightsGoToTheNode)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Scene half = readGltf(data / "gltf/SimpleMorph/SimpleMorph.gltf").scene;
    EXPECT_EQ(half.node(half.roots()[0]).morphWeights, (std::vector<double>{0.5, 0.5}));
    const Scene none = readGltf(data / "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf").scene;
    EXPECT_TRUE(none.node(none.roots()[0]).morphWeights.empty());
}

/// A skinned triangle: node 0 shows it, nodes 1 (below 0's sibling) and 2 are joints; animation of node 2 with 3 keys.
/// Accessors: 0 positions, 1 indices, 2 joints (u8), 3 weights, 4 inverse binds, 5 times, 6 translations, 7 rotations (i16), 8 weights of 2 targets.
std::vector<uint8_t> skinnedGlb(const std::function<void(json&, std::vector<uint8_t>&)>& edit = {})
{
    return test::triangleGlb([&](json& j, std::vector<uint8_t>& bin) {
        const auto view = [&](const void* data, size_t size) {
            bin.resize((bin.size() + 7) & ~size_t(7), 0);
            j["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", size}});
            bin.insert(bin.end(), static_cast<const uint8_t*>(data), static_cast<const uint8_t*>(data) + size);
            return j["bufferViews"].size() - 1;
        };
        const auto accessor = [&](size_t v, int component, size_t count, const char* type, bool normalized = false) {
            j["accessors"].push_back({{"bufferView", v}, {"componentType", component}, {"count", count}, {"type", type}});
            if (normalized) j["accessors"].back()["normalized"] = true;
        };
        const uint8_t joints[] = {0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
        const float weights[] = {0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
        float binds[32] = {};
        for (const size_t k : {0u, 5u, 10u, 15u, 16u, 21u, 26u, 31u}) binds[k] = 1;
        binds[16 + 13] = -2;
        const float times[] = {0, 0.5f, 2}, moves[] = {0, 0, 0, 1, 0, 0, 1, 2, 0}, morphs[] = {0, 1, 0.5f, 0, 1, 1};
        const int16_t turns[] = {0, 0, 0, 32767, 0, 0, 32767, 0, -32767, 0, 0, 0};
        accessor(view(joints, sizeof joints), 5121, 3, "VEC4");
        accessor(view(weights, sizeof weights), 5126, 3, "VEC4");
        accessor(view(binds, sizeof binds), 5126, 2, "MAT4");
        accessor(view(times, sizeof times), 5126, 3, "SCALAR");
        accessor(view(moves, sizeof moves), 5126, 3, "VEC3");
        accessor(view(turns, sizeof turns), 5122, 3, "VEC4", true);
        accessor(view(morphs, sizeof morphs), 5126, 6, "SCALAR");
        json& primitive = j["meshes"][0]["primitives"][0];
        primitive["attributes"]["JOINTS_0"] = 2;
        primitive["attributes"]["WEIGHTS_0"] = 3;
        primitive["targets"] = json::parse(R"([{"POSITION": 0}, {"POSITION": 0}])");
        j["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0, "name": "body"}, {"children": [2], "name": "hip"}, {"name": "knee"}])");
        j["scenes"][0]["nodes"] = {0, 1};
        j["skins"] = json::parse(R"([{"name": "rig", "joints": [1, 2], "inverseBindMatrices": 4, "skeleton": 1}])");
        j["animations"] = json::parse(R"([{"name": "walk",
            "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}, {"sampler": 1, "target": {"node": 2, "path": "rotation"}},
                         {"sampler": 2, "target": {"node": 0, "path": "weights"}}],
            "samplers": [{"input": 5, "output": 6}, {"input": 5, "output": 7, "interpolation": "STEP"}, {"input": 5, "output": 8}]}])");
        if (edit) edit(j, bin);
        j["buffers"][0]["byteLength"] = bin.size();
    });
}

TEST(GltfMotion, SmallFileMeansWhatItSays)
{
    const Imported in = readGltf(skinnedGlb(), {});
    EXPECT_TRUE(in.warnings.empty()) << in.warnings[0].text;
    const Scene& s = in.scene;
    const NodeId body = s.roots()[0], hip = s.roots()[1], knee = s.node(hip).children[0];
    ASSERT_TRUE(s.find(s.node(body).skin));
    const Skin& skin = *s.find(s.node(body).skin);
    EXPECT_EQ(skin.name, "rig");
    EXPECT_EQ(skin.joints, (std::vector<NodeId>{hip, knee}));
    EXPECT_EQ(skin.skeleton, hip);
    EXPECT_EQ(skin.inverseBind[0], glm::dmat4(1));
    EXPECT_EQ(skin.inverseBind[1][3], glm::dvec4(0, -2, 0, 1));
    EXPECT_EQ(s.node(body).joint, Node::Joint::No);
    EXPECT_EQ(s.node(knee).joint, Node::Joint::Joint);
    ASSERT_EQ(s.clips().size(), 1u);
    const Clip& clip = *s.find(s.clips()[0]);
    EXPECT_EQ(clip.name, "walk");
    ASSERT_EQ(clip.channels.size(), 3u);
    EXPECT_EQ(duration(clip), 2);
    const Channel& turn = *clip.channels[1];
    EXPECT_EQ(turn.node, knee);
    EXPECT_EQ(turn.interpolation, Channel::Interpolation::Step);
    const double expected[] = {0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, 0};
    EXPECT_TRUE(std::equal(turn.values.begin(), turn.values.end(), expected, expected + 12));
    EXPECT_EQ(turn.times.id(), clip.channels[0]->times.id());
    EXPECT_EQ(clip.channels[2]->components, 2);
    EXPECT_EQ(clip.channels[2]->node, body);
}

struct Odd {
    const char *pointer, *value;  // what is changed
    const char* code;             // the warning that comes of it
    size_t skins, channels;       // what is left
};
class OddMotion : public testing::TestWithParam<Odd> {};

TEST_P(OddMotion, IsLeftOutWithAWarningThatNamesThePlace)
{
    const Odd& o = GetParam();
    const Imported in = readGltf(skinnedGlb([&](json& j, auto&) { j[json::json_pointer(o.pointer)] = json::parse(o.value); }), {});
    ASSERT_FALSE(in.warnings.empty());
    EXPECT_EQ(in.warnings[0].code, o.code);
    EXPECT_EQ(in.warnings[0].text[0], '/');
    EXPECT_EQ(in.scene.skins().size(), o.skins);
    size_t channels = 0;
    for (const ClipId c : in.scene.clips()) channels += in.scene.find(c)->channels.size();
    EXPECT_EQ(channels, o.channels);
    EXPECT_EQ(test::onlyMesh(in.scene).base.faceCount(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Each, OddMotion,
    testing::Values(Odd{"/accessors/4/count", "1", "bad-skin", 0, 3}, Odd{"/skins/0/inverseBindMatrices", "3", "bad-skin", 0, 3},
                    Odd{"/scenes/0/nodes", "[0]", "bad-skin", 0, 1}, Odd{"/skins/0/joints", "[]", "bad-skin", 0, 3},
                    Odd{"/skins/0/joints", "[1]", "bad-joints", 1, 3}, Odd{"/nodes/1/skin", "0", "bad-skin", 1, 3},
                    Odd{"/accessors/5/count", "2", "bad-channel", 1, 0}, Odd{"/accessors/6/count", "2", "bad-channel", 1, 2},
                    Odd{"/accessors/7/normalized", "false", "bad-channel", 1, 2}, Odd{"/accessors/8/count", "5", "bad-channel", 1, 2},
                    Odd{"/animations/0/samplers/0/interpolation", "\"CUBICSPLINE\"", "bad-channel", 1, 2},
                    Odd{"/animations/0/samplers/0/interpolation", "\"BEZIER\"", "bad-channel", 1, 2},
                    Odd{"/animations/0/samplers/0/output", "7", "bad-channel", 1, 2}, Odd{"/animations/0/samplers/0/input", "6", "bad-channel", 1, 2},
                    Odd{"/animations/0/channels/0/target", "{\"path\": \"translation\"}", "bad-channel", 1, 2},
                    Odd{"/animations/0/channels/0/target/path", "\"pointer\"", "bad-channel", 1, 2},
                    Odd{"/animations/0/channels/1/target/path", "\"weights\"", "bad-channel", 1, 2},
                    Odd{"/animations/0/channels/1/target/path", "\"translation\"", "bad-channel", 1, 2},
                    Odd{"/animations/0/channels", "[]", "empty-animation", 1, 0}, Odd{"/nodes/0/weights", "[1]", "morph-weights", 1, 3}));

TEST(GltfMotion, TimesMustAscendAndBeNumbers)
{
    const auto withTime = [](size_t key, float t) {
        return readGltf(skinnedGlb([&](json& j, std::vector<uint8_t>& bin) {
                            const size_t view = j["accessors"][5]["bufferView"];
                            std::memcpy(bin.data() + j["bufferViews"][view]["byteOffset"].get<size_t>() + 4 * key, &t, 4);
                        }),
                        {});
    };
    for (const auto& [key, t] : {std::pair<size_t, float>{0, -1.f}, {1, 0.f}, {2, 0.4f}, {1, std::nanf("")}, {2, INFINITY}}) {
        const Imported in = withTime(key, t);
        EXPECT_TRUE(in.scene.clips().empty());
        ASSERT_TRUE(test::warned(in.warnings, "bad-channel"));
        EXPECT_NE(in.warnings[0].text.find("time " + std::to_string(key) + " of /accessors/5"), std::string::npos) << in.warnings[0].text;
    }
    EXPECT_EQ(readGltf(skinnedGlb(), {}).scene.clips().size(), 1u);
}

TEST(GltfMotion, WeightsAreMadeToSumToOne)
{
    const Imported in = readGltf(skinnedGlb([](json& j, std::vector<uint8_t>& bin) {
                                     const size_t view = j["accessors"][3]["bufferView"];
                                     const float odd[] = {3, 1, 0, 0, -1, 2};
                                     std::memcpy(bin.data() + j["bufferViews"][view]["byteOffset"].get<size_t>(), odd, sizeof odd);
                                 }),
                                 {});
    EXPECT_TRUE(test::warned(in.warnings, "weights-sum"));
    const Attribute* w = test::onlyMesh(in.scene).base.find("weights");
    ASSERT_TRUE(w);
    const double expected[] = {0.75, 0.25, 0, 0, 0, 1, 0, 0};
    for (size_t i = 0; i < 8; ++i) EXPECT_EQ(w->at(i / 4, int(i % 4)), expected[i]);
}

TEST(GltfMotion, MoreThanFourWeightsAVertex)
{
    const Imported in = readGltf(skinnedGlb([](json& j, auto&) {
                                     json& a = j["meshes"][0]["primitives"][0]["attributes"];
                                     a["JOINTS_1"] = 2;
                                     a["WEIGHTS_1"] = 3;
                                 }),
                                 {});
    const Mesh& m = test::onlyMesh(in.scene).base;
    ASSERT_EQ(m.find("weights")->components, 8);
    ASSERT_EQ(m.find("joints")->components, 8);
    for (size_t v = 0; v < 3; ++v) {
        double sum = 0;
        for (int k = 0; k < 8; ++k) sum += m.find("weights")->at(v, k);
        EXPECT_EQ(sum, 1);
    }
}

// A target without positions is still a target: weights count it.
TEST(GltfMotion, TargetsKeepTheirPlaces)
{
    const Imported in = readGltf(skinnedGlb([](json& j, auto&) {
                                     j["meshes"][0]["primitives"][0]["targets"][0] = json::object();
                                     j["meshes"][0]["extras"]["targetNames"] = {"empty", "wide"};
                                 }),
                                 {});
    const auto& attributes = test::onlyMesh(in.scene).base.attributes();
    std::vector<std::string> names;
    for (const Attribute& a : attributes)
        if (a.name.starts_with("morph:")) names.push_back(a.name);
    EXPECT_EQ(names, (std::vector<std::string>{"morph:empty", "morph:wide"}));
    EXPECT_EQ(in.scene.find(in.scene.clips()[0])->channels.size(), 3u);
}

// Written and read again.

std::multiset<std::string> namesOf(const Scene& s)
{
    std::multiset<std::string> names;
    for (const NodeId n : s.nodes()) names.insert(s.node(n).name);
    return names;
}

std::string pathOf(const Scene& s, NodeId n)
{
    std::string path;
    for (; n; n = s.node(n).parent) path = "/" + s.node(n).name + path;
    return path;
}

void expectSameChannel(const Channel& a, const Channel& b)
{
    EXPECT_EQ(a.path, b.path);
    ASSERT_EQ(a.components, b.components);
    const double last = a.times[a.keys() - 1];
    std::vector<double> x(size_t(a.components)), y(x.size());
    for (int i = 0; i < 10; ++i) {
        sample(a, last * i / 9, x.data());
        sample(b, last * i / 9, y.data());
        for (size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], y[k], 1e-6 * std::max(1.0, std::abs(x[k])));
    }
}

void expectSameVertices(const Mesh& a, const Mesh& b)
{
    ASSERT_EQ(a.vertexCount(), b.vertexCount());
    for (const Attribute& x : a.attributes()) {
        if (x.name == "tangent") continue;  // made to stand at right angles to the normal
        const Attribute* y = b.find(x.name, x.domain);
        ASSERT_TRUE(y) << x.name;
        ASSERT_EQ(x.components, y->components) << x.name;
        ASSERT_EQ(x.size(), y->size());
        double worst = 0;
        for (size_t i = 0; i < x.size(); ++i)
            for (int k = 0; k < x.components; ++k)
                if (x.name != "joints" || a.find("weights")->at(i, k) > 0) worst = std::max(worst, std::abs(x.at(i, k) - y->at(i, k)));
        EXPECT_LE(worst, 1e-6) << x.name;
    }
}

TEST_P(RealMotion, ComesBack)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Scene a = readGltf(data / GetParam()).scene;
    std::vector<Warning> warnings;
    const Imported again = readGltf(glbOf(a, {}, &warnings), {});
    const Scene& b = again.scene;
    EXPECT_TRUE(warnings.empty()) << warnings[0].text;
    EXPECT_TRUE(again.warnings.empty()) << again.warnings[0].text;
    EXPECT_EQ(namesOf(a), namesOf(b));
    ASSERT_EQ(a.clips().size(), b.clips().size());
    for (size_t c = 0; c < a.clips().size(); ++c) {
        const Clip &x = *a.find(a.clips()[c]), &y = *b.find(b.clips()[c]);
        EXPECT_EQ(x.name, y.name);
        ASSERT_EQ(x.channels.size(), y.channels.size());
        for (size_t i = 0; i < x.channels.size(); ++i) {
            EXPECT_EQ(pathOf(a, x.channels[i]->node), pathOf(b, y.channels[i]->node));
            expectSameChannel(*x.channels[i], *y.channels[i]);
        }
    }
    ASSERT_EQ(a.meshes().size(), b.meshes().size());
    for (size_t m = 0; m < a.meshes().size(); ++m) expectSameVertices(a.find(a.meshes()[m])->base, b.find(b.meshes()[m])->base);
    ASSERT_EQ(a.materials().size(), b.materials().size());
    for (size_t m = 0; m < a.materials().size(); ++m) EXPECT_EQ(a.find(a.materials()[m])->name, b.find(b.materials()[m])->name);
    ASSERT_EQ(a.skins().size(), b.skins().size());
    for (size_t k = 0; k < a.skins().size(); ++k) {
        const Skin &x = *a.find(a.skins()[k]), &y = *b.find(b.skins()[k]);
        EXPECT_EQ(x.name, y.name);
        EXPECT_EQ(x.inverseBind, y.inverseBind);
        ASSERT_EQ(x.joints.size(), y.joints.size());
        for (size_t j = 0; j < x.joints.size(); ++j) EXPECT_EQ(pathOf(a, x.joints[j]), pathOf(b, y.joints[j]));
    }
}

// Where the vertices of a mesh are at a time: their number, sum and sum of products, which do not depend on their order.
struct Cloud {
    size_t count = 0;
    glm::dvec3 sum{0};
    glm::dmat3 products{0};
};

std::vector<Cloud> clouds(const Scene& s, const ScenePose& pose)
{
    std::map<MeshId, Cloud> by;
    const auto worlds = worldMatrices(s, pose);
    for (const NodeId n : s.nodes()) {
        const MeshObject* o = s.find(s.node(n).mesh);
        if (!o) continue;
        const auto how = meshPose(s, n, o->base, pose, worlds);
        const Mesh m = how ? posed(o->base, *how) : o->base;
        const glm::dmat4 world = worldFromMesh(s, n, worlds);
        Cloud& c = by[s.node(n).mesh];
        for (const glm::vec3& p : m.positions()) {
            const glm::dvec3 at(world * glm::dvec4(p, 1));
            ++c.count;
            c.sum += at;
            c.products += glm::outerProduct(at, at);
        }
    }
    std::vector<Cloud> all;
    for (const auto& [id, c] : by) all.push_back(c);
    return all;
}

class Characters : public testing::TestWithParam<const char*> {};

TEST_P(Characters, MoveTheSameAfterConversion)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    std::optional<Imported> in;
    try {
        in = readFile(data / "characters" / GetParam());
    } catch (const Error& e) {
        if (std::string_view(e.what()).find("meshwright-import") != std::string_view::npos) GTEST_SKIP() << e.what();
        throw;
    }
    const Scene &a = in->scene, b = readGltf(glbOf(a), {}).scene;
    ASSERT_EQ(a.clips().size(), b.clips().size());
    for (size_t c = 0; c < a.clips().size(); ++c) {
        const Clip &x = *a.find(a.clips()[c]), &y = *b.find(b.clips()[c]);
        EXPECT_EQ(x.name, y.name);
        EXPECT_NEAR(duration(x), duration(y), 1e-5);
        for (int i = 0; i < 10; ++i) {
            const double t = duration(x) * i / 9;
            const std::vector<Cloud> from = clouds(a, poseAt(a, x, t)), to = clouds(b, poseAt(b, y, t));
            ASSERT_EQ(from.size(), to.size());
            for (size_t m = 0; m < from.size(); ++m) {
                ASSERT_EQ(from[m].count, to[m].count);
                const auto n = double(from[m].count),
                           spread = std::sqrt((from[m].products[0][0] + from[m].products[1][1] + from[m].products[2][2]) / n);
                EXPECT_LT(glm::length(from[m].sum - to[m].sum) / n, 1e-4 * spread) << x.name << " at " << t;
                for (int k = 0; k < 3; ++k)
                    EXPECT_LT(glm::length(from[m].products[k] - to[m].products[k]) / n, 1e-4 * spread * spread) << x.name << " at " << t;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Data, Characters,
                         testing::Values("cesium_man.gltf", "rigged_simple.gltf", "simple_skin.gltf", "robot.glb", "pab_arnaud.fbx", "pab_run.fbx",
                                         "pab_walk.fbx", "animation_with_skeleton.fbx", "Testwuson.X", "anim_test.x", "BCN_Epileptic.X",
                                         "bob/Bob.md5mesh", "bob/Bob.md5anim"));

// Where everything stands at a time, by path of names.
std::map<std::string, glm::dmat4> stands(const Scene& s, size_t clip, double time)
{
    std::map<std::string, glm::dmat4> out;
    for (const auto& [id, m] : worldMatrices(s, poseAt(s, *s.find(s.clips()[clip]), time))) out[pathOf(s, id)] = m;
    return out;
}

double difference(const std::map<std::string, glm::dmat4>& a, const std::map<std::string, glm::dmat4>& b)
{
    double worst = 0;
    for (const auto& [path, m] : a)
        if (path.find("body") == std::string::npos)
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) worst = std::max(worst, std::abs(m[c][r] - b.at(path)[c][r]));
    return worst;
}

TEST(GltfMotion, EulerAnglesBecomeRotationsOfTheSameWay)
{
    const Scene a = test::movingScene();
    const Scene b = readGltf(glbOf(a), {}).scene;
    ASSERT_EQ(b.clips().size(), 2u);
    EXPECT_EQ(b.find(b.clips()[0])->name, "walk");
    for (const double t : {0.0, 0.25, 1.0 / 3, 0.5, 1.0, 1.5, 2.0}) EXPECT_LT(difference(stands(a, 0, t), stands(b, 0, t)), 1e-6) << t;
    // 390 degrees about each of three axes in one second: with the keys of the file alone it would be a turn of less than half.
    const Clip& clip = *b.find(b.clips()[1]);
    ASSERT_EQ(clip.channels.size(), 2u);  // translation and rotation
    const Channel& turn = *clip.channels[1];
    EXPECT_EQ(turn.keys(), 21u);
    for (size_t k = 0; k < turn.keys(); ++k) EXPECT_LT(difference(stands(a, 1, turn.times[k]), stands(b, 1, turn.times[k])), 1e-6);
    for (double t = 0; t < 2; t += 0.01) EXPECT_LT(difference(stands(a, 1, t), stands(b, 1, t)), 0.1) << t;
    for (size_t k = 4; k < turn.values.size(); k += 4) {
        double dot = 0;
        for (size_t i = 0; i < 4; ++i) dot += turn.values[k + i] * turn.values[k + i - 4];
        EXPECT_GT(dot, 0.8);
    }
}

TEST(GltfMotion, SkinnedMeshesStandAtTheRoot)
{
    Scene s = test::movingScene();
    const NodeId rig = s.roots()[0], body = s.node(rig).children[1];
    ASSERT_EQ(s.node(body).name, "body");
    // Alone it moves there itself, its place meant nothing; with a child, or driven, it stays and a root of its name carries the mesh.
    for (const bool child : {false, true}) {
        Node hat;
        hat.name = "hat";
        if (child) s.add(hat, body);
        const Scene b = readGltf(glbOf(s), {}).scene;
        EXPECT_EQ(b.nodes().size(), s.nodes().size() + child);
        NodeId shown;
        for (const NodeId r : b.roots())
            if (b.node(r).mesh) shown = r;
        ASSERT_TRUE(shown);
        EXPECT_EQ(b.node(shown).name, "body");
        EXPECT_TRUE(b.node(shown).skin);
        EXPECT_EQ(b.node(shown).local, Transform{});
        EXPECT_EQ(b.node(shown).morphWeights, (std::vector<double>{0.1, 0.7}));
        const auto& channels = b.find(b.clips()[0])->channels;
        EXPECT_EQ(channels.back()->path, Channel::Path::Weights);
        EXPECT_EQ(channels.back()->node, shown);
    }
}

// Of what a mesh names: the joint of weight 0 is 0, no joint twice at a vertex, sums of 1; more than four weights in sets.
TEST(GltfMotion, WeightsAreTidyInTheFile)
{
    Scene s = test::movingScene();
    const MeshId id = s.meshes()[0];
    MeshObject o = *s.find(id);
    const size_t n = o.base.vertexCount();
    Array<int32_t> joints;
    Array<float> weights;
    for (size_t v = 0; v < n; ++v) {
        joints.insert(joints.end(), {1, 1, 7, -3, 2, 0, 2, 1});
        if (v)
            weights.insert(weights.end(), {1, 1, 5, 1, 0.5f, 0.25f, 0.5f, 0.75f});
        else
            weights.insert(weights.end(), 8, 0.f);
    }
    o.base = o.base.with(integerAttribute("joints", Domain::Vertex, 8, joints)).with(floatAttribute("weights", Domain::Vertex, 8, weights));
    s.set(id, o);
    std::vector<Warning> warnings;
    const Imported in = readGltf(glbOf(s, {}, &warnings), {});
    EXPECT_TRUE(test::warned(warnings, "unbound-vertices"));
    EXPECT_TRUE(in.warnings.empty());
    const Mesh& m = in.scene.find(in.scene.meshes().back())->base;  // the first one is the ground
    ASSERT_TRUE(m.find("joints"));
    ASSERT_EQ(m.find("joints")->components, 8);
    const int32_t expectedJoints[] = {1, 0, 0, 0, 2, 0, 0, 0};
    const double expectedWeights[] = {2.75 / 4, 0, 0, 0, 0.25, 0.0625, 0, 0};
    for (int k = 0; k < 8; ++k) {
        EXPECT_EQ(m.find("joints")->at(5, k), expectedJoints[k]);
        EXPECT_EQ(m.find("weights")->at(5, k), expectedWeights[k]);
        EXPECT_EQ(m.find("weights")->at(0, k), k == 0);
    }
}

// A skeleton without a mesh is one for other programs, too.
TEST(GltfMotion, SkeletonsWithoutAMeshStayJoints)
{
    Scene s = test::movingScene();
    s.remove(s.node(s.roots()[0]).children[1]);
    ASSERT_TRUE(s.skins().empty());
    const Imported in = readGltf(glbOf(s), {});
    EXPECT_TRUE(in.warnings.empty());
    size_t joints = 0;
    for (const NodeId n : in.scene.nodes()) joints += in.scene.node(n).joint == Node::Joint::Joint;
    EXPECT_EQ(joints, 3u);
}

// Joints below several roots, and one that a skin names twice: glTF wants one root and each joint once.
TEST(GltfMotion, JointsFindACommonRoot)
{
    Scene s = test::movingScene();
    const NodeId other = s.node(s.roots()[0]).children[0];
    s.reparent(s.node(other).children[0], {});
    const SkinId id = s.skins()[0];
    Skin skin = *s.find(id);
    skin.joints.push_back(skin.joints[0]);
    skin.inverseBind.push_back(glm::dmat4(2));
    s.set(id, skin);
    const Scene b = readGltf(glbOf(s), {}).scene;
    const Skin& read = *b.find(b.skins()[0]);
    ASSERT_EQ(read.joints.size(), 4u);
    EXPECT_EQ(b.node(read.joints[3]).parent, read.joints[0]);
    EXPECT_EQ(b.node(read.joints[3]).local, Transform{});
    EXPECT_EQ(read.inverseBind[3][3][3], 1);
    NodeId top[2];
    for (int i = 0; i < 2; ++i)
        for (NodeId n = read.joints[size_t(i)]; n; n = b.node(n).parent) top[i] = n;
    EXPECT_EQ(top[0], top[1]);
}

}  // namespace
}  // namespace mw
