// The characters of the data set: what is in them, and where every corner is at ten times of every motion.
#include <glm/geometric.hpp>
#include <set>

#include "app/importer/read.h"
#include "core/io/foreign.h"
#include "core/scene/scene_pose.h"

#include "assimp_pose.h"
#include "data.h"

using namespace mw;

namespace {

struct Expected {
    const char* file;
    size_t meshes, splitVertices, faces, bones, weights, materials, images;
    std::vector<std::pair<const char*, double>> clips;  ///< name, the time of the last key
    double metres;                                      ///< one unit of the file
};

// From the table of the data set, counted there by another program.
const std::vector<Expected>& expected()
{
    static const std::vector<Expected> all{
        {"pab_arnaud.fbx", 1, 20010, 6670, 53, 5, 1, 0, {}, 0.01},
        {"pab_walk.fbx", 0, 0, 0, 0, 0, 0, 0, {{"walk", 1.333}}, 0.01},
        {"pab_run.fbx", 0, 0, 0, 0, 0, 0, 0, {{"run", 0.667}}, 0.01},
        {"animation_with_skeleton.fbx", 1, 4224, 1056, 14, 6, 1, 0, {{"Armature|ArmatureAction", 0.833}}, 0.01},
        {"BCN_Epileptic.X", 3, 15378, 5126, 54, 3, 1, 0, {{"Epileptisch", 3.3}}, 1},
        {"Testwuson.X", 1, 11196, 3732, 37, 4, 1, 0, {{"Wuson_Run", 0.967}, {"Wuson_Walk", 3.6}, {"Wuson_Bind", 0}}, 1},
        {"anim_test.x", 1, 2520, 840, 4, 4, 1, 0, {{"cylinder_test", 1}}, 1},
        {"bob/Bob.md5mesh", 6, 3081, 1027, 32, 4, 6, 5, {{"Bob", 5.792}}, 1},
        {"bob/Bob.md5anim", 0, 0, 0, 0, 0, 0, 0, {{"Bob", 5.792}}, 1},
    };
    return all;
}

std::set<NodeId> boundJoints(const Scene& s)
{
    std::set<NodeId> joints;
    for (const SkinId id : s.skins()) joints.insert(s.find(id)->joints.begin(), s.find(id)->joints.end());
    return joints;
}

size_t mostWeights(const Mesh& m)
{
    const Attribute* w = m.find(names::weights);
    size_t most = 0;
    for (size_t v = 0; w && v < m.vertexCount(); ++v) {
        size_t n = 0;
        for (int k = 0; k < w->components; ++k) n += w->at(v, k) != 0;
        most = std::max(most, n);
    }
    return most;
}

void checkCounts(const Scene& s, const Expected& e)
{
    size_t vertices = 0, faces = 0, weights = 0;
    for (const MeshId id : s.meshes()) {
        const Mesh& m = s.find(id)->base;
        vertices += m.vertexCount();
        faces += m.faceCount();
        weights = std::max(weights, mostWeights(m));
    }
    EXPECT_EQ(s.meshes().size(), e.meshes);
    EXPECT_LE(vertices, e.splitVertices);
    EXPECT_EQ(faces, e.faces);
    EXPECT_EQ(weights, e.weights);
    EXPECT_EQ(boundJoints(s).size(), e.bones);
    EXPECT_EQ(s.materials().size(), e.materials);
    EXPECT_EQ(s.images().size(), e.images);
    ASSERT_EQ(s.clips().size(), e.clips.size());
    for (size_t i = 0; i < e.clips.size(); ++i) {
        EXPECT_EQ(s.find(s.clips()[i])->name, e.clips[i].first);
        EXPECT_NEAR(duration(*s.find(s.clips()[i])), e.clips[i].second, 5e-4);
    }
}

// Corners in the order of nodes: Assimp's order of faces and corners is kept.
std::vector<glm::dvec3> cornersOf(const Scene& s, const ScenePose& pose)
{
    const auto worlds = worldMatrices(s, pose);
    std::vector<glm::dvec3> all;
    for (const NodeId id : s.nodes()) {
        if (!s.node(id).mesh) continue;
        const Mesh& rest = s.find(s.node(id).mesh)->base;
        const auto how = meshPose(s, id, rest, pose, worlds);
        const Mesh m = how ? posed(rest, *how) : rest;
        const glm::dmat4 place = worldFromMesh(s, id, worlds);
        for (const uint32_t v : m.cornerVertex()) all.push_back(glm::dvec3(place * glm::dvec4(m.positions()[v], 1)));
    }
    return all;
}

double worstDistance(const std::vector<glm::dvec3>& ours, const std::vector<aiVector3D>& theirs, double metres)
{
    double worst = 0;
    for (size_t i = 0; i < ours.size(); ++i)
        worst = std::max(worst, glm::distance(ours[i], metres * glm::dvec3(theirs[i].x, theirs[i].y, theirs[i].z)));
    return worst;
}

double sizeOf(const std::vector<glm::dvec3>& points)
{
    Bounds b;
    for (const glm::dvec3& p : points) b.add(p);
    return b.diagonal();
}

class Characters : public ::testing::TestWithParam<size_t> {
protected:
    const Expected& e() const { return expected()[GetParam()]; }
};

TEST_P(Characters, HasWhatTheTableSays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readByAssimp(data / "characters" / e().file);
    checkCounts(in.scene, e());
    EXPECT_EQ(in.units, e().metres == 1 ? "unknown" : "centimetres");
    EXPECT_EQ(in.placement.metresPerUnit, e().metres);
    EXPECT_EQ(in.placementFromFile, e().metres != 1);
    EXPECT_FALSE(in.format.empty());
    EXPECT_FALSE(skeletonRoots(in.scene).empty());
}

TEST_P(Characters, StandsWhereAssimpPutsIt)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Scene s = readByAssimp(data / "characters" / e().file).scene;
    Assimp::Importer importer;
    const aiScene* plain = test::readPlainly(importer, (data / "characters" / e().file).string());
    ASSERT_TRUE(plain);
    const std::vector<glm::dvec3> rest = cornersOf(s, {});
    if (rest.empty()) GTEST_SKIP() << "motions alone; Assimp draws those of MD5 as a mesh";
    const std::vector<aiVector3D> theirs = test::AssimpPose(*plain, nullptr, 0).corners();
    ASSERT_EQ(rest.size(), theirs.size());
    EXPECT_LE(worstDistance(rest, theirs, e().metres), 1e-4 * sizeOf(rest));
    for (size_t c = 0; c < s.clips().size(); ++c) {
        const aiAnimation& a = *plain->mAnimations[c];
        for (int i = 0; i < 10; ++i) {
            const double seconds = duration(*s.find(s.clips()[c])) * i / 9;
            const std::vector<glm::dvec3> ours = cornersOf(s, poseAt(s, *s.find(s.clips()[c]), seconds));
            EXPECT_LE(worstDistance(ours, test::AssimpPose(*plain, &a, seconds * a.mTicksPerSecond).corners(), e().metres), 1e-4 * sizeOf(rest))
                << a.mName.C_Str() << " at " << seconds;
        }
    }
}

// Motions without a mesh: every node at ten times.
TEST_P(Characters, NodesMoveAsAssimpSays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Scene s = readByAssimp(data / "characters" / e().file).scene;
    Assimp::Importer importer;
    const aiScene* plain = test::readPlainly(importer, (data / "characters" / e().file).string());
    ASSERT_TRUE(plain);
    for (size_t c = 0; c < s.clips().size(); ++c)
        for (int i = 0; i < 10; ++i) {
            const aiAnimation& a = *plain->mAnimations[c];
            const double seconds = duration(*s.find(s.clips()[c])) * i / 9;
            const test::AssimpPose theirs(*plain, &a, seconds * a.mTicksPerSecond);
            double worst = 0, size = 0;
            for (const auto& [id, world] : worldMatrices(s, poseAt(s, *s.find(s.clips()[c]), seconds))) {
                const aiNode* node = plain->mRootNode->FindNode(s.node(id).name.c_str());
                if (!node) continue;
                const aiMatrix4x4& m = theirs.world(*node);
                worst = std::max(worst, glm::distance(glm::dvec3(world[3]), e().metres * glm::dvec3(m.a4, m.b4, m.c4)));
                size = std::max(size, glm::length(glm::dvec3(world[3])));
            }
            EXPECT_LE(worst, 1e-4 * size) << a.mName.C_Str() << " at " << seconds;
        }
}

TEST_P(Characters, NoTwoVerticesAreTheSame)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Scene s = readByAssimp(data / "characters" / e().file).scene;
    for (const MeshId id : s.meshes()) {
        const Mesh& m = s.find(id)->base;
        std::set<std::vector<double>> seen;
        const Attribute *joints = m.find(names::joints), *weights = m.find(names::weights);
        for (size_t v = 0; v < m.vertexCount(); ++v) {
            std::vector<double> key{double(m.positions()[v].x), double(m.positions()[v].y), double(m.positions()[v].z)};
            double sum = 0;
            for (int k = 0; weights && k < weights->components; ++k) {
                key.push_back(joints->at(v, k));
                key.push_back(weights->at(v, k));
                sum += key.back();
            }
            EXPECT_TRUE(seen.insert(key).second);
            if (weights) {
                EXPECT_NEAR(sum, 1, 1e-5);
            }
        }
    }
}

// The same through the program, the pipe and the project file.
TEST_P(Characters, ArrivesInTheEditor)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported direct = readByAssimp(data / "characters" / e().file), piped = readForeign(data / "characters" / e().file);
    EXPECT_EQ(contentHash(piped.scene), contentHash(direct.scene));
    EXPECT_EQ(piped.format, direct.format);
    EXPECT_EQ(piped.units, direct.units);
    EXPECT_EQ(piped.warnings.size(), direct.warnings.size());
}

INSTANTIATE_TEST_SUITE_P(Files, Characters, ::testing::Range<size_t>(0, 9), [](const auto& tested) {
    std::string name = expected()[tested.param].file;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
});

TEST(Malformed, EveryForeignFileIsRefusedWithAReason)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "malformed")) {
        if (!isForeign(entry.path().extension().string())) continue;
        ++files;
        try {
            readForeign(entry.path());
            ADD_FAILURE() << entry.path() << " was read";
        } catch (const Error& e) {
            EXPECT_EQ(e.file(), entry.path().string());
            EXPECT_GT(e.reason().size(), 30u) << e.what();
        }
    }
    EXPECT_EQ(files, 5u);
}

}  // namespace
