// BVH in and out: what the format allows, what lies, what is broken, and motion that does not come from a BVH file.
#include "core/io/bvh.h"

#include <clocale>
#include <random>

#include "core/scene/scene_pose.h"

#include "data.h"
#include "helpers.h"

namespace mw::test {
namespace {

namespace fs = std::filesystem;
using Path = Channel::Path;

const std::string hipAndKnee =
    "HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    " JOINT left knee\n {\n  OFFSET 0 -1.5 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {\n   OFFSET 0 -1 0\n  }\n }\n}\n";

std::string motion(const std::string& frames, const std::string& time, const std::string& rows)
{
    return "MOTION\nFrames: " + frames + "\nFrame Time: " + time + "\n" + rows;
}

Imported read(const Folder& folder, const std::string& text)
{
    return readFile(folder.write("a.bvh", text));
}
const Clip& clipOf(const Imported& in)
{
    return *in.scene.find(in.scene.clips().at(0));
}
std::vector<double> valuesOf(const Channel& c)
{
    return {c.values.begin(), c.values.end()};
}
std::string readError(const std::string& text)
{
    const Folder folder;
    return errorOf([&] { read(folder, text); });
}
void expectIn(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), text.npos) << text;
}

/// Scenes whose nodes, channels and numbers are the same, ids as well.
void expectEqual(const Scene& a, const Scene& b)
{
    EXPECT_EQ(contentHash(a), contentHash(b));
    ASSERT_EQ(a.clips().size(), b.clips().size());
    for (size_t i = 0; i < a.clips().size(); ++i) {
        EXPECT_EQ(a.find(a.clips()[i])->frameTime, b.find(b.clips()[i])->frameTime);
        EXPECT_EQ(contentHash(*a.find(a.clips()[i])), contentHash(*b.find(b.clips()[i])));
    }
}

TEST(Bvh, StructureChannelsAndNumbers)
{
    const Folder folder;
    const Imported in = read(folder, hipAndKnee + motion("2", ".25", "1 2 3 400 5 6 7 8 9\n-1 -2 -3 -400 1e2 +6 -0.0 8.125 9\n"));
    EXPECT_TRUE(in.warnings.empty());
    EXPECT_EQ(in.units, "unknown");
    const Scene& s = in.scene;
    const std::vector<NodeId> nodes = s.nodes();
    ASSERT_EQ(nodes.size(), 3u);
    EXPECT_EQ(s.node(nodes[0]).name, "hip");
    EXPECT_EQ(s.node(nodes[1]).name, "left knee");
    EXPECT_EQ(s.node(nodes[1]).local.translation, glm::dvec3(0, -1.5, 0));
    EXPECT_EQ(s.node(nodes[1]).joint, Node::Joint::Joint);
    EXPECT_EQ(s.node(nodes[2]).joint, Node::Joint::EndSite);
    const Clip& c = clipOf(in);
    EXPECT_EQ(c.name, "a");
    EXPECT_EQ(c.frameTime, 0.25);
    ASSERT_EQ(c.channels.size(), 9u);
    const Path paths[] = {Path::PositionX, Path::PositionY, Path::PositionZ, Path::EulerZ, Path::EulerX,
                          Path::EulerY,    Path::EulerZ,    Path::EulerX,    Path::EulerY};
    for (size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(c.channels[i]->path, paths[i]);
        EXPECT_EQ(c.channels[i]->node, nodes[i < 6 ? 0 : 1]);
        EXPECT_EQ(c.channels[i]->times.id(), c.channels[0]->times.id()) << "one array of times";
    }
    EXPECT_EQ(valuesOf(*c.channels[3]), (std::vector<double>{400, -400})) << "angles are not wrapped";
    EXPECT_EQ(valuesOf(*c.channels[4]), (std::vector<double>{5, 100}));
    EXPECT_TRUE(std::signbit(c.channels[6]->values[1]));
}

TEST(Bvh, OddButUnderstood)
{
    const Folder folder;
    // Keywords in any case, a brace in the line of its name, no channels, CR LF, several roots, rows spread over lines.
    const Imported in =
        read(folder,
             "hierarchy\r\nroot a {\r\noffset 1 2 3\r\nchannels 1 YROTATION\r\nend site { offset 0 1 0 } }\r\nROOT b\r\n{\r\nOFFSET 0 0 0\r\n"
             "CHANNELS 2 Zposition Xrotation\r\nJOINT c\r\n{\r\nOFFSET 0 0 1\r\n}\r\n}\r\nMotion\r\nFrames:2 \r\nframe time : 0.5\r\n1 2\r\n3\r\n4 "
             "5\r\n6\r\n");
    EXPECT_EQ(in.scene.roots().size(), 2u);
    EXPECT_TRUE(warning(in.warnings, "several-roots"));
    const Clip& c = clipOf(in);
    ASSERT_EQ(c.channels.size(), 3u);
    EXPECT_EQ(valuesOf(*c.channels[2]), (std::vector<double>{3, 6}));
    writeFile(in.scene, folder.path / "a.bvh");
    expectEqual(readFile(folder.path / "a.bvh").scene, in.scene);
}

TEST(Bvh, RowsThatAreThereCount)
{
    const Folder folder;
    const std::string row = "0 0 0 1 2 3 4 5 6\n";
    for (const char* frames : {"1", "3", "4000000000", "99999999999999999999999999", "-5", "nan", "many", "0"}) {
        const Imported in = read(folder, hipAndKnee + motion(frames, "0.1", row + "\n" + row));
        EXPECT_EQ(clipOf(in).channels[0]->keys(), 2u) << frames;
        EXPECT_TRUE(warning(in.warnings, "frame-count")) << frames;
    }
    for (const char* time : {"0", "-1", "nan", "inf", "soon", "1e300"}) {
        const Imported in = read(folder, hipAndKnee + motion("2", time, row + row));
        EXPECT_EQ(clipOf(in).frameTime, 1.0 / 30) << time;
        EXPECT_TRUE(warning(in.warnings, "frame-time")) << time;
    }
    const Imported odd = read(folder, hipAndKnee + motion("3", "0.1", row + "1 2 3\n" + "9 0 0 nan 2 3 4 5 inf\n"));
    EXPECT_TRUE(warning(odd.warnings, "broken-row"));
    EXPECT_TRUE(warning(odd.warnings, "nan-value"));
    EXPECT_EQ(valuesOf(*clipOf(odd).channels[0]), (std::vector<double>{0, 9}));
    EXPECT_EQ(valuesOf(*clipOf(odd).channels[3]), (std::vector<double>{1, 1})) << "held";
    EXPECT_EQ(valuesOf(*clipOf(odd).channels[8]), (std::vector<double>{6, 6}));
    for (const std::string& text : {hipAndKnee, hipAndKnee + motion("0", "0.1", "")}) {
        const Imported still = read(folder, text);
        EXPECT_TRUE(still.scene.clips().empty());
        EXPECT_EQ(still.scene.nodes().size(), 3u);
        EXPECT_TRUE(warning(still.warnings, "no-motion"));
    }
}

TEST(Bvh, ErrorsNameLineAndRemedy)
{
    expectIn(readError(""), "HIERARCHY");
    expectIn(readError("HIERARCHX\nROOT a"), "line 1");
    expectIn(readError("HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n CHANNELS 3 Xrotation Yro"), "line 5: 'Yro' is no channel");
    expectIn(readError("HIERARCHY\nROOT hip\n{\n OFFSET 0 0"), "cut off");
    expectIn(readError("HIERARCHY\nROOT hip\n{\n OFFSET 0 0,5 1"), "line 4: '0,5' stands where a number");
    std::string unbalanced = hipAndKnee;
    unbalanced.erase(unbalanced.rfind('}'));
    expectIn(readError(unbalanced + motion("1", "1", "0 0 0 0 0 0 0 0 0\n")), "brace");
    expectIn(readError(hipAndKnee + motion("1", "1", "0 0 0 0 0 0 0 0 0,5\n")), "line 19: '0,5' is no number");
    expectIn(readError(hipAndKnee + motion("2", "1", "0 0 0 1 2\n0 0 0 1 2\n")), "9 channels");
    expectIn(readError("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nEnd Site\n{\nOFFSET 0 0 0\nJOINT b\n{\n"), "line 8");
}

// A comma as decimal mark of the system changes nothing.
TEST(Bvh, IndependentOfTheLocale)
{
    const Folder folder;
    const char* found = nullptr;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
        if (!found) found = std::setlocale(LC_ALL, name);
    const Imported in = read(folder, hipAndKnee + motion("1", "0.25", "0.5 0 0 0 0 0 0 0 1.25\n"));
    writeFile(in.scene, folder.path / "b.bvh");
    const std::string text = bytesOf(folder.path / "b.bvh");
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(clipOf(in).frameTime, 0.25);
    EXPECT_EQ(clipOf(in).channels[8]->values[0], 1.25);
    expectIn(text, "Frame Time: 0.25\n0.5 0 0 0 0 0 0 0 1.25\n");
}

TEST(Bvh, DeepAndWideHierarchies)
{
    const Folder folder;
    const int depth = 100000;
    std::string deep = "HIERARCHY\n", wide = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
    for (int i = 0; i < depth; ++i) {
        deep += std::string(i ? "JOINT" : "ROOT") + " j\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n";
        wide += "JOINT j\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n}\n";
    }
    deep += std::string(size_t(depth), '}');
    wide += "}";
    std::string row = "\nMOTION\nFrames: 1\nFrame Time: 1\n";
    for (int i = 0; i < depth; ++i) row += "0 ";
    for (const std::string& text : {deep + row, wide + row}) {
        const Imported in = read(folder, text);
        EXPECT_GE(in.scene.nodes().size(), size_t(depth));
        writeFile(in.scene, folder.path / "a.bvh");
        EXPECT_LT(fs::file_size(folder.path / "a.bvh"), size_t(depth) * 400);
        expectEqual(readFile(folder.path / "a.bvh").scene, in.scene);
    }
    std::string endless = "HIERARCHY\nROOT r {";
    for (int i = 0; i < 300000; ++i) endless += "JOINT j{";
    expectIn(readError(endless), "more than 262144 joints");
}

TEST(Bvh, CutAndMutated)
{
    const Folder folder;
    const std::string text = hipAndKnee + motion("2", "0.1", "0 0 0 10 20 30 1 2 3\n0 0 0 10 20 30 1 2 3\n");
    const auto expectSound = [&](const std::string& bytes) {
        try {
            const Imported in = read(folder, bytes);
            for (const NodeId n : in.scene.nodes()) EXPECT_TRUE(std::isfinite(glm::length(in.scene.node(n).local.translation)));
            for (const ClipId id : in.scene.clips())
                for (const auto& c : in.scene.find(id)->channels) {
                    EXPECT_EQ(c->values.size(), c->keys());
                    for (const double v : c->values) EXPECT_TRUE(std::isfinite(v));
                }
            writeFile(in.scene, folder.path / "b.bvh");
        } catch (const Error& e) {
            EXPECT_FALSE(e.reason().empty());
        }
    };
    for (size_t n = 0; n < text.size(); ++n) expectSound(text.substr(0, n));
    std::mt19937 random(7);
    const std::string_view pieces[] = {"{",         "}",        "\n",         "9999999999", "nan", "1e999", "-",
                                       "JOINT x {", "End Site", "CHANNELS 3", "MOTION\n",   " ",   ":"};
    for (int i = 0; i < 3000; ++i) {
        std::string mutated = text;
        for (unsigned k = 1 + random() % 4; k > 0; --k) {
            const size_t at = random() % mutated.size();
            if (random() % 2)
                mutated.insert(at, pieces[random() % std::size(pieces)]);
            else
                mutated.erase(at, 1 + random() % 8);
        }
        expectSound(mutated);
    }
}

TEST(Bvh, BrokenFilesOfTheDataSet)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"empty", "wrong_magic", "truncated_hierarchy", "unbalanced_braces", "unknown_channel", "too_few_values"}) {
        const fs::path file = data / "malformed" / (std::string(name) + ".bvh");
        expectIn(errorOf([&] { readFile(file); }), file.string() + ": line ");
    }
    const std::pair<const char*, const char*> warned[] = {{"truncated_motion", "broken-row"}, {"huge_frames", "frame-count"},
                                                          {"zero_frames", "no-motion"},       {"nan_values", "nan-value"},
                                                          {"zero_frame_time", "frame-time"},  {"no_motion", "no-motion"}};
    for (const auto& [name, code] : warned) {
        const Imported in = readFile(data / "malformed" / (std::string(name) + ".bvh"));
        EXPECT_TRUE(warning(in.warnings, code)) << name;
        EXPECT_EQ(in.scene.nodes().size(), 3u) << name;
    }
}

/// World places of all nodes of a name, at a time of the scene's first clip.
std::map<std::string, glm::dvec3> placesAt(const Scene& s, double time)
{
    std::map<std::string, glm::dvec3> places;
    const auto worlds = worldMatrices(s, poseAt(s, *s.find(s.clips().at(0)), time));
    for (const NodeId n : s.nodes())
        if (s.node(n).joint != Node::Joint::No) places[s.node(n).name] = worlds.at(n)[3];
    return places;
}

// Quaternions, a scaled and turned parent, a rest rotation, a moving joint and scale: every joint stands where it stood, and angles do not jump.
TEST(Bvh, OtherMotionBecomesAngles)
{
    Scene s;
    Node holder;
    holder.local.translation = {1, 2, 3};
    holder.local.rotation = glm::angleAxis(-1.5707963267948966, glm::dvec3(1, 0, 0));
    holder.local.scale = glm::dvec3(0.01);
    const NodeId h = s.add(holder);
    const auto joint = [&](const char* name, NodeId parent, glm::dvec3 at) {
        Node n;
        n.name = name;
        n.local.translation = at;
        n.local.rotation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 1, 0)));
        n.joint = Node::Joint::Joint;
        return s.add(n, parent);
    };
    const NodeId hip = joint("the hip", h, {0, 0, 90}), knee = joint("knee", hip, {0, 5, -40}), foot = joint("foot", knee, {0, 0, -45});
    joint("toe", foot, {0, 10, 0});
    Clip clip;
    clip.name = "turns";
    const auto add = [&](NodeId node, Path path, int components, Channel::Interpolation how, Array<double> times, Array<double> values) {
        Channel c;
        c.node = node;
        c.path = path;
        c.components = components;
        c.interpolation = how;
        c.times = std::move(times);
        c.values = std::move(values);
        clip.channels.push_back(std::make_shared<const Channel>(std::move(c)));
    };
    // Two and a half turns about a slanted axis, through gimbal lock and over the seam of 180 degrees.
    Array<double> times, turns;
    for (int i = 0; i <= 40; ++i) {
        const glm::dquat q = glm::angleAxis(i * 0.39, glm::normalize(glm::dvec3(3, 1, -0.5)));
        times.push_back(i * 0.05);
        turns.insert(turns.end(), {q.x, q.y, q.z, q.w});
    }
    add(hip, Path::Rotation, 4, Channel::Interpolation::Linear, times, turns);
    add(hip, Path::Translation, 3, Channel::Interpolation::Linear, {0, 2}, {0, 0, 90, 100, 0, 120});
    add(knee, Path::Rotation, 4, Channel::Interpolation::Linear, {0, 2}, {1, 0, 0, 0, 0, 0.6, 0, 0.8});
    add(foot, Path::Translation, 3, Channel::Interpolation::Linear, {0, 2}, {0, 0, -45, 0, 10, -45});
    add(knee, Path::Scale, 3, Channel::Interpolation::Linear, {0, 2}, {1, 1, 1, 2, 2, 2});
    s.add(clip);

    const Folder folder;
    const std::vector<Warning> lost = writeFile(s, folder.path / "a.bvh");
    EXPECT_TRUE(warning(lost, "scale-lost"));
    const Imported back = readFile(folder.path / "a.bvh");
    EXPECT_TRUE(back.warnings.empty());
    EXPECT_EQ(clipOf(back).frameTime, 1.0 / 30);
    EXPECT_EQ(clipOf(back).channels[0]->keys(), 61u);
    for (int f = 0; f <= 60; ++f) {
        const auto before = placesAt(s, f / 30.0), after = placesAt(back.scene, f / 30.0);
        ASSERT_EQ(after.size(), before.size() + 1) << "and an end site";
        for (const auto& [name, place] : before) {
            const std::string written = name == "the hip" ? "the_hip" : name;
            EXPECT_LE(glm::length(after.at(written) - place), 1e-9) << name << " in frame " << f;
        }
    }
    for (const auto& c : clipOf(back).channels)
        if (c->path >= Path::EulerX) {
            for (size_t i = 1; i < c->keys(); ++i) EXPECT_LT(std::abs(c->values[i] - c->values[i - 1]), 120) << "a jump at frame " << i;
        }
}

TEST(Bvh, NothingToWrite)
{
    const Folder folder;
    expectIn(errorOf([&] { writeFile(Scene(), folder.path / "a.bvh"); }), "no skeleton");
    EXPECT_FALSE(fs::exists(folder.path / "a.bvh"));
}

TEST(Bvh, ARestingSkeletonIsOneFrame)
{
    const Folder folder;
    const Imported in = read(folder, hipAndKnee);
    writeFile(in.scene, folder.path / "b.bvh");
    const Imported back = readFile(folder.path / "b.bvh");
    EXPECT_TRUE(back.warnings.empty());
    EXPECT_EQ(clipOf(back).channels.size(), 9u);
    EXPECT_EQ(clipOf(back).channels[0]->keys(), 1u);
}

}  // namespace
}  // namespace mw::test
