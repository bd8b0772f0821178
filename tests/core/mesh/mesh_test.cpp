// The payload: sharing, hashes, normals, edges and rings, polygons cut into triangles.
#include "core/mesh/mesh.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <set>
#include <thread>

#include "core/mesh/normals.h"
#include "core/mesh/rings.h"
#include "core/mesh/table.h"

#include "shapes.h"

using namespace mw;
using namespace mw::test;

TEST(Mesh, DefaultIsEmpty)
{
    const Mesh m;
    EXPECT_EQ(m.vertexCount(), 0u);
    EXPECT_EQ(m.faceCount(), 0u);
    EXPECT_TRUE(m.bounds().empty);
    EXPECT_TRUE(m.edges().empty());
    EXPECT_TRUE(m.vertexNormals().empty());
    EXPECT_TRUE(m.triangulation().vertices.empty());
    EXPECT_EQ(m.rings().start.size(), 1u);
}

TEST(Mesh, ChangedCopiesShareArraysAndCaches)
{
    const Mesh a = cube().mesh();
    const Mesh b = a.with(floatAttribute("heat", Domain::Vertex, 1, Array<float>(8, 1.f)));
    EXPECT_EQ(a.positions().id(), b.positions().id());
    EXPECT_EQ(&a.rings(), &b.rings());
    EXPECT_EQ(&a.vertexNormals(), &b.vertexNormals());
    EXPECT_EQ(a.find("heat"), nullptr);
    ASSERT_NE(b.find("heat", Domain::Vertex), nullptr);
    EXPECT_EQ(b.find("heat", Domain::Face), nullptr);
    EXPECT_EQ(b.without("heat").attributes().size(), 0u);

    Array<glm::vec3> moved(a.positions().begin(), a.positions().end());
    for (auto& p : moved) p *= 2.f;
    const Mesh c = a.withPositions(moved);
    EXPECT_EQ(a.cornerVertex().id(), c.cornerVertex().id());
    EXPECT_EQ(&a.rings(), &c.rings());
    EXPECT_EQ(c.bounds().max, glm::dvec3(2));
    EXPECT_EQ(a.bounds().max, glm::dvec3(1));
}

TEST(Mesh, HashTellsContentNotIdentity)
{
    const Mesh a = cube().mesh(), same = cube().mesh();
    EXPECT_EQ(contentHash(a), contentHash(same));
    std::set<uint64_t> all{contentHash(a)};
    const auto differs = [&](const Mesh& m) { EXPECT_TRUE(all.insert(contentHash(m)).second); };
    differs(a.with(floatAttribute("a", Domain::Vertex, 1, Array<float>(8, 0.f))));
    differs(a.with(floatAttribute("b", Domain::Vertex, 1, Array<float>(8, 0.f))));
    differs(a.with(floatAttribute("a", Domain::Corner, 1, Array<float>(24, 0.f))));
    differs(a.with(integerAttribute("a", Domain::Vertex, 1, Array<int32_t>(8, 0))));
    differs(a.withLines(Array<uint32_t>{0, 1}));
    differs(a.withGroupNames({"x", "y"}));
    differs(a.withGroupNames({"xy"}));
    for (size_t i = 0; i < 8; ++i) {  // any single bit counts
        Array<glm::vec3> p(a.positions().begin(), a.positions().end());
        p[i].y += 1e-6f;
        differs(a.withPositions(p));
    }
}

TEST(Mesh, NormalsOfCubeAndOfTinyAndHugeOnes)
{
    for (const float size : {1e-18f, 1.f, 1e18f}) {
        Polygons p = cube();
        for (auto& q : p.positions) q *= size;
        const Mesh m = p.mesh();
        for (size_t f = 0; f < 6; ++f) {
            glm::vec3 middle(0);
            for (const uint32_t v : m.face(f)) middle += 0.25f * (m.positions()[v] / size);
            EXPECT_NEAR(glm::length(m.faceNormals()[f] - 2.f * (middle - glm::vec3(0.5f))), 0, 1e-6);
        }
        for (size_t v = 0; v < 8; ++v)
            EXPECT_NEAR(glm::length(m.vertexNormals()[v] - (2.f * (m.positions()[v] / size) - 1.f) / std::sqrt(3.f)), 0, 1e-6);
    }
}

TEST(Mesh, VertexNormalsAreThoseOfTheTorus)
{
    const uint32_t n = 200;
    const Mesh m = grid(n, true, false).mesh();
    for (uint32_t y = 0; y < n; y += 7)
        for (uint32_t x = 0; x < n; x += 5) {
            const double u = 2 * std::numbers::pi * x / n, v = 2 * std::numbers::pi * y / n;
            const glm::vec3 exact(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
            EXPECT_GT(glm::dot(exact, m.vertexNormals()[y * n + x]), 0.999f);
        }
}

TEST(Mesh, EdgesComeInTheOrderOfFirstCorner)
{
    Polygons p = Polygons::points(5);
    p.face({3, 1, 2}).face({2, 1, 0}).face({3, 1, 4}).face({0, 0, 4});
    const Shared<uint32_t> e = p.mesh().edges();
    const std::vector<uint32_t> expected{1, 3, 1, 2, 2, 3, 0, 1, 0, 2, 1, 4, 3, 4, 0, 4};
    EXPECT_EQ(std::vector<uint32_t>(e.begin(), e.end()), expected);
}

TEST(Mesh, RingsOfRandomSoupsEqualSets)
{
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const uint32_t n = 3 + random() % 40;
        Polygons p = Polygons::points(n);
        for (uint32_t f = random() % 60; f--;) {
            for (uint32_t c = random() % 6; c--;) p.corners.push_back(random() % n);
            p.start.push_back(uint32_t(p.corners.size()));
        }
        const Mesh m = p.mesh();
        std::vector<std::set<uint32_t>> corners(n), neighbours(n);
        std::set<std::pair<uint32_t, uint32_t>> edges;
        for (size_t f = 0; f < m.faceCount(); ++f)
            for (size_t i = 0; i < m.face(f).size(); ++i) {
                const uint32_t a = m.face(f)[i], b = m.face(f)[(i + 1) % m.face(f).size()];
                corners[a].insert(m.faceStart()[f] + uint32_t(i));
                if (a == b) continue;
                neighbours[a].insert(b);
                neighbours[b].insert(a);
                edges.insert({std::min(a, b), std::max(a, b)});
            }
        const Rings& r = m.rings();
        for (uint32_t v = 0; v < n; ++v) {
            EXPECT_TRUE(std::ranges::equal(r.cornersOf(v), corners[v]));
            EXPECT_TRUE(std::ranges::equal(r.neighboursOf(v), neighbours[v]));
        }
        EXPECT_EQ(m.edges().size(), 2 * edges.size());
        for (size_t e = 0; e < m.edges().size(); e += 2) EXPECT_TRUE(edges.contains({m.edges()[e], m.edges()[e + 1]}));
    }
}

TEST(Mesh, DerivedDataFromManyThreads)
{
    const Mesh m = grid(100, true, true).mesh();
    std::vector<std::jthread> threads;
    std::array<const void*, 8> seen{};
    for (size_t i = 0; i < seen.size(); ++i)
        threads.emplace_back([&, i] {
            const Mesh copy = m;
            seen[i] = &copy.rings();
            EXPECT_EQ(copy.triangulation().faces.size(), 20000u);
            EXPECT_EQ(copy.edges().size(), 40000u);
        });
    threads.clear();
    for (const void* s : seen) EXPECT_EQ(s, seen[0]);
}

namespace {

/// Cuts of a plane polygon must keep its orientation everywhere and add up to its area.
void expectExactCut(const Mesh& m)
{
    const auto& t = m.triangulation();
    for (size_t f = 0; f < m.faceCount(); ++f) {
        const glm::dvec3 whole = areaVector(m, f), normal = glm::normalize(whole);
        double sum = 0, smallest = 0;
        size_t count = 0;
        for (size_t i = 0; i < t.faces.size(); ++i) {
            if (t.faces[i] != f) continue;
            glm::dvec3 p[3];
            for (size_t k = 0; k < 3; ++k) {
                p[k] = m.positions()[t.vertices[3 * i + k]];
                EXPECT_EQ(m.cornerVertex()[t.corners[3 * i + k]], t.vertices[3 * i + k]);
            }
            const double area = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), normal);
            sum += std::abs(area);
            smallest = std::min(smallest, area);
            ++count;
        }
        EXPECT_EQ(count, m.face(f).size() - 2);
        EXPECT_NEAR(sum, glm::length(whole), 1e-5 * glm::length(whole)) << "corners: " << m.face(f).size();
        EXPECT_GE(smallest, -1e-6 * glm::length(whole));
    }
}

Mesh onePolygon(const std::vector<glm::dvec2>& points)
{
    Polygons p;
    for (const auto& q : points) {
        p.corners.push_back(uint32_t(p.positions.size()));
        p.positions.emplace_back(0.3 * q.x - q.y, q.x + 0.2 * q.y, 0.5 * q.x + q.y);  // some plane in space
    }
    p.start.push_back(uint32_t(p.corners.size()));
    return p.mesh();
}

}  // namespace

TEST(Triangulation, ConcavePolygons)
{
    expectExactCut(onePolygon({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}));  // arrow head, cut from either corner
    expectExactCut(onePolygon({{2, 0}, {0.5, 0.5}, {0, 2}, {0, 0}}));
    expectExactCut(onePolygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));  // U with straight corners
    for (const uint32_t n : {5u, 8u, 37u, 400u, 3000u}) {                                                          // stars
        std::vector<glm::dvec2> star, comb;
        for (uint32_t i = 0; i < 2 * n; ++i) {
            const double a = std::numbers::pi * i / n, r = i % 2 ? 0.3 : 1;
            star.emplace_back(r * std::cos(a), r * std::sin(a));
        }
        expectExactCut(onePolygon(star));
        for (uint32_t i = 0; i < n; ++i) comb.emplace_back(double(i) / n, i % 2 ? 1.0 : 0.01);  // teeth from below
        comb.emplace_back(1, -1);
        comb.emplace_back(0, -1);
        std::reverse(comb.begin(), comb.end());
        expectExactCut(onePolygon(comb));
    }
}

TEST(Triangulation, HoleReachedByABridge)
{
    expectExactCut(onePolygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
}

TEST(Triangulation, WhateverComesGivesTwoLessThanCorners)
{
    std::mt19937 random(3);
    std::vector<glm::dvec2> tangle;
    for (int i = 0; i < 2000; ++i) tangle.emplace_back(random() % 100, random() % 100);
    EXPECT_EQ(onePolygon(tangle).triangulation().faces.size(), 1998u);
    EXPECT_EQ(onePolygon(std::vector<glm::dvec2>(500, {1, 1})).triangulation().faces.size(), 498u);
    EXPECT_EQ(Polygons::points(3).face({0, 1}).face({}).face({2}).mesh().triangulation().faces.size(), 0u);
}

TEST(Triangulation, HugeConcavePolygonEndsInTime)
{
    std::vector<glm::dvec2> spiral;  // a band of 200,000 corners wound up: half of them concave
    const int n = 100000;
    for (int i = 0; i < n; ++i) spiral.emplace_back((1 + 1e-3 * i) * std::cos(0.01 * i), (1 + 1e-3 * i) * std::sin(0.01 * i));
    for (int i = n; i--;) spiral.emplace_back((1.2 + 1e-3 * i) * std::cos(0.01 * i), (1.2 + 1e-3 * i) * std::sin(0.01 * i));
    EXPECT_EQ(onePolygon(spiral).triangulation().faces.size(), size_t(2 * n - 2));
}

TEST(Attributes, BlendedMixesFloatsAndPicksIntegers)
{
    Stencils rows;
    rows.add(0, 0.25);
    rows.add(2, 0.75);
    rows.endRow();
    rows.add(1, 1);
    rows.endRow();
    const Attribute heat = floatAttribute("heat", Domain::Vertex, 1, {0, 5, 8});
    EXPECT_EQ(blended(heat, rows).at(0, 0), 6);
    EXPECT_EQ(blended(heat, rows).at(1, 0), 5);
    EXPECT_EQ(blended(integerAttribute("id", Domain::Vertex, 1, {7, 8, 9}), rows).at(0, 0), 9);
    const Attribute normal = floatAttribute("normal", Domain::Vertex, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    const Attribute mixed = blended(normal, rows);
    EXPECT_NEAR(mixed.at(0, 0), 0.25 / std::hypot(0.25, 0.75), 1e-6);
    EXPECT_NEAR(mixed.at(0, 2), 0.75 / std::hypot(0.25, 0.75), 1e-6);
    const Attribute tangent = floatAttribute("tangent", Domain::Corner, 4, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, -1});
    EXPECT_EQ(blended(tangent, rows).at(0, 3), -1);
    const uint32_t from[] = {2, 2, 0};
    EXPECT_EQ(gathered(heat, from).size(), 3u);
    EXPECT_EQ(gathered(heat, from).at(1, 0), 8);
}

TEST(Attributes, BlendedSkinMergesAndKeepsTheStrongest)
{
    const Attribute joints = integerAttribute("joints", Domain::Vertex, 4, {0, 1, 2, 3, 4, 1, 0, 0});
    const Attribute weights = floatAttribute("weights", Domain::Vertex, 4, {0.4f, 0.3f, 0.2f, 0.1f, 0.5f, 0.5f, 0, 0});
    Stencils rows;
    rows.add(0, 0.5);
    rows.add(1, 0.5);
    rows.endRow();
    const SkinWeights s = blendedSkin(joints, weights, rows);  // 1: .40, 4: .25, 0: .20, 2: .10, 3: .05 dropped
    const int expected[] = {1, 4, 0, 2};
    const double w[] = {0.40, 0.25, 0.20, 0.10};
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(s.joints.at(0, k), expected[k]);
        EXPECT_NEAR(s.weights.at(0, k), w[k] / 0.95, 1e-6);
    }
}

TEST(Table, HashesAndSizes)
{
    Table t;
    t.columns.push_back({"heat", "m", {1, 2, 3}, false});
    t.summary = {{"mean", 2}};
    t.lists = {{"strip", {1, 2, 3}}};
    Table u = t;
    EXPECT_EQ(contentHash(t), contentHash(u));
    u.columns[0].values[1] = 2.5;
    EXPECT_NE(contentHash(t), contentHash(u));
    EXPECT_GT(byteSize(t), 36u);
    EXPECT_NE(contentHash(ElementSet{ElementKind::Vertex, {1}}), contentHash(ElementSet{ElementKind::Face, {1}}));
}
