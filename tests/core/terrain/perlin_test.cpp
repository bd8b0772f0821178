// Perlin noise against equations (5.12) to (5.16) evaluated one sample at a time.
#include "core/terrain/perlin.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

HeightMap made(const ParameterValues& values)
{
    const Operation& op = operation("perlin");
    return std::get<HeightMap>(apply(op, {}, checked(op.parameters, values)));
}

using Image = std::vector<double>;

double fade(const std::string& name, double w)
{
    if (name == "cubic") return 3 * std::pow(w, 2) - 2 * std::pow(w, 3);
    if (name == "quintic") return 6 * std::pow(w, 5) - 15 * std::pow(w, 4) + 10 * std::pow(w, 3);
    return w;
}

// (5.12), (5.13); ways counted in intervals.
Image octaveByDefinition(int n, int interval, int64_t seed, const std::string& fading)
{
    Image image;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int x1 = x / interval * interval, x2 = x1 + interval, y1 = y / interval * interval, y3 = y1 + interval;
            const auto dot = [&](int cx, int cy) {
                const double theta = 2 * M_PI * perlinTurn(seed, uint32_t(cx), uint32_t(cy));
                return (std::cos(theta) * (x - cx) + std::sin(theta) * (y - cy)) / interval;
            };
            const double d1 = dot(x1, y1), d2 = dot(x2, y1), d3 = dot(x1, y3), d4 = dot(x2, y3);
            const double wx = fade(fading, double(x - x1) / (x2 - x1)), wy = fade(fading, double(y - y1) / (y3 - y1));
            const double d12 = wx * (d2 - d1) + d1, d34 = wx * (d4 - d3) + d3;
            image.push_back(wy * (d34 - d12) + d12);
        }
    return image;
}

// (5.14)
Image stretched(Image image)
{
    const auto [low, high] = std::minmax_element(image.begin(), image.end());
    const double least = *low, most = *high;
    for (double& v : image) v = (v - least) / (most - least);
    return image;
}

void expectNear(const HeightMap& map, const Image& image, double tolerance)
{
    const Array<float> rows = map.rows();
    ASSERT_EQ(rows.size(), image.size());
    for (size_t i = 0; i < rows.size(); ++i) ASSERT_NEAR(rows[i], image[i], tolerance) << "sample " << i;
}

TEST(Perlin, AnOctaveIsItsDefinition)
{
    for (const char* fading : {"none", "cubic", "quintic"})
        for (int64_t n : {65, 100, 130})
            for (int64_t interval : {64, 37, 8, 4, 3, 2}) {
                const HeightMap m = made(
                    {{"size", n}, {"interval", interval}, {"octave", int64_t(1)}, {"fade", fading}, {"seed", int64_t(9)}, {"normalise", "none"}});
                expectNear(m, octaveByDefinition(int(n), int(interval), 9, fading), 1e-6);
            }
}

TEST(Perlin, TheSumIsItsDefinition)
{
    Image sum(129 * 129, 0), raw(129 * 129, 0);
    for (int k = 0; k < 4; ++k) {
        const Image octave = octaveByDefinition(129, 64 >> k, 3, "quintic"), whole = stretched(octave);
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += whole[i] / (1 << k) / 1.875, raw[i] += octave[i] / (1 << k) / 1.875;
    }
    const ParameterValues values{{"size", int64_t(129)}, {"interval", int64_t(64)}, {"octaves", int64_t(4)}, {"seed", int64_t(3)}};
    const auto with = [&](const char* normalise) {
        ParameterValues v = values;
        v["normalise"] = normalise;
        return made(v);
    };
    expectNear(with("octaves"), sum, 2e-6);
    expectNear(with("none"), raw, 1e-6);
    expectNear(with("sum"), stretched(raw), 2e-6);
    // An octave alone is what was added for it.
    ParameterValues third = values;
    third["octave"] = int64_t(3);
    expectNear(made(third), stretched(octaveByDefinition(129, 16, 3, "quintic")), 2e-6);
}

TEST(Perlin, IsZeroAtTheVectors)
{
    const HeightMap m = made({{"size", int64_t(257)}, {"interval", int64_t(32)}, {"octave", int64_t(1)}, {"normalise", "none"}});
    for (uint32_t y = 0; y < 257; y += 32)
        for (uint32_t x = 0; x < 257; x += 32) EXPECT_EQ(m.at(x, y), 0.f);
}

TEST(Perlin, StaysInItsRangeAndIsContinuous)
{
    const int64_t interval = 64;
    for (const char* fading : {"none", "cubic", "quintic"}) {
        const HeightMap m = made({{"size", int64_t(1025)}, {"interval", interval}, {"octave", int64_t(1)}, {"fade", fading}, {"normalise", "none"}});
        const auto [least, most] = m.range();
        EXPECT_GE(least, -std::sqrt(0.5) - 1e-6);
        EXPECT_LE(most, std::sqrt(0.5) + 1e-6);
        EXPECT_LT(least, -0.4f);
        EXPECT_GT(most, 0.4f);
        // The gradient is at most 1 from the vectors and the slope of the fade (at most 15/8) times the difference of two dot products.
        const double steepest = (1 + 15.0 / 8 * 2 * std::sqrt(2)) / interval;
        for (uint32_t y = 0; y < 1025; ++y)
            for (uint32_t x = 1; x < 1025; ++x) ASSERT_LE(std::abs(m.at(x, y) - m.at(x - 1, y)), steepest) << x << ", " << y;
    }
}

TEST(Perlin, TheFieldHasAllDirectionsEqually)
{
    std::vector<int> count(16);
    double x = 0, y = 0;
    const int n = 400;
    for (uint32_t j = 0; j < n; ++j)
        for (uint32_t i = 0; i < n; ++i) {
            const double turn = perlinTurn(1, 4 * i, 4 * j);
            ++count[size_t(turn * 16)];
            x += std::cos(2 * M_PI * turn), y += std::sin(2 * M_PI * turn);
        }
    double chi = 0;
    for (int c : count) chi += std::pow(c - n * n / 16.0, 2) / (n * n / 16.0);
    EXPECT_LT(chi, 37.7) << "15 degrees of freedom: more than that once in a thousand fields";
    EXPECT_LT(std::hypot(x, y) / (n * n), 4.0 / n);
    EXPECT_NE(perlinTurn(1, 4, 8), perlinTurn(2, 4, 8));
}

TEST(Perlin, SteppedIsRun)
{
    const Operation& op = operation("perlin");
    for (const char* normalise : {"octaves", "sum", "none"}) {
        const ParameterValues values = checked(op.parameters, {{"size", int64_t(150)}, {"normalise", normalise}});
        Stepper s(stepping(op, {}, values));
        size_t corners = 0, octaves = 0;
        while (s.forward()) {
            octaves += s.step().phase == "octave";
            if (s.step().phase != "corners") continue;
            ++corners;
            EXPECT_EQ(s.step().focus.size(), 5u);
            std::map<std::string, double> number;
            for (const Number& n : s.step().numbers) number[n.name] = n.value;
            const int interval = int(number["interval"]);
            EXPECT_NEAR(octaveByDefinition(150, interval, 1, "quintic")[s.step().focus[0].index], number["d"], 1e-9);
            EXPECT_EQ(s.step().focus[4].index - s.step().focus[1].index, uint32_t(interval) * 151);
        }
        EXPECT_EQ(corners, 4u);
        EXPECT_EQ(octaves, 4u);
        EXPECT_EQ(contentHash(valueOf(s.value())), contentHash(made(values)));
    }
}

TEST(Perlin, OctavesWithoutRoomAreLeftOut)
{
    EXPECT_EQ(contentHash(made({{"interval", int64_t(8)}, {"octaves", int64_t(3)}})),
              contentHash(made({{"interval", int64_t(8)}, {"octaves", int64_t(9)}})));
    EXPECT_EQ(made({{"interval", int64_t(8)}, {"octave", int64_t(9)}}).range(), std::pair(0.f, 0.f));
    EXPECT_EQ(made({{"size", int64_t(2)}, {"interval", int64_t(8192)}}).width(), 2u);
}

}  // namespace
}  // namespace mw
