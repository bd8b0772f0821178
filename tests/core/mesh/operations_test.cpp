// Operations of this folder and its neighbours: icosphere, strips, valence, weld.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "core/mesh/primitives.h"
#include "core/mesh/stripify.h"
#include "core/mesh/topology.h"
#include "core/metrics/valence.h"
#include "core/repair/weld.h"

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

/// Runs an algorithm to its end.
template <class T, class Start>
T ran(bool watched, const Start& start, size_t* steps = nullptr)
{
    RunOf<T> run(watched, start);
    size_t n = 0;
    while (run.advance()) ++n;
    if (steps) *steps = n;
    return std::any_cast<T>(run.snapshot().value);
}

Mesh weldedBy(const Mesh& m, Weld p = {})
{
    return ran<Mesh>(false, [&](Stage<Mesh>& s) { return weld(m, p, s); });
}

Table strippedBy(const Mesh& m, Stripify p = {}, bool watched = false, size_t* steps = nullptr)
{
    return ran<Table>(
        watched, [&](Stage<Table>& s) { return stripify(m, p, s); }, steps);
}

using Triangle = std::array<uint32_t, 3>;

/// Triangles with the lowest vertex first, orientation kept, sorted.
std::vector<Triangle> canonical(std::span<const uint32_t> indices)
{
    std::vector<Triangle> out;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        Triangle t{indices[i], indices[i + 1], indices[i + 2]}, best = t;
        for (int k = 0; k < 2; ++k) {
            std::rotate(t.begin(), t.begin() + 1, t.end());
            best = std::min(best, t);
        }
        out.push_back(best);
    }
    std::sort(out.begin(), out.end());
    return out;
}

double value(const Table& t, const std::string& name)
{
    for (const auto& [n, v] : t.summary)
        if (n == name) return v;
    ADD_FAILURE() << "no " << name;
    return 0;
}

void expectExactStrips(const Mesh& m, const Table& t)
{
    EXPECT_EQ(canonical(decodeStrips(t.lists[0].second)), canonical(m.triangulation().vertices));
    EXPECT_EQ(value(t, "indices in strips"), double(t.lists[0].second.size()));
    EXPECT_EQ(value(t, "indices in triangle list"), double(m.triangulation().vertices.size()));
    EXPECT_LE(t.lists[0].second.size(), m.triangulation().vertices.size() * 4 / 3);
    const double strips = value(t, "strips");
    for (size_t f = 0; f < m.faceCount(); ++f) {
        if (m.face(f).size() < 3)
            EXPECT_TRUE(std::isnan(t.columns[0].values[f]));
        else
            EXPECT_TRUE(t.columns[0].values[f] >= 0 && t.columns[0].values[f] < strips);
    }
}

/// The cube of the book's Fig. 2.1, in the order of its list.
Mesh bookCube()
{
    Polygons p = cube();
    p.corners = {0, 1, 2, 2, 1, 3, 2, 3, 7, 7, 3, 1, 7, 1, 5, 5, 1, 4, 5, 4, 7, 7, 4, 6, 7, 6, 2, 2, 6, 4, 2, 4, 0, 0, 4, 1};
    return Mesh::triangles(p.positions, p.corners);
}

}  // namespace

TEST(Icosphere, CountsRadiusAndOrientation)
{
    for (const int64_t n : {0, 1, 2, 5}) {
        size_t steps = 0;
        const Mesh m = ran<Mesh>(
            true, [&](Stage<Mesh>& s) { return icosphere({.subdivisions = n, .radius = 2.5}, s); }, &steps);
        EXPECT_EQ(steps, size_t(n));
        const size_t power = size_t(1) << 2 * n;
        EXPECT_EQ(m.vertexCount(), 10 * power + 2);
        EXPECT_EQ(m.faceCount(), 20 * power);
        const TopologyReport& r = m.topology();
        EXPECT_TRUE(r.closed && r.manifold() && r.consistentlyOriented);
        EXPECT_EQ(r.genus, 0);
        for (const glm::vec3& p : m.positions()) EXPECT_NEAR(glm::length(p), 2.5, 1e-6);
        const double ball = 4. / 3 * std::numbers::pi * 2.5 * 2.5 * 2.5;
        EXPECT_GT(enclosedVolume(m), n == 0 ? 0.6 * ball : (1 - 0.2 / double(power)) * 0.8 * ball);
        EXPECT_LT(enclosedVolume(m), ball);
    }
}

TEST(Strips, CubeOfTheBookIsOneStripOfFourteen)
{
    const std::vector<uint32_t> book{0, 1, 2, 3, 7, 1, 5, 4, 7, 6, 2, 4, 0, 1};
    EXPECT_EQ(canonical(decodeStrips(book)), canonical(bookCube().cornerVertex()));
    const Table t = strippedBy(bookCube());
    expectExactStrips(bookCube(), t);
    EXPECT_EQ(value(t, "strips"), 1);
    EXPECT_EQ(value(t, "indices in strips"), 14);
    EXPECT_EQ(value(t, "indices in triangle list"), 36);
    expectExactStrips(cube().mesh(), strippedBy(cube().mesh()));
}

TEST(Strips, RestartBeginsAnew)
{
    const std::vector<uint32_t> two{0, 1, 2, 3, restartIndex, 4, 5, 6};
    const Array<uint32_t> triangles = decodeStrips(two);
    EXPECT_EQ(std::vector<uint32_t>(triangles.begin(), triangles.end()), (std::vector<uint32_t>{0, 1, 2, 2, 1, 3, 4, 5, 6}));
    EXPECT_TRUE(decodeStrips({}).empty());
}

TEST(Strips, GridsSpheresAndSoupsDecodeToTheSameTriangles)
{
    for (const auto start : {Stripify::Start::FewestNeighbours, Stripify::Start::InOrder}) {
        for (const Mesh& m : {grid(20, false, false).mesh(), grid(20, true, true).mesh(), moebius(17).mesh(), Mesh()})
            expectExactStrips(m, strippedBy(m, {start}));
        std::mt19937 random(5);
        for (int round = 0; round < 500; ++round) {
            const uint32_t n = 3 + random() % 12;
            Polygons p = Polygons::points(n);
            for (uint32_t f = random() % 40; f--;) {
                for (uint32_t c = 2 + random() % 4; c--;) p.corners.push_back(random() % n);
                p.start.push_back(uint32_t(p.corners.size()));
            }
            const Mesh m = p.mesh();
            expectExactStrips(m, strippedBy(m, {start}));
        }
    }
}

TEST(Strips, AGridGoesRoundInLongStrips)
{
    const Mesh m = grid(50, false, false).mesh();
    EXPECT_LT(value(strippedBy(m), "strips"), 60);
    EXPECT_GT(value(strippedBy(m), "saved per cent"), 64);
    size_t steps = 0;
    const Table watched = strippedBy(m, {}, true, &steps);
    EXPECT_EQ(contentHash(watched), contentHash(strippedBy(m)));
    EXPECT_EQ(steps, 5000 + 2 * size_t(value(watched, "strips")));
}

TEST(Valence, EqualsTheReport)
{
    Polygons p = grid(12, false, false);
    p.face({3, 3, 5}).face({0, 100});  // degenerate ones do not count
    p.positions.emplace_back(0, 0, 0);
    for (const Mesh& m : {grid(12, true, false).mesh(), cube().mesh(), p.mesh(), Mesh()}) {
        const Table t = ran<Table>(false, [&](Stage<Table>& s) { return vertexValence(m, {}, s); });
        ASSERT_EQ(t.columns[0].values.size(), m.vertexCount());
        std::map<size_t, size_t> count;
        for (const double v : t.columns[0].values) ++count[size_t(v)];
        EXPECT_EQ(count, m.topology().vertexValences);
        EXPECT_EQ(value(t, "sum of valences"), 2 * value(t, "edges"));
        EXPECT_EQ(value(t, "edges"), double(m.topology().edges));
    }
    const Table t = ran<Table>(false, [&](Stage<Table>& s) { return vertexValence(grid(12, true, false).mesh(), {}, s); });
    EXPECT_EQ(value(t, "mean"), 6);
    EXPECT_EQ(value(t, "regular share"), 1);
}

namespace {

/// Every face with vertices of its own, and attributes of all sorts.
Mesh exploded(const Mesh& m)
{
    Array<glm::vec3> positions;
    Array<uint32_t> corners;
    Array<float> normal, texcoord, heat, flat;
    Array<int32_t> material;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        material.push_back(int32_t(f));
        for (const uint32_t v : m.face(f)) {
            corners.push_back(uint32_t(positions.size()));
            positions.push_back(m.positions()[v] * (v % 2 && f % 2 ? -0.f : 1.f) + (v % 2 && f % 2 ? m.positions()[v] : glm::vec3(0)));
            for (int k = 0; k < 3; ++k) normal.push_back(m.faceNormals()[f][k]);
            texcoord.insert(texcoord.end(), {float(v), 1.f});
            heat.push_back(float(v));
            flat.push_back(float(corners.size()));
        }
    }
    return Mesh(positions, m.faceStart(), corners)
        .with(floatAttribute("normal", Domain::Vertex, 3, normal))
        .with(floatAttribute("texcoord", Domain::Vertex, 2, texcoord))
        .with(floatAttribute("heat", Domain::Vertex, 1, heat))
        .with(floatAttribute("sharp", Domain::Corner, 1, flat))
        .with(integerAttribute("material", Domain::Face, 1, material));
}

}  // namespace

TEST(Weld, MendsAnExplodedMeshAndKeepsSeams)
{
    const Mesh whole = grid(10, true, true).mesh(), apart = exploded(whole);
    EXPECT_EQ(apart.topology().components, 100u);
    const Mesh m = weldedBy(apart);
    EXPECT_EQ(m.vertexCount(), 100u);
    EXPECT_EQ(m.topology().genus, 1);
    EXPECT_EQ(m.faceStart().id(), apart.faceStart().id());
    ASSERT_NE(m.find("normal", Domain::Corner), nullptr);  // differed: nothing is lost
    for (size_t c = 0; c < m.cornerCount(); ++c)
        for (int k = 0; k < 3; ++k) EXPECT_EQ(m.find("normal")->at(c, k), apart.find("normal")->at(c, k));
    ASSERT_NE(m.find("texcoord", Domain::Vertex), nullptr);  // agreed: stays
    for (size_t c = 0; c < m.cornerCount(); ++c) EXPECT_EQ(m.find("texcoord")->at(m.cornerVertex()[c], 0), apart.find("texcoord")->at(c, 0));
    EXPECT_EQ(m.find("sharp")->id(), apart.find("sharp")->id());
    EXPECT_EQ(m.find("material")->id(), apart.find("material")->id());
    EXPECT_EQ(contentHash(weldedBy(m)), contentHash(m));  // nothing more to do
}

TEST(Weld, DistanceJoinsTheLowestKeptVertex)
{
    Polygons p;
    for (const float x : {0.f, 0.9f, 1.8f, 2.7f, -0.f, 10.f}) p.positions.emplace_back(x, 0.f, 0.f);
    const Mesh m = weldedBy(p.mesh(), {.distance = 1});
    ASSERT_EQ(m.vertexCount(), 3u);  // 0 takes 0.9, 1.8 takes 2.7, 10 stays
    EXPECT_EQ(m.positions()[1].x, 1.8f);
    EXPECT_EQ(weldedBy(p.mesh()).vertexCount(), 5u);
    EXPECT_EQ(weldedBy(p.mesh(), {.distance = 1e30}).vertexCount(), 1u);
    EXPECT_EQ(weldedBy(p.mesh(), {.distance = 1e-300}).vertexCount(), 5u);
    EXPECT_EQ(weldedBy(p.mesh(), {.dropUnreferenced = true}).vertexCount(), 0u);
}

TEST(Weld, DistanceEqualsBruteForce)
{
    std::mt19937 random(9);
    for (const double d : {0.01, 0.05, 0.3}) {
        Polygons p;
        for (int i = 0; i < 2000; ++i)
            p.positions.emplace_back(float(random() % 1000) / 1000 - 0.5f, float(random() % 1000) / 1000 - 0.5f, float(random() % 1000) / 4000);
        std::vector<glm::vec3> kept;
        for (const glm::vec3& q : p.positions)
            if (std::none_of(kept.begin(), kept.end(), [&](const glm::vec3& k) { return glm::length(glm::dvec3(k) - glm::dvec3(q)) <= d; }))
                kept.push_back(q);
        const Mesh m = weldedBy(p.mesh(), {.distance = d});
        EXPECT_EQ(std::vector<glm::vec3>(m.positions().begin(), m.positions().end()), kept);
    }
}

TEST(Weld, TidiesFacesThatLostTheirArea)
{
    Polygons p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 0}, {9, 9, 9}};
    p.face({0, 1, 2, 3}).face({2, 3, 4}).face({0, 2, 3, 4});
    Array<int32_t> material{7, 8, 9};
    const Mesh m = p.mesh()
                       .with(integerAttribute("material", Domain::Face, 1, material))
                       .with(floatAttribute("c", Domain::Corner, 1, Array<float>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    const Mesh kept = weldedBy(m);
    EXPECT_EQ(kept.faceCount(), 3u);
    EXPECT_EQ(kept.topology().degenerateFaces.size(), 2u);
    const Mesh tidy = weldedBy(m, {.dropDegenerate = true, .dropUnreferenced = true});
    EXPECT_EQ(tidy.vertexCount(), 4u);
    ASSERT_EQ(tidy.faceCount(), 2u);
    EXPECT_EQ(tidy.face(1).size(), 3u);  // the quad is a triangle now
    EXPECT_EQ(tidy.find("material")->at(1, 0), 9);
    EXPECT_EQ(tidy.find("c")->at(4, 0), 7);
    EXPECT_EQ(tidy.find("c")->size(), 7u);
}
