// The mannequin: a sound body, weights that hold together, feet that stand.
#include "core/character/mannequin.h"

#include <array>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/io/io.h"
#include "core/mesh/topology.h"
#include "core/scene/samples.h"
#include "core/scene/scene_pose.h"

using namespace mw;

namespace {

const Mannequin& figure()
{
    static const Mannequin m = mannequin();
    return m;
}
const Scene& scene()
{
    static const Scene s = sampleScene("mannequin");
    return s;
}

std::array<float, 3> key(const glm::vec3& p)
{
    return {p.x + 0.f, p.y, p.z};
}
/// For each vertex the one on the other side.
std::vector<uint32_t> mirrored(const Mesh& m)
{
    std::map<std::array<float, 3>, uint32_t> at;
    for (uint32_t v = 0; v < m.vertexCount(); ++v) at[key(m.positions()[v])] = v;
    std::vector<uint32_t> other;
    for (const glm::vec3& p : m.positions()) {
        const auto found = at.find(key({-p.x, p.y, p.z}));
        other.push_back(found == at.end() ? none : found->second);
    }
    return other;
}
uint32_t joint(const std::string& name)
{
    for (uint32_t j = 0; j < figure().skeleton.joints.size(); ++j)
        if (figure().skeleton.joints[j].name == name) return j;
    ADD_FAILURE() << name;
    return 0;
}
std::string otherSide(const std::string& name)
{
    if (name.starts_with("Left")) return "Right" + name.substr(4);
    if (name.starts_with("Right")) return "Left" + name.substr(5);
    return name;
}

const Clip& clip(const std::string& name)
{
    for (const ClipId id : scene().clips())
        if (scene().find(id)->name == name) return *scene().find(id);
    throw Error("no clip " + name);
}
Mesh bodyAt(const std::string& name, double time)
{
    const ScenePose pose = poseAt(scene(), clip(name), time);
    const auto worlds = worldMatrices(scene(), pose);
    for (const NodeId id : scene().nodes())
        if (scene().node(id).mesh) {
            const Mesh& rest = scene().find(scene().node(id).mesh)->base;
            return posed(rest, *meshPose(scene(), id, rest, pose, worlds));
        }
    return {};
}

TEST(Mannequin, BodyIsOneClosedSkin)
{
    const Mesh& m = figure().mesh;
    const TopologyReport& r = m.topology();
    EXPECT_TRUE(r.closed);
    EXPECT_TRUE(r.manifold());
    EXPECT_TRUE(r.consistentlyOriented);
    EXPECT_EQ(r.components, 1u);
    ASSERT_TRUE(r.genus.has_value());
    EXPECT_EQ(*r.genus, 0);
    EXPECT_TRUE(r.degenerateFaces.empty());
    EXPECT_GT(r.triangles + 2 * m.faceCount(), 12000u);
    EXPECT_LT(m.faceCount(), 8000u);
    EXPECT_NEAR(m.bounds().size().y, 1.75, 0.015);
    EXPECT_NEAR(m.bounds().min.y, 0, 1e-3);
    // A human of this height weighs some 65 kg, about as dense as water.
    EXPECT_NEAR(enclosedVolume(m), 0.06, 0.015);
}

TEST(Mannequin, LeftIsTheMirrorOfRight)
{
    const Mesh& m = figure().mesh;
    const std::vector<uint32_t> other = mirrored(m);
    const Attribute *joints = m.find(names::joints), *weights = m.find(names::weights);
    for (uint32_t v = 0; v < m.vertexCount(); ++v) {
        ASSERT_NE(other[v], none);
        std::map<std::string, double> here, there;
        for (int k = 0; k < 4; ++k) {
            here[figure().skeleton.joints[size_t(joints->at(v, k))].name] += weights->at(v, k);
            there[otherSide(figure().skeleton.joints[size_t(joints->at(other[v], k))].name)] += weights->at(other[v], k);
        }
        for (const auto& [name, w] : here) EXPECT_NEAR(w, there[name], 1e-3) << name;
    }
    for (const Joint& j : figure().skeleton.joints) {
        const glm::dvec3 t = figure().skeleton.joints[joint(otherSide(j.name))].rest.translation;
        EXPECT_EQ(j.rest.translation, t * glm::dvec3(j.name == otherSide(j.name) ? 1 : -1, 1, 1));
    }
}

TEST(Mannequin, WeightsSumToOneAndChangeGently)
{
    const Mesh& m = figure().mesh;
    const Attribute *joints = m.find(names::joints), *weights = m.find(names::weights);
    std::vector<std::vector<double>> dense(m.vertexCount(), std::vector<double>(figure().skeleton.joints.size(), 0));
    for (uint32_t v = 0; v < m.vertexCount(); ++v) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            EXPECT_GE(weights->at(v, k), 0);
            EXPECT_FALSE(figure().skeleton.joints[size_t(joints->at(v, k))].end);
            dense[v][size_t(joints->at(v, k))] += weights->at(v, k);
            sum += weights->at(v, k);
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
    // No step between neighbours: such would be a fold in every pose.
    double steepest = 0;
    for (size_t e = 0; e < m.edges().size(); e += 2)
        for (size_t j = 0; j < dense[0].size(); ++j) steepest = std::max(steepest, std::abs(dense[m.edges()[e]][j] - dense[m.edges()[e + 1]][j]));
    EXPECT_LT(steepest, 0.45);
}

TEST(Mannequin, EveryJointMovesItsPartAlone)
{
    const Mannequin& f = figure();
    for (uint32_t j = 0; j < f.skeleton.joints.size(); ++j) {
        if (f.skeleton.joints[j].end) continue;
        Pose pose{std::make_shared<const Skeleton>(f.skeleton), {}, glm::dmat4(1), {}};
        for (const Joint& each : f.skeleton.joints) pose.locals.push_back(each.rest);
        pose.locals[j].rotation = glm::angleAxis(0.5, glm::normalize(glm::dvec3(1, 0.3, 0.5)));
        MeshPose how;
        const auto worlds = worldMatrices(pose);
        for (size_t i = 0; i < worlds.size(); ++i)
            if (!f.skeleton.joints[i].end) how.joints.emplace_back(worlds[i] * f.inverseBind[i]);
        const Mesh moved = posed(f.mesh, how);
        double most = 0;
        const std::string& name = f.skeleton.joints[j].name;
        const double side = name.starts_with("Left") ? 1 : name.starts_with("Right") ? -1 : 0;
        for (size_t v = 0; v < f.mesh.vertexCount(); ++v) {
            const double d = double(glm::distance(moved.positions()[v], f.mesh.positions()[v]));
            most = std::max(most, d);
            if (side * double(f.mesh.positions()[v].x) < -0.03) {
                EXPECT_LT(d, 0.02) << name << " moves the other side";
            }
        }
        EXPECT_GT(most, 0.02) << name;
    }
}

TEST(Mannequin, StandsOnTheFloorAllTheTime)
{
    for (const std::string name : {"Walk", "Idle"})
        for (int i = 0; i < 60; ++i) {
            const double time = duration(clip(name)) * i / 60;
            EXPECT_NEAR(bodyAt(name, time).bounds().min.y, 0, 0.01) << name << " at " << time;
        }
}

// The floor passes below at the speed of the walk: what touches it goes with it.
TEST(Mannequin, StandingFootDoesNotSlide)
{
    const Mesh& rest = figure().mesh;
    const double period = duration(clip("Walk"));
    const auto check = [&](double from, double to, double backMost, double frontMost) {
        std::map<size_t, std::pair<glm::dvec3, glm::dvec3>> range;
        for (double phase = from; phase <= to; phase += 0.01) {
            const Mesh m = bodyAt("Walk", phase * period);
            for (size_t v = 0; v < rest.vertexCount(); ++v) {
                const glm::vec3& p = rest.positions()[v];
                if (p.x < 0 || p.y > 0.004f || double(p.z) < backMost || double(p.z) > frontMost) continue;
                glm::dvec3 on(m.positions()[v]);
                on.z += mannequinWalkSpeed * phase * period;
                const auto [at, fresh] = range.emplace(v, std::pair(on, on));
                if (fresh) continue;
                at->second.first = glm::min(at->second.first, on);
                at->second.second = glm::max(at->second.second, on);
            }
        }
        EXPECT_GT(range.size(), 5u);
        for (const auto& [v, r] : range) {
            EXPECT_LT(r.second.z - r.first.z, 0.01) << v;
            EXPECT_LT(r.second.x - r.first.x, 0.01) << v;
        }
    };
    check(0.10, 0.34, -1, 1);     // on the whole sole
    check(0.34, 0.60, 0.14, 1);   // on the toes
    check(0.0, 0.10, -1, -0.02);  // over the heel
}

TEST(Mannequin, HalfAPeriodLaterItIsItsMirror)
{
    for (const MannequinMotion& m : figure().motions) {
        if (m.name != "Walk") continue;
        const size_t frames = m.times.size() - 1, half = frames / 2;
        ASSERT_EQ(frames % 2, 0u);
        for (size_t i = 0; i < half; ++i) {
            EXPECT_LT(glm::distance(m.hips[i], m.hips[i + half] * glm::dvec3(-1, 1, 1)), 1e-3);
            for (size_t j = 0; j < m.rotations.size(); ++j) {
                if (m.rotations[j].empty()) continue;
                const glm::dquat a = m.rotations[j][i], b = m.rotations[joint(otherSide(figure().skeleton.joints[j].name))][i + half];
                EXPECT_GT(std::abs(glm::dot(a, glm::dquat(b.w, b.x, -b.y, -b.z))), 1 - 1e-6) << figure().skeleton.joints[j].name;
            }
        }
    }
}

TEST(Mannequin, MotionsClose)
{
    std::set<std::string> names;
    for (const MannequinMotion& m : figure().motions) {
        names.insert(m.name);
        EXPECT_EQ(m.hips.front(), m.hips.back());
        for (const auto& r : m.rotations)
            if (!r.empty()) {
                EXPECT_EQ(r.front(), r.back());
                for (size_t i = 1; i < r.size(); ++i) EXPECT_GT(glm::dot(r[i - 1], r[i]), 0.98);
            }
    }
    EXPECT_EQ(names, (std::set<std::string>{"Idle", "Walk"}));
}

TEST(Samples, AreReadLikeFiles)
{
    const Imported in = readFile("sample:mannequin");
    EXPECT_EQ(in.units, "metres");
    EXPECT_EQ(contentHash(in.scene), contentHash(scene()));
    EXPECT_EQ(in.scene.clips().size(), 2u);
    EXPECT_EQ(skeletonRoots(in.scene).size(), 1u);
    try {
        readFile("sample:nobody");
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(e.reason().find("mannequin"), std::string::npos);
        EXPECT_EQ(e.file(), "sample:nobody");
    }
}

}  // namespace
