// Heights, normals and rays against closed forms and against cells tried one by one.
#include "core/terrain/terrain.h"

#include <chrono>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/terrain/maps.h"

namespace mw {
namespace {

using test::hills;
using test::mapOf;
using test::terrainOf;

TEST(HeightMap, KnowsTheRangeOfItsTiles)
{
    const HeightMap m = mapOf(300, 200, [](uint32_t x, uint32_t y) { return 0.25 + x + 1000.0 * y; });
    EXPECT_EQ(m.range(0, 0), std::pair(0.25f, 127127.25f));
    EXPECT_EQ(m.range(2, 1), std::pair(128256.25f, 199299.25f)) << "what lies beyond the map does not count";
    EXPECT_EQ(m.range(), std::pair(0.25f, 199299.25f));
    Array<float> tile(size_t(128) * 128, -3.f);
    const HeightMap changed = m.withTile(2, 1, tile);
    EXPECT_EQ(changed.range(2, 1), std::pair(-3.f, -3.f));
    EXPECT_EQ(changed.range(), std::pair(-3.f, 199171.25f + 84)) << "tile (1, 1) has the largest now";
    EXPECT_EQ(m.range(2, 1).first, 128256.25f) << "the old one is as it was";
    EXPECT_EQ(changed.tile(0, 0).id(), m.tile(0, 0).id());
}

TEST(Terrain, HeightsAreBilinearAndHeldBeyondTheBorder)
{
    // A function that is bilinear everywhere: h = 0.1 + 0.2 u + 0.3 v + 0.4 u v.
    const Terrain t = terrainOf(mapOf(9, 5, [](uint32_t x, uint32_t y) { return 0.1 + 0.2 * x / 8 + 0.3 * y / 4 + 0.4 * x / 8 * y / 4; }), 80, 50);
    EXPECT_DOUBLE_EQ(t.size().x, 80);
    EXPECT_DOUBLE_EQ(t.size().y, 40);
    for (double x : {-40.0, -13.7, 0.0, 22.5, 39.9})
        for (double z : {-20.0, -3.3, 11.0, 20.0}) {
            const double u = x / 80 + 0.5, v = z / 40 + 0.5;
            EXPECT_NEAR(t.heightAt(x, z), 50 * (0.1 + 0.2 * u + 0.3 * v + 0.4 * u * v), 1e-5);
        }
    EXPECT_EQ(t.heightAt(-400, -500), t.heightAt(-40, -20));
    EXPECT_EQ(t.heightAt(400, 3), t.heightAt(40, 3));
    EXPECT_EQ(Terrain().heightAt(1, 2), 0);
}

TEST(Terrain, NormalsOfAPlaneAreExactAlsoOnTheBorder)
{
    // y = 0.3 x - 0.2 z.
    const Terrain t = terrainOf(mapOf(17, 33, [](uint32_t x, uint32_t y) { return (0.3 * (x - 8.0) * 10 - 0.2 * (y - 16.0) * 10) / 100; }), 160, 100);
    const glm::dvec3 expected = glm::normalize(glm::dvec3(-0.3, 1, 0.2));
    for (double x : {-80.0, -79.0, 0.0, 31.4, 80.0})
        for (double z : {-160.0, 0.0, 7.7, 160.0}) EXPECT_LT(glm::distance(t.normalAt(x, z), expected), 1e-5) << x << ' ' << z;
}

TEST(Terrain, NormalsOfASphericalCapPointFromItsCentre)
{
    const double radius = 300;
    const Terrain t = terrainOf(mapOf(513, 513,
                                      [&](uint32_t x, uint32_t y) {
                                          const double px = (x / 512.0 - 0.5) * 200, pz = (y / 512.0 - 0.5) * 200;
                                          return std::sqrt(radius * radius - px * px - pz * pz) / 100;
                                      }),
                                200, 100);
    for (double x : {-80.0, 3.0, 51.0})
        for (double z : {-70.0, 0.0, 44.0}) {
            const glm::dvec3 p(x, t.heightAt(x, z), z);
            EXPECT_LT(glm::distance(t.normalAt(x, z), glm::normalize(p)), 1e-3);
        }
}

TEST(Terrain, BoundsHoldAllSamples)
{
    const Bounds b = boundsOf(terrainOf(mapOf(5, 3, [](uint32_t x, uint32_t y) { return x == 2 && y == 1 ? 2 : -0.5; }), 40, 10));
    EXPECT_EQ(b.min, glm::dvec3(-20, -5, -10));
    EXPECT_EQ(b.max, glm::dvec3(20, 20, 10));
    EXPECT_TRUE(boundsOf(Terrain()).empty);
}

// The same by trying small steps along the ray and halving where the side changes.
std::optional<glm::dvec3> marched(const Terrain& t, glm::dvec3 o, glm::dvec3 d, double length)
{
    const glm::dvec2 half = 0.5 * t.size();
    const auto inside = [&](glm::dvec3 p) { return std::abs(p.x) <= half.x && std::abs(p.z) <= half.y; };
    const auto above = [&](double s) {
        const glm::dvec3 p = o + s * d;
        return p.y - t.heightAt(p.x, p.z);
    };
    const int steps = 40000;
    for (int i = 0; i < steps; ++i) {
        double a = length * i / steps, b = length * (i + 1) / steps;
        if (!inside(o + a * d) || !inside(o + b * d) || above(a) * above(b) > 0) continue;
        for (int k = 0; k < 60; ++k) {
            const double m = 0.5 * (a + b);
            (above(a) * above(m) <= 0 ? b : a) = m;
        }
        return o + a * d;
    }
    return std::nullopt;
}

TEST(Terrain, RaysMeetItWhereSmallStepsDo)
{
    std::mt19937 random(11);
    const auto between = [&](double a, double b) { return a + (b - a) * double(random()) / double(std::mt19937::max()); };
    for (const Terrain& t : {terrainOf(hills(300, 200), 600, 80), terrainOf(hills(40, 140), 100, -60)}) {
        int met = 0;
        for (int i = 0; i < 150; ++i) {
            const glm::dvec3 o(between(-1, 1) * t.extent, between(-100, 150), between(-1, 1) * t.extent);
            const glm::dvec3 to(between(-0.5, 0.5) * t.size().x, between(-20, 60), between(-0.5, 0.5) * t.size().y);
            const auto p = t.meet(o, to - o), expected = marched(t, o, to - o, 3);
            ASSERT_TRUE(!expected || p) << "ray " << i;
            if (!p) continue;
            ++met;
            EXPECT_NEAR(p->y, t.heightAt(p->x, p->z), 1e-9);
            // Small steps may jump over a ridge.
            if (expected && glm::distance(*expected, o) <= glm::distance(*p, o)) {
                EXPECT_LT(glm::distance(*p, *expected), 1e-6) << "ray " << i;
            }
        }
        EXPECT_GT(met, 40);
    }
}

TEST(Terrain, RaysStraightDownAndAlongCellBordersMeet)
{
    const Terrain t = terrainOf(hills(257, 257), 256, 50);
    for (int i = -128; i <= 128; ++i) {
        const auto down = t.meet({i, 1000, -i}, {0, -3, 0});
        ASSERT_TRUE(down) << i;
        EXPECT_NEAR(down->y, t.heightAt(i, -i), 1e-9);
        const auto up = t.meet({i, -1000, 0.5}, {0, 1, 0});
        ASSERT_TRUE(up) << i;
        EXPECT_NEAR(up->y, t.heightAt(i, 0.5), 1e-9);
        EXPECT_TRUE(t.meet({i, 200, -300}, {0, -0.7, 1})) << "along a line of samples";
        EXPECT_EQ(t.meet({-300.0 + i, 400, -300}, {1, -1, 1}).has_value(), i <= 50) << "through the corners of cells, " << i;
    }
}

TEST(Terrain, RaysBesideAndAwayDoNotMeet)
{
    const Terrain t = terrainOf(hills(65, 65), 100, 50);
    EXPECT_FALSE(t.meet({0, 200, 0}, {0, 1, 0}));
    EXPECT_FALSE(t.meet({51, 200, 0}, {0, -1, 0}));
    EXPECT_FALSE(t.meet({-200, 60, 0}, {1, 0, 0}));
    EXPECT_FALSE(t.meet({0, 200, 0}, {0, 0, 0}));
    EXPECT_FALSE(t.meet({0, NAN, 0}, {0, -1, 0}));
    EXPECT_FALSE(Terrain().meet({0, 1, 0}, {0, -1, 0}));
    EXPECT_TRUE(terrainOf(HeightMap::flat(2, 2, 0.5f), 10, 10).meet({1, 9, 1}, {0.1, -1, 0.2}));
}

TEST(Terrain, ARayOverALargeMapIsFast)
{
    const Terrain t = terrainOf(hills(4096, 4096), 4096, 100);
    const auto start = std::chrono::steady_clock::now();
    const int rays = 200;
    int met = 0;
    for (int i = 0; i < rays; ++i) met += t.meet({-2000, 120, -2000.0 + 13 * i}, {1, -0.02, 0.4}) ? 1 : 0;
    const double each = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / rays;
    RecordProperty("milliseconds", std::to_string(each));
    EXPECT_GT(met, rays / 2);
    EXPECT_LT(each, 20) << "milliseconds, with room for slow builds";
}

}  // namespace
}  // namespace mw
