// Strokes against sums written out.
#include "core/terrain/brush.h"

#include <gtest/gtest.h>

#include "core/terrain/maps.h"

namespace mw {
namespace {

using test::hills;
using test::terrainOf;

TEST(Brush, FalloffsAreWhatTheirNamesSay)
{
    using F = Brush::Falloff;
    for (F f : {F::Smooth, F::Linear, F::Sphere, F::Constant}) {
        EXPECT_DOUBLE_EQ(falloffAt(f, 0), 1);
        EXPECT_EQ(falloffAt(f, 1.0001), 0);
        double before = 1;
        for (double d = 0; d <= 1; d += 0.01) {
            EXPECT_LE(falloffAt(f, d), before);
            before = falloffAt(f, d);
        }
    }
    EXPECT_DOUBLE_EQ(falloffAt(F::Smooth, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(falloffAt(F::Smooth, 0.25), 1 - 3 * 0.0625 + 2 * 0.015625);
    EXPECT_DOUBLE_EQ(falloffAt(F::Linear, 0.3), 0.7);
    EXPECT_DOUBLE_EQ(falloffAt(F::Sphere, 0.6), 0.8);
    EXPECT_DOUBLE_EQ(falloffAt(F::Constant, 0.99), 1);
}

// A stroke as the definition says, sample by sample over the whole map.
HeightMap byDefinition(const Terrain& t, const Brush& b, const std::vector<glm::dvec2>& dabs)
{
    Array<float> rows = t.map.rows();
    const double spacing = t.extent / (t.map.width() - 1);
    for (const glm::dvec2& d : dabs)
        for (uint32_t y = 0; y < t.map.height(); ++y)
            for (uint32_t x = 0; x < t.map.width(); ++x) {
                const double px = x * spacing - t.size().x / 2 - d.x, pz = y * spacing - t.size().y / 2 - d.y;
                const double share = falloffAt(b.falloff, std::sqrt(px * px + pz * pz) / b.radius);
                float& h = rows[size_t(y) * t.map.width() + x];
                h = float(double(h) + (b.kind == Brush::Kind::Raise ? 1 : -1) * b.strength * share / 50);
            }
    return HeightMap(t.map.width(), t.map.height(), rows);
}

void expectNear(const HeightMap& a, const HeightMap& b)
{
    const Array<float> x = a.rows(), y = b.rows();
    ASSERT_EQ(x.size(), y.size());
    for (size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(x[i], y[i], 1e-6f) << "sample " << i;
}

TEST(Brush, ADabIsTheFalloff)
{
    const Terrain t = terrainOf(hills(300, 260), 600, 100);
    for (Brush::Falloff f : {Brush::Falloff::Smooth, Brush::Falloff::Linear, Brush::Falloff::Sphere, Brush::Falloff::Constant})
        for (Brush::Kind kind : {Brush::Kind::Raise, Brush::Kind::Lower})
            for (glm::dvec2 place : {glm::dvec2(3.3, -20.1), glm::dvec2(-300, 260), glm::dvec2(320, 0)}) {
                const Brush brush{kind, 61.7, 0.8, 0.2, f};
                double carry = -1;
                expectNear(stroked(t, brush, std::array{place}, carry), byDefinition(t, brush, {place}));
                EXPECT_EQ(carry, 0);
            }
}

TEST(Brush, DabsAreSpacedAlongTheWay)
{
    const Terrain t = terrainOf(HeightMap::flat(200, 200, 0.5f), 199, 100);
    const Brush brush{Brush::Kind::Raise, 10, 1, 0.5, Brush::Falloff::Smooth};
    double carry = -1;
    // A way of 12 and then 11 metres: dabs at 0, 5, 10, 15 (3 into the second part), 20.
    const std::array way{glm::dvec2(0, 0), glm::dvec2(12, 0), glm::dvec2(12, 11)};
    const HeightMap m = stroked(t, brush, way, carry);
    expectNear(m, byDefinition(t, brush, {{0, 0}, {5, 0}, {10, 0}, {12, 3}, {12, 8}}));
    EXPECT_NEAR(carry, 3, 1e-12);
}

TEST(Brush, AStrokeInPiecesIsTheStroke)
{
    const Terrain t = terrainOf(hills(400, 300), 800, 100);
    const Brush brush{Brush::Kind::Lower, 30, 0.7, 0.2, Brush::Falloff::Smooth};
    std::vector<glm::dvec2> way;
    for (int i = 0; i < 60; ++i) way.push_back({-300 + 10.3 * i, 150 * std::sin(i * 0.2)});
    double carry = -1;
    const HeightMap whole = stroked(t, brush, way, carry);
    double carryOfPieces = -1;
    Terrain part = t;
    for (size_t i = 0; i < way.size(); i += 7) {
        const size_t from = i ? i - 1 : 0, to = std::min(way.size(), i + 7);
        part.map = stroked(part, brush, std::span(way).subspan(from, to - from), carryOfPieces);
    }
    EXPECT_EQ(contentHash(part.map), contentHash(whole));
    EXPECT_EQ(carryOfPieces, carry);
}

TEST(Brush, OnlyTilesADabReachesAreCopied)
{
    const Terrain t = terrainOf(hills(512, 512), 511, 100);  // a metre a sample
    const Brush brush{Brush::Kind::Raise, 20, 1, 0.2, Brush::Falloff::Constant};
    const auto changed = [&](glm::dvec2 sample) {
        double carry = -1;
        const HeightMap m = stroked(t, brush, std::array{sample - glm::dvec2(255.5)}, carry);
        std::vector<std::pair<uint32_t, uint32_t>> tiles;
        for (uint32_t y = 0; y < 4; ++y)
            for (uint32_t x = 0; x < 4; ++x)
                if (m.tile(x, y).id() != t.map.tile(x, y).id()) tiles.push_back({x, y});
        return tiles;
    };
    using Tiles = std::vector<std::pair<uint32_t, uint32_t>>;
    EXPECT_EQ(changed({200, 330}), (Tiles{{1, 2}}));
    EXPECT_EQ(changed({256, 330}), (Tiles{{1, 2}, {2, 2}}));
    EXPECT_EQ(changed({240, 240}), (Tiles{{1, 1}, {2, 1}, {1, 2}})) << "a corner of the circle's square is in a fourth tile, the circle is not";
    EXPECT_EQ(changed({250, 250}), (Tiles{{1, 1}, {2, 1}, {1, 2}, {2, 2}}));
    EXPECT_EQ(changed({-30, 100}), Tiles{}) << "beside the map";
}

TEST(Brush, NothingToDoChangesNothing)
{
    const Terrain t = terrainOf(hills(130, 130));
    double carry = -1;
    EXPECT_EQ(contentHash(stroked(t, Brush{}, {}, carry)), contentHash(t.map));
    EXPECT_LT(carry, 0) << "the first place is still to come";
    EXPECT_TRUE(stroked(Terrain(), Brush{}, std::array{glm::dvec2(0)}, carry).empty());
}

}  // namespace
}  // namespace mw
