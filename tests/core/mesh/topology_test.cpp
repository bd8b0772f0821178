// The topology report against closed forms.
#include "core/mesh/topology.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

/// V, E, F, components, loops, boundary edges, Euler characteristic.
void expectCounts(const TopologyReport& r, size_t v, size_t e, size_t f, size_t components, size_t loops, size_t boundary, long euler)
{
    EXPECT_EQ(r.vertices, v);
    EXPECT_EQ(r.edges, e);
    EXPECT_EQ(r.faces, f);
    EXPECT_EQ(r.components, components);
    EXPECT_EQ(r.boundaryLoops.size(), loops);
    EXPECT_EQ(r.boundaryEdges, boundary);
    EXPECT_EQ(r.euler, euler);
    EXPECT_EQ(r.closed, f > 0 && boundary == 0);
    size_t degrees = 0, vertices = 0;
    for (const auto& [n, count] : r.vertexValences) {
        degrees += n * count;
        vertices += count;
    }
    EXPECT_EQ(degrees, 2 * e);
    EXPECT_EQ(vertices, v);
}

/// n tori of m x m quads in a row, each joined to the next by a tube in place of one quad of each: genus n.
Polygons chainOfTori(uint32_t n, uint32_t m)
{
    Polygons out;
    const Polygons one = grid(m, true, true);
    for (uint32_t k = 0; k < n; ++k) {
        const uint32_t base = k * m * m;
        for (auto p : one.positions) out.positions.push_back(p + glm::vec3(10.f * float(k), 0, 0));
        for (uint32_t f = 0; f < m * m; ++f) {
            const bool first = f == 0 && k > 0, last = f == 3 * m + 3 && k + 1 < n;
            if (first || last) continue;
            const uint32_t* c = &one.corners[4 * f];
            out.face({c[0] + base, c[1] + base, c[2] + base, c[3] + base});
        }
        if (k == 0) continue;
        const uint32_t *a = &one.corners[4 * (3 * m + 3)], *b = &one.corners[0];
        for (uint32_t i = 0; i < 4; ++i) {  // side i of the hole on the left one meets side 3-i of the other, which runs the other way
            const uint32_t j = (i + 1) % 4;
            out.face({a[i] + base - m * m, a[j] + base - m * m, b[(4 - j) % 4] + base, b[(4 - i) % 4] + base});
        }
    }
    return out;
}

}  // namespace

TEST(Topology, ClosedSurfaces)
{
    const TopologyReport none = Mesh().topology();
    expectCounts(none, 0, 0, 0, 0, 0, 0, 0);
    EXPECT_FALSE(none.genus);

    const TopologyReport t = tetrahedron().mesh().topology();
    expectCounts(t, 4, 6, 4, 1, 0, 0, 2);
    EXPECT_EQ(t.genus, 0);
    EXPECT_TRUE(t.manifold() && t.orientable && t.consistentlyOriented);
    EXPECT_EQ(t.vertexValences, (std::map<size_t, size_t>{{3, 4}}));

    const TopologyReport c = cube().mesh().topology();
    expectCounts(c, 8, 12, 6, 1, 0, 0, 2);
    EXPECT_EQ(c.genus, 0);
    EXPECT_EQ(c.triangles, 12u);
    EXPECT_EQ(c.faceSizes, (std::map<size_t, size_t>{{4, 6}}));

    const TopologyReport g = grid(10, true, false).mesh().topology();
    expectCounts(g, 100, 300, 200, 1, 0, 0, 0);
    EXPECT_EQ(g.genus, 1);
    EXPECT_EQ(g.regularVertices, 100u);
    for (const uint32_t n : {1u, 2u, 5u}) {
        const TopologyReport r = chainOfTori(n, 8).mesh().topology();
        EXPECT_EQ(r.genus, long(n));
        EXPECT_TRUE(r.closed && r.manifold() && r.consistentlyOriented);
        EXPECT_EQ(r.components, 1u);
    }
}

TEST(Topology, BoundariesAreWalkedRoundWithTheHoleOnTheLeft)
{
    const TopologyReport disk = grid(3, false, true).mesh().topology();
    expectCounts(disk, 16, 24, 9, 1, 1, 12, 1);
    EXPECT_EQ(disk.genus, 0);
    EXPECT_EQ(disk.boundaryLoops[0], (std::vector<uint32_t>{0, 4, 8, 12, 13, 14, 15, 11, 7, 3, 2, 1}));
    EXPECT_EQ(disk.regularVertices, 4u + 8u);

    const TopologyReport m = moebius(20).mesh().topology();
    expectCounts(m, 40, 60, 20, 1, 1, 40, 0);
    EXPECT_FALSE(m.orientable);
    EXPECT_FALSE(m.genus);
    EXPECT_TRUE(m.manifold());
    EXPECT_EQ(m.boundaryLoops[0].size(), 40u);
}

TEST(Topology, TurnedFacesAreFoundAndStillOrientable)
{
    Polygons p = grid(10, true, false);
    for (const uint32_t f : {7u, 8u, 90u}) std::swap(p.corners[3 * f], p.corners[3 * f + 1]);
    const TopologyReport r = p.mesh().topology();
    EXPECT_TRUE(r.orientable);
    EXPECT_FALSE(r.consistentlyOriented);
    EXPECT_EQ(r.inconsistentEdges.size(), 9u);
    EXPECT_EQ(r.genus, 1);
}

TEST(Topology, OffendersAreNamed)
{
    Polygons hourglass = Polygons::points(7);
    for (const uint32_t o : {0u, 3u}) hourglass.face({0, o + 1, o + 2}).face({0, o + 2, o + 3}).face({0, o + 3, o + 1}).face({o + 1, o + 3, o + 2});
    const TopologyReport h = hourglass.mesh().topology();
    expectCounts(h, 7, 12, 8, 1, 0, 0, 3);
    EXPECT_EQ(h.nonmanifoldVertices, std::vector<uint32_t>{0});
    EXPECT_FALSE(h.genus);

    const TopologyReport three = Polygons::points(5).face({0, 1, 2}).face({1, 0, 3}).face({0, 1, 4}).mesh().topology();
    expectCounts(three, 5, 7, 3, 1, 1, 6, 1);
    EXPECT_EQ(three.nonmanifoldEdges, (std::vector<TopologyReport::Edge>{{0, 1}}));
    EXPECT_TRUE(three.nonmanifoldVertices.empty());
    EXPECT_EQ(three.boundaryLoops[0], (std::vector<uint32_t>{0, 1, 2, 3, 4}));  // no simple loop

    const TopologyReport bow = Polygons::points(5).face({0, 1, 2}).face({0, 3, 4}).mesh().topology();
    expectCounts(bow, 5, 6, 2, 1, 1, 6, 1);
    EXPECT_EQ(bow.nonmanifoldVertices, std::vector<uint32_t>{0});
}

TEST(Topology, DegenerateDuplicateAndIsolated)
{
    Polygons p = Polygons::points(9);
    p.face({0, 1, 2}).face({3, 3, 4}).face({2, 1, 0}).face({5, 6}).face({}).face({1, 2, 3, 0}).face({0, 3, 1, 2}).face({4, 3, 4}).face({0, 1, 2});
    const TopologyReport r = p.mesh().topology();
    EXPECT_EQ(r.degenerateFaces, (std::vector<uint32_t>{1, 3, 4, 7}));
    EXPECT_EQ(r.duplicateFaces, (std::vector<uint32_t>{2, 6, 7, 8}));
    EXPECT_EQ(r.isolatedVertices, (std::vector<uint32_t>{7, 8}));
    EXPECT_EQ(r.faces, 9u);
    EXPECT_FALSE(r.genus);
}

TEST(Topology, ConsistentWithBruteForceOnSoups)
{
    std::mt19937 random(11);
    for (int round = 0; round < 300; ++round) {
        const uint32_t n = 4 + random() % 10;
        Polygons p = Polygons::points(n);
        for (uint32_t f = random() % 14; f--;) {
            for (uint32_t c = 2 + random() % 3; c--;) p.corners.push_back(random() % n);
            p.start.push_back(uint32_t(p.corners.size()));
        }
        const TopologyReport r = p.mesh().topology();
        // Orientable: some choice of turned faces makes all edges of two faces run both ways.
        std::vector<std::vector<uint32_t>> faces;
        const Mesh m = p.mesh();
        for (uint32_t f = 0; f < m.faceCount(); ++f)
            if (!std::ranges::binary_search(r.degenerateFaces, f)) faces.emplace_back(m.face(f).begin(), m.face(f).end());
        std::map<std::pair<uint32_t, uint32_t>, std::vector<std::pair<uint32_t, bool>>> edges;
        for (uint32_t f = 0; f < faces.size(); ++f)
            for (size_t i = 0; i < faces[f].size(); ++i) {
                const uint32_t a = faces[f][i], b = faces[f][(i + 1) % faces[f].size()];
                edges[{std::min(a, b), std::max(a, b)}].emplace_back(f, a < b);
            }
        EXPECT_EQ(r.edges, edges.size());
        bool orientable = false;
        for (uint32_t turned = 0; turned < 1u << faces.size() && !orientable; ++turned) {
            orientable = true;
            for (const auto& [ends, sides] : edges)
                if (sides.size() == 2 && (sides[0].second ^ (turned >> sides[0].first & 1)) == (sides[1].second ^ (turned >> sides[1].first & 1))) {
                    orientable = false;
                    break;
                }
        }
        EXPECT_EQ(r.orientable, orientable);
    }
}

TEST(Topology, AreaAndVolume)
{
    EXPECT_NEAR(surfaceArea(cube().mesh()), 6, 1e-12);
    EXPECT_NEAR(enclosedVolume(cube().mesh()), 1, 1e-12);
    EXPECT_NEAR(enclosedVolume(tetrahedron().mesh()), 1. / 6, 1e-12);
    const Mesh torus = grid(400, true, false).mesh();  // R = 3, r = 1
    EXPECT_NEAR(surfaceArea(torus), 12 * std::numbers::pi * std::numbers::pi, 0.01);
    EXPECT_NEAR(enclosedVolume(torus), 6 * std::numbers::pi * std::numbers::pi, 0.01);
}
