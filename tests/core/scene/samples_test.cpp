// The scenes that come with the program are what their lines say, and are there at once.
#include "core/scene/samples.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <gtest/gtest.h>

#include "core/mesh/topology.h"
#include "core/repair/defects.h"

namespace mw {
namespace {

const Mesh& baseOf(const Scene& s, size_t i = 0)
{
    return s.find(s.meshes().at(i))->base;
}

TEST(Samples, AreMadeInNoTimeAndTheSameAgain)
{
    for (const Sample& s : samples()) {
        const auto start = std::chrono::steady_clock::now();
        const Scene scene = s.make();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_LT(seconds, 20) << s.id;  // a tenth of a second each when nothing is instrumented and nobody else is running
        EXPECT_EQ(contentHash(scene), contentHash(sampleScene(s.id))) << s.id;
        EXPECT_FALSE(scene.nodes().empty()) << s.id;
    }
    EXPECT_THROW(sampleScene("teapot"), Error);
}

TEST(Samples, RockIsAScan)
{
    const Scene s = rockScene();
    const TopologyReport& r = baseOf(s).topology();
    EXPECT_EQ(r.boundaryLoops.size(), 5u);
    EXPECT_GT(r.isolatedVertices.size(), 1000u);
    EXPECT_TRUE(r.manifold() && r.consistentlyOriented);
    EXPECT_EQ(r.genus, 0);
}

TEST(Samples, DogIsClosedAndSymmetric)
{
    const Scene s = quadrupedScene();
    const Mesh& m = baseOf(s);
    EXPECT_EQ(m.topology().genus, 0);
    EXPECT_TRUE(m.topology().closed && m.topology().manifold());
    EXPECT_GT(enclosedVolume(m), 0.02);
    std::vector<std::array<float, 3>> left, right;
    for (const glm::vec3& p : m.positions()) {
        left.push_back({p.x, p.y, p.z});
        right.push_back({p.x == 0 ? p.x : -p.x, p.y, p.z});
    }
    std::sort(left.begin(), left.end());
    std::sort(right.begin(), right.end());
    EXPECT_EQ(left, right);
}

TEST(Samples, GearsHaveAHoleForTheAxleAndOneBetweenSpokes)
{
    const Scene s = gearsScene();
    std::vector<long> genus;
    for (const MeshId id : s.meshes()) {
        const TopologyReport& r = s.find(id)->base.topology();
        EXPECT_TRUE(r.closed && r.manifold() && r.consistentlyOriented);
        EXPECT_GT(enclosedVolume(s.find(id)->base), 0);
        genus.push_back(r.genus.value_or(-1));
    }
    EXPECT_EQ(genus, (std::vector<long>{7, 5, 6}));
}

TEST(Samples, BrokenPearHasOneOfEverything)
{
    const Scene s = brokenScene();
    const TopologyReport& r = baseOf(s).topology();
    EXPECT_GE(r.boundaryLoops.size(), 2u);
    EXPECT_FALSE(r.nonmanifoldEdges.empty() || r.nonmanifoldVertices.empty() || r.inconsistentEdges.empty());
    EXPECT_EQ(r.degenerateFaces.size(), 3u);
    EXPECT_EQ(r.duplicateFaces.size(), 4u);
    EXPECT_GE(r.isolatedVertices.size(), 12u);
    for (const Defect& d : defectsOf(baseOf(s))) EXPECT_FALSE(d.passed()) << d.id;
}

}  // namespace
}  // namespace mw
