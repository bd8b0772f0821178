// A project file gives back the very scene that was saved, shows the plain part to others, and never trusts what it reads.
#include <random>

#include "data.h"
#include "samples.h"

namespace mw {
namespace {

using nlohmann::json;

struct Unpacked {
    json root;
    std::vector<uint8_t> bin;
};

Unpacked unpacked(const std::vector<uint8_t>& glb)
{
    GltfContainer c = gltfContainer(glb);
    return {std::move(c.root), {c.bin.begin(), c.bin.end()}};
}

Imported read(const std::vector<uint8_t>& glb, GltfReadOptions::Project p = GltfReadOptions::Project::WhenIntact)
{
    return readGltf(glb, {}, GltfReadOptions{p});
}

void expectSame(const Scene& s)
{
    const Imported in = read(glbOf(s, {true}));
    EXPECT_TRUE(in.project);
    EXPECT_TRUE(in.warnings.empty()) << in.warnings[0].text;
    EXPECT_EQ(contentHash(in.scene), contentHash(s));
}

TEST(Project, GivesBackTheVeryScene)
{
    expectSame(test::richScene());
    expectSame(test::movingScene());
    expectSame(Scene());
    expectSame(test::sceneWith(Mesh()));
    expectSame(test::sceneWith(test::sheet(40)));
}

// Channels that share their times do so again, and the file has them once.
TEST(Project, SharesWhatWasShared)
{
    const auto glb = glbOf(test::movingScene(), {true});
    const json clips = unpacked(glb).root["extensions"]["MESHWRIGHT_project"]["clips"];
    EXPECT_EQ(clips[0]["channels"][0]["times"], clips[0]["channels"][1]["times"]);
    EXPECT_EQ(clips[0]["channels"][2]["times"], clips[1]["channels"][0]["times"]);
    const Scene s = read(glb).scene;
    const Clip &walk = *s.find(s.clips()[0]), &still = *s.find(s.clips()[1]);
    EXPECT_EQ(walk.channels[0]->times.id(), walk.channels[4]->times.id());
    EXPECT_EQ(walk.channels[2]->times.id(), still.channels[3]->times.id());
}

// Files saved before there were skins, clips and terrains.
TEST(Project, OfTheFirstVersionStillOpens)
{
    Unpacked u = unpacked(glbOf(test::richScene(), {true}));
    u.root["extensions"]["MESHWRIGHT_project"]["version"] = 1;
    const Imported in = read(glbContent(u.root.dump(), u.bin));
    EXPECT_TRUE(in.project);
    EXPECT_EQ(contentHash(in.scene), contentHash(test::richScene()));
}

TEST(Project, DamagedMotionAndTerrainFallBackToThePlainPart)
{
    const Unpacked u = unpacked(glbOf(test::movingScene(), {true}));
    const std::string at = "/extensions/MESHWRIGHT_project";
    const std::vector<std::pair<const char*, const char*>> faults{{"/skins/0/joints/1", "99"},
                                                                  {"/skins/0/joints", "[3]"},
                                                                  {"/skins/0/inverseBind", "0"},
                                                                  {"/clips/0/channels/0/node", "99"},
                                                                  {"/clips/0/channels/0/path", "10"},
                                                                  {"/clips/0/channels/0/interpolation", "2"},
                                                                  {"/clips/0/channels/0/components", "4"},
                                                                  {"/clips/0/channels/4/components", "0"},
                                                                  {"/clips/0/channels/1/values", "999"},
                                                                  {"/clips/0/channels/0/times", "1"},
                                                                  {"/terrains/0/width", "4"},
                                                                  {"/terrains/0/width", "20000"},
                                                                  {"/terrains/0/height", "1"},
                                                                  {"/terrains/0/detail", "[]"},
                                                                  {"/terrains/0/sourceValues", "3"},
                                                                  {"/nodes/0/joint", "3"},
                                                                  {"/nodes/0/skin", "99"},
                                                                  {"/nodes/0/terrain", "99"}};
    for (const auto& [pointer, value] : faults) {
        json j = u.root;
        j[json::json_pointer(at + pointer)] = json::parse(value);
        const Imported in = read(glbContent(j.dump(), u.bin));
        EXPECT_FALSE(in.project) << pointer << " " << value;
        EXPECT_TRUE(test::warned(in.warnings, "project-damaged")) << pointer;
    }
}

TEST(Project, KeepsEveryTypeAndOrder)
{
    Scene s = test::richScene();
    // Ids with gaps, children in an order of their own, numbers JSON has no word for.
    Node noted;
    noted.name = "extra";
    noted.extras = "[1]";
    const NodeId extra = s.add(noted);
    const NodeId first = s.roots()[0];
    s.reparent(first, extra);
    s.remove(s.roots()[0]);
    Mesh m = test::cube().withLines(Array<uint32_t>{0, 6});
    Attribute exact;
    exact.name = "exact";
    exact.domain = Domain::Face;
    exact.values = Shared<double>(Array<double>{1.0 / 3, 1e300, -0.0, 5e-324, std::nan(""), -INFINITY});
    exact.stored = Scalar::Float64;
    m = m.with(exact).with(integerAttribute("tag", Domain::Corner, 1, Array<int32_t>(24, INT32_MIN)));
    MeshObject o{"odd", m, {}, {}};
    o.stack.push_back({s.newModifierId(), "loop", {{"x", INFINITY}, {"y", -0.0}, {"n", int64_t(-5)}, {"big", int64_t(1) << 60}}, true});
    Node n;
    n.mesh = s.add(o);
    s.add(n, extra);
    expectSame(s);
}

TEST(Project, RealFilesSurvive)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* file :
         {"gltf/BoxTextured.glb", "characters/cesium_man.gltf", "characters/robot.glb", "gltf/AnimatedMorphSphere/AnimatedMorphSphere.gltf"})
        expectSame(readGltf(data / file).scene);
}

TEST(Project, IsNoticedWhenAnotherProgramChangedTheRest)
{
    const Scene s = test::richScene();
    const auto glb = glbOf(s, {true});
    const Unpacked u = unpacked(glb);
    EXPECT_FALSE(read(glb, GltfReadOptions::Project::Never).project);

    Unpacked named = u;
    named.root["nodes"][0]["name"] = "renamed elsewhere";
    Unpacked moved = u;
    const size_t positions = moved.root["accessors"][0]["bufferView"];
    moved.bin[moved.root["bufferViews"][positions]["byteOffset"].get<size_t>()] ^= 1;
    for (const Unpacked& changed : {named, moved}) {
        const auto bytes = glbContent(changed.root.dump(), changed.bin);
        const Imported plain = read(bytes);
        EXPECT_FALSE(plain.project);
        EXPECT_TRUE(test::warned(plain.warnings, "project-core-changed"));
        EXPECT_FALSE(plain.scene.nodes().empty());
        const Imported anyway = read(bytes, GltfReadOptions::Project::Always);
        EXPECT_TRUE(anyway.project);
        EXPECT_EQ(contentHash(anyway.scene), contentHash(s));
    }
    // Only written anew, with other spaces and an added extra buffer: the same.
    EXPECT_TRUE(read(glbContent(u.root.dump(3), u.bin)).project);
}

TEST(Project, NewerOrDamagedFallsBackToThePlainPart)
{
    const Unpacked u = unpacked(glbOf(test::richScene(), {true}));
    const std::string at = "/extensions/MESHWRIGHT_project";
    const std::vector<std::pair<const char*, const char*>> faults{{"/version", "3"},
                                                                  {"/version", "null"},
                                                                  {"/core", "[]"},
                                                                  {"/meshes/0/positions", "999"},
                                                                  {"/meshes/0/cornerVertex", "0"},
                                                                  {"/meshes/0/id", "0"},
                                                                  {"/meshes/0/id", "4294967295"},
                                                                  {"/nodes/0/children", "[1]"},
                                                                  {"/nodes/1/children", "[2, 2]"},
                                                                  {"/nodes/1/mesh", "77"},
                                                                  {"/roots", "[5]"},
                                                                  {"/roots", "[]"},
                                                                  {"/roots/0", "\"x\""},
                                                                  {"/meshes/0/attributes/0/components", "3"},
                                                                  {"/meshes/0/attributes/0/components", "0"},
                                                                  {"/meshes/0/attributes/0/domain", "3"},
                                                                  {"/meshes/0/attributes/0/type", "\"f16\""},
                                                                  {"/meshes/0/faceStart", "0"},
                                                                  {"/meshes/0/stack/0/values", "[]"},
                                                                  {"/meshes/0/stack/0/values/at", "[1]"},
                                                                  {"/images/0/view", "-1"},
                                                                  {"/materials/0/baseColor", "[1]"},
                                                                  {"/nodes", "{}"}};
    for (const auto& [pointer, value] : faults) {
        json j = u.root;
        j[json::json_pointer(at + pointer)] = json::parse(value);
        const Imported in = read(glbContent(j.dump(), u.bin));
        EXPECT_FALSE(in.project) << pointer << " " << value;
        EXPECT_TRUE(test::warned(in.warnings, "project-damaged")) << pointer;
        EXPECT_EQ(in.scene.nodes().size(), 3u);
    }
}

// Pictures and what is shown lie in the file once.
TEST(Project, SharesPicturesWithThePlainPart)
{
    Scene s = test::richScene();
    const auto with = glbOf(s, {true});
    const json j = unpacked(with).root;
    EXPECT_EQ(j["extensions"]["MESHWRIGHT_project"]["images"][0]["view"], j["images"][0]["bufferView"]);
}

}  // namespace
}  // namespace mw
