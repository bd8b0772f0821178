// Meshes of terrains: topology, heights, budget and error against the map itself.
#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/io/height_picture.h"
#include "core/mesh/topology.h"
#include "core/terrain/maps.h"

#include "data.h"

namespace mw {
namespace {

using test::hills;
using test::mapOf;
using test::terrainOf;

void expectSheet(const Terrain& t, const Mesh& m)
{
    const TopologyReport& r = m.topology();
    EXPECT_TRUE(r.manifold());
    EXPECT_EQ(r.euler, 1);
    EXPECT_EQ(r.components, 1u);
    EXPECT_EQ(r.boundaryLoops.size(), 1u);
    const glm::dvec2 size = t.size();
    const double spacing = t.extent / (t.map.width() - 1);
    double area = 0;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        const glm::dvec3 a(m.positions()[m.face(f)[0]]), b(m.positions()[m.face(f)[1]]), c(m.positions()[m.face(f)[2]]);
        const double up = glm::cross(b - a, c - a).y / 2;
        ASSERT_GT(up, 0.4 * spacing * spacing) << "face " << f << " is turned over or has no area";
        area += up;
    }
    EXPECT_NEAR(area, size.x * size.y, 1e-5 * size.x * size.y) << "covers the ground once";
    for (const glm::vec3& p : m.positions()) {
        const double x = (double(p.x) + size.x / 2) / spacing, z = (double(p.z) + size.y / 2) / spacing;
        ASSERT_NEAR(x, std::round(x), 1e-3);
        ASSERT_NEAR(z, std::round(z), 1e-3);
        const double ground = t.maximumHeight * double(t.map.at(uint32_t(std::lround(x)), uint32_t(std::lround(z))));
        ASSERT_NEAR(double(p.y), std::max(ground, t.waterLevel), 1e-4);
    }
}

// Largest distance by asking, for each sample, the triangle above it.
double errorByDefinition(const Terrain& t, const Mesh& m)
{
    const uint32_t w = t.map.width(), h = t.map.height();
    std::vector<double> error(size_t(w) * h, 1e9);
    const double spacing = t.extent / (w - 1);
    for (size_t f = 0; f < m.faceCount(); ++f) {
        glm::dvec3 p[3];
        for (size_t k = 0; k < 3; ++k) p[k] = glm::dvec3(m.positions()[m.face(f)[k]]);
        for (uint32_t y = 0; y < h; ++y)
            for (uint32_t x = 0; x < w; ++x) {
                const double px = x * spacing - t.size().x / 2, pz = y * spacing - t.size().y / 2;
                const double d = (p[1].z - p[2].z) * (p[0].x - p[2].x) + (p[2].x - p[1].x) * (p[0].z - p[2].z);
                const double u = ((p[1].z - p[2].z) * (px - p[2].x) + (p[2].x - p[1].x) * (pz - p[2].z)) / d;
                const double v = ((p[2].z - p[0].z) * (px - p[2].x) + (p[0].x - p[2].x) * (pz - p[2].z)) / d;
                if (u < -1e-6 || v < -1e-6 || u + v > 1 + 1e-6) continue;
                const double at = u * p[0].y + v * p[1].y + (1 - u - v) * p[2].y;
                const double ground = std::max(t.maximumHeight * double(t.map.at(x, y)), t.waterLevel);
                error[size_t(y) * w + x] = std::min(error[size_t(y) * w + x], std::abs(at - ground));
            }
    }
    return *std::max_element(error.begin(), error.end());
}

TEST(TerrainMesh, AnySizeIsASheetWithinItsBudget)
{
    for (const auto& [w, h] : {std::pair(129u, 129u), std::pair(128u, 128u), std::pair(100u, 37u), std::pair(2u, 300u), std::pair(257u, 130u),
                               std::pair(3u, 3u), std::pair(65u, 66u)}) {
        const Terrain t = terrainOf(hills(w, h), 500, 60);
        for (size_t budget : {200u, 3000u, 20000u}) {
            const Mesh m = terrainMesh(t, budget);
            SCOPED_TRACE(std::to_string(w) + " x " + std::to_string(h) + ", " + std::to_string(budget));
            expectSheet(t, m);
            const size_t all = size_t(w - 1) * (h - 1) * 2;
            EXPECT_LE(m.faceCount(), budget);
            EXPECT_GE(m.faceCount(), std::min<size_t>(all, size_t(0.94 * double(budget)))) << "near the budget";
            if (m.faceCount() * w * h < 10'000'000) {
                EXPECT_NEAR(terrainMeshError(t, m), errorByDefinition(t, m), 1e-3);
            }
        }
    }
}

TEST(TerrainMesh, AllCellsWhenTheBudgetAllows)
{
    for (const auto& [w, h] : {std::pair(33u, 33u), std::pair(40u, 21u), std::pair(2u, 2u)}) {
        const Terrain t = terrainOf(HeightMap::flat(w, h, 0.5f), 100, 10);
        const Mesh m = terrainMesh(t, size_t(w - 1) * (h - 1) * 2);
        EXPECT_EQ(m.faceCount(), size_t(w - 1) * (h - 1) * 2);
        EXPECT_EQ(m.vertexCount(), size_t(w) * h);
        expectSheet(t, m);
        EXPECT_LT(terrainMeshError(terrainOf(hills(w, h)), terrainMesh(terrainOf(hills(w, h)), 1000000)), 1e-3);
    }
}

TEST(TerrainMesh, WhatIsEvenTakesFewTriangles)
{
    EXPECT_EQ(terrainMesh(terrainOf(HeightMap::flat(129, 129, 0.3f)), 10000).faceCount(), 2u);
    // A slope with exact heights.
    EXPECT_EQ(terrainMesh(terrainOf(mapOf(129, 129, [](uint32_t x, uint32_t y) { return (2.0 * x + y) / 512; }), 128, 64), 10000).faceCount(), 2u);
    // One peak: fine there, coarse elsewhere.
    const Terrain t = terrainOf(mapOf(257, 257, [](uint32_t x, uint32_t y) { return x == 100 && y == 60 ? 1 : 0; }), 256, 10);
    const Mesh m = terrainMesh(t, 10000);
    EXPECT_LT(m.faceCount(), 200u);
    EXPECT_LT(terrainMeshError(t, m), 1e-6);
    expectSheet(t, m);
}

TEST(TerrainMesh, MoreTrianglesMeanLessError)
{
    const Terrain t = terrainOf(hills(300, 300), 300, 60);
    double before = 1e9;
    for (size_t budget : {100u, 1000u, 10000u, 60000u, 170000u}) {
        const double error = terrainMeshError(t, terrainMesh(t, budget));
        EXPECT_LT(error, before) << budget;
        before = error;
    }
}

TEST(TerrainMesh, FewTrianglesAreEnoughForAnything)
{
    for (const auto& [w, h] : {std::pair(1000u, 7u), std::pair(129u, 129u), std::pair(513u, 300u)}) {
        const Terrain t = terrainOf(hills(w, h));
        const Mesh m = terrainMesh(t, 1);
        EXPECT_LE(m.faceCount(), 6u);
        expectSheet(t, m);
    }
    EXPECT_EQ(terrainMesh(Terrain(), 100).faceCount(), 0u);
}

TEST(TerrainMesh, WaterIsFlat)
{
    Terrain t = terrainOf(hills(129, 129), 500, 60);
    t.waterLevel = 30;
    const Mesh m = terrainMesh(t, 4000);
    expectSheet(t, m);
    const Attribute& color = *m.find("color", Domain::Vertex);
    size_t wet = 0;
    for (size_t v = 0; v < m.vertexCount(); ++v) {
        ASSERT_GE(m.positions()[v].y, 30.f);
        if (m.positions()[v].y > 30.f) continue;
        ++wet;
        EXPECT_GT(color.at(v, 2), 0.9 * color.at(v, 0)) << "no sand in the water";
    }
    EXPECT_GT(wet, 50u);
}

TEST(TerrainMesh, CarriesNormalsPicturePlacesAndColours)
{
    Terrain t = terrainOf(mapOf(129, 65, [](uint32_t x, uint32_t) { return x / 128.0; }), 1280, 100);
    const Mesh m = terrainMesh(t, 1000000);
    const Attribute &normal = *m.find("normal", Domain::Vertex), &color = *m.find("color", Domain::Vertex),
                    &place = *m.find("texcoord", Domain::Corner);
    const glm::dvec3 slope = glm::normalize(glm::dvec3(-100.0 / 1280, 1, 0));
    for (size_t v = 0; v < m.vertexCount(); ++v) {
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(normal.at(v, k), slope[k], 1e-4);
        const double share = double(m.positions()[v].y) / 100;
        // Sand is brown, grass green, snow white.
        if (share < 0.17) {
            EXPECT_GT(color.at(v, 0), color.at(v, 1));
        }
        if (share > 0.23 && share < 0.44) {
            EXPECT_GT(color.at(v, 1), color.at(v, 0));
        }
        if (share > 0.62) {
            EXPECT_GT(color.at(v, 0), 0.8);
        }
    }
    for (size_t c = 0; c < m.cornerCount(); ++c) {
        const glm::vec3 p = m.positions()[m.cornerVertex()[c]];
        ASSERT_NEAR(place.at(c, 0), p.x / 1280 + 0.5, 1e-5);
        ASSERT_NEAR(place.at(c, 1), 0.5 - p.z / t.size().y, 1e-5) << "upwards";
    }
}

TEST(TerrainMesh, RealMapsKeepTheirBudget)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const auto& entry : std::filesystem::directory_iterator(data / "terrain")) {
        SCOPED_TRACE(entry.path());
        const Terrain t = terrainOf(readHeightMap(entry.path()), 1000, 115);
        for (size_t budget : {2000u, 30000u}) {
            const Mesh m = terrainMesh(t, budget);
            EXPECT_LE(m.faceCount(), budget);
            EXPECT_GE(m.faceCount(), budget * 95 / 100) << "although pictures have few values";
            expectSheet(t, m);
        }
    }
}

TEST(TerrainMesh, CanBeCancelled)
{
    Progress p;
    p.cancelled = true;
    EXPECT_THROW(terrainMesh(terrainOf(hills(129, 129)), 1000, &p), Cancelled);
}

}  // namespace
}  // namespace mw
