// Every BVH file of the data set against an evaluation written here from the format's definition: a row gives each joint, in the order of the file,
// the numbers of its channels; a joint stands at parent * T(offset) * T(positions) * R(first angle) * R(second) * R(third).
#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>
#include <unistd.h>

#include "core/io/io.h"
#include "core/scene/scene_pose.h"

#include "data.h"

namespace mw::test {
namespace {

namespace fs = std::filesystem;

struct PlainJoint {
    std::string name;
    int parent = -1;
    glm::dvec3 offset{0};
    std::vector<std::string> channels;
};

/// The words of a file, understood just so far as well-formed files need.
struct PlainBvh {
    std::vector<PlainJoint> joints;
    std::vector<std::vector<double>> rows;
    std::vector<std::string> words;  ///< of the whole file, numbers as text
    double frameTime = 0;

    explicit PlainBvh(const fs::path& file)
    {
        std::ifstream in(file);
        std::string word;
        std::vector<int> open;
        size_t channels = 0;
        while (in >> word && word != "MOTION") {
            if (word == "ROOT" || word == "JOINT" || word == "End") {
                PlainJoint j;
                in >> j.name;
                if (word == "End") j.name = "End " + j.name;
                j.parent = open.empty() ? -1 : open.back();
                open.push_back(int(joints.size()));
                joints.push_back(j);
            } else if (word == "OFFSET") {
                for (int i = 0; i < 3; ++i) in >> joints[size_t(open.back())].offset[i];
            } else if (word == "CHANNELS") {
                size_t n = 0;
                in >> n;
                channels += n;
                for (; n > 0; --n) joints[size_t(open.back())].channels.emplace_back(), in >> joints[size_t(open.back())].channels.back();
            } else if (word == "}") {
                open.pop_back();
            }
        }
        std::string frames, time;
        in >> word >> frames >> word >> word >> time;
        frameTime = std::stod(time);
        std::vector<double> row;
        for (double v = 0; in >> v;) {
            row.push_back(v);
            if (row.size() == channels) rows.push_back(std::move(row)), row.clear();
        }
        EXPECT_TRUE(row.empty());
    }

    std::vector<glm::dmat4> worlds(size_t frame) const
    {
        std::vector<glm::dmat4> all;
        size_t column = 0;
        for (const PlainJoint& j : joints) {
            glm::dmat4 positions(1), turns(1);
            for (const std::string& c : j.channels) {
                const double v = rows[frame][column++];
                const glm::dvec3 axis(c[0] == 'X', c[0] == 'Y', c[0] == 'Z');
                if (c.substr(1) == "position")
                    positions = glm::translate(positions, v * axis);
                else
                    turns = turns * glm::rotate(glm::dmat4(1), glm::radians(v), axis);
            }
            const glm::dmat4 local = glm::translate(glm::dmat4(1), j.offset) * positions * turns;
            all.push_back(j.parent < 0 ? local : all[size_t(j.parent)] * local);
        }
        return all;
    }

    double height() const
    {
        double low = 0, high = 0;
        std::vector<double> y;
        for (const PlainJoint& j : joints) {
            y.push_back((j.parent < 0 ? 0 : y[size_t(j.parent)]) + j.offset.y);
            low = std::min(low, y.back());
            high = std::max(high, y.back());
        }
        return std::max(high - low, 1.0);
    }
};

std::vector<fs::path> files(const fs::path& data)
{
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(data / "bvh"))
        if (entry.path().extension() == ".bvh") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

/// A file that is gone with the object.
struct Temporary {
    fs::path path = fs::temp_directory_path() / ("meshwright-" + std::to_string(::getpid()) + ".bvh");
    ~Temporary()
    {
        std::error_code e;
        fs::remove(path, e);
    }
};

TEST(BvhProof, JointsStandWhereTheDefinitionSays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t checked = 0;
    for (const fs::path& file : files(data)) {
        SCOPED_TRACE(file.filename());
        const PlainBvh plain(file);
        const Imported in = readFile(file);
        const std::vector<NodeId> nodes = in.scene.nodes();
        ASSERT_EQ(nodes.size(), plain.joints.size());
        const Clip& clip = *in.scene.find(in.scene.clips().at(0));
        EXPECT_EQ(clip.frameTime, plain.frameTime);
        ASSERT_EQ(clip.channels[0]->keys(), plain.rows.size());
        const double tolerance = 1e-4 * plain.height();
        const size_t last = plain.rows.size() - 1, step = std::max<size_t>(1, last / 23);
        for (size_t f = 0; f <= last; f += (f < last && f + step > last) ? last - f : step) {
            const std::vector<glm::dmat4> expected = plain.worlds(f);
            const auto worlds = worldMatrices(in.scene, poseAt(in.scene, clip, double(f) * plain.frameTime));
            for (size_t j = 0; j < nodes.size(); ++j) {
                EXPECT_EQ(in.scene.node(nodes[j]).name, plain.joints[j].name);
                const glm::dvec3 off = glm::dvec3(worlds.at(nodes[j])[3] - expected[j][3]);
                EXPECT_LE(glm::length(off), tolerance) << plain.joints[j].name << " in frame " << f;
                // Orientations, too: the tips of unit axes.
                for (int axis = 0; axis < 3; ++axis) EXPECT_LE(glm::length(worlds.at(nodes[j])[axis] - expected[j][axis]), 1e-9);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 3000u);
}

TEST(BvhProof, WrittenBackEqual)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const fs::path& file : files(data)) {
        SCOPED_TRACE(file.filename());
        const Imported first = readFile(file);
        const Temporary copy;
        EXPECT_TRUE(writeFile(first.scene, copy.path).empty()) << "nothing is lost";
        const Imported second = readFile(copy.path);
        EXPECT_TRUE(second.warnings.empty());
        Scene renamed = second.scene;  // a clip is named as its file
        Clip clip = *renamed.find(renamed.clips().at(0));
        clip.name = file.stem().string();
        renamed.set(renamed.clips().at(0), clip);
        EXPECT_EQ(contentHash(renamed), contentHash(first.scene));

        const PlainBvh a(file), b(copy.path);  // and seen by another reader: numbers to the last bit, names, order of channels
        EXPECT_EQ(a.rows, b.rows);
        EXPECT_EQ(a.frameTime, b.frameTime);
        ASSERT_EQ(a.joints.size(), b.joints.size());
        for (size_t j = 0; j < a.joints.size(); ++j) {
            EXPECT_EQ(a.joints[j].name, b.joints[j].name);
            EXPECT_EQ(a.joints[j].parent, b.joints[j].parent);
            EXPECT_EQ(a.joints[j].offset, b.joints[j].offset);
            EXPECT_EQ(a.joints[j].channels, b.joints[j].channels);
        }
    }
}

}  // namespace
}  // namespace mw::test
