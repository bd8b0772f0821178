// Diamond-square against the definition written out, and its displacements against the normal distribution.
#include "core/terrain/diamond_square.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "core/catalog/catalog.h"
#include "core/math/random.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

HeightMap made(const ParameterValues& values)
{
    const Operation& op = operation("diamond-square");
    return std::get<HeightMap>(apply(op, {}, checked(op.parameters, values)));
}

double phi(double x)
{
    return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

TEST(Random, IsSplitMix64)
{
    Random r(1234567);
    for (uint64_t expected : {6457827717110365317ull, 3203168211198807973ull, 9817491932198370423ull, 4593380528125082431ull}) {
        EXPECT_EQ(r.next(), expected);
    }
}

TEST(Random, QuantilesInvertTheDistribution)
{
    for (double x = -8; x <= 8; x += 0.01) {
        const double p = x < 0 ? phi(x) : 1 - phi(-x);
        if (p >= 1) continue;
        // Near 1, p itself has few digits of the tail left.
        EXPECT_NEAR(normalQuantile(p), x, x < 0 ? 1e-13 : 1e-13 + 1e-15 / std::exp(-x * x / 2)) << x;
    }
    EXPECT_EQ(normalQuantile(0.5), 0);
    EXPECT_NEAR(normalQuantile(1e-300), -37.0470964, 1e-6);
}

// Listing 5.5 as it stands, in a two-dimensional array of doubles.
std::vector<std::vector<double>> byDefinition(int n, int rounds, double sigma, uint64_t seed, const double corner[4])
{
    const int s0 = 1 << n;
    std::vector<std::vector<double>> h(s0 + 1, std::vector<double>(s0 + 1, 0));
    h[0][0] = corner[0], h[0][s0] = corner[1], h[s0][s0] = corner[2], h[s0][0] = corner[3];
    Random random(seed);
    int s = s0;
    for (int k = 0; k < rounds; ++k, s /= 2) {
        const int d = s / 2;
        const double deviation = sigma / std::pow(2, k);
        for (int y = d; y <= s0; y += s)
            for (int x = d; x <= s0; x += s)
                h[y][x] = (h[y - d][x - d] + h[y - d][x + d] + h[y + d][x - d] + h[y + d][x + d]) / 4 + deviation * random.normal();
        for (int y = 0; y <= s0; y += d)
            for (int x = 0; x <= s0; x += d) {
                if ((x / d + y / d) % 2 == 0) continue;
                double sum = 0;
                int count = 0;
                for (const auto& [dx, dy] : {std::pair(-d, 0), std::pair(d, 0), std::pair(0, -d), std::pair(0, d)})
                    if (x + dx >= 0 && x + dx <= s0 && y + dy >= 0 && y + dy <= s0) sum += h[y + dy][x + dx], ++count;
                h[y][x] = sum / count + deviation * random.normal();
            }
    }
    for (int y = 0; y <= s0; ++y)
        for (int x = 0; x <= s0; ++x) {
            const int x0 = std::min(x / s * s, s0 - s), y0 = std::min(y / s * s, s0 - s);
            const double u = double(x - x0) / s, v = double(y - y0) / s;
            if (x % s || y % s)
                h[y][x] = (1 - u) * (1 - v) * h[y0][x0] + u * (1 - v) * h[y0][x0 + s] + (1 - u) * v * h[y0 + s][x0] + u * v * h[y0 + s][x0 + s];
        }
    return h;
}

TEST(DiamondSquare, IsItsDefinition)
{
    const double corner[4] = {0.1, 0.9, 0.3, 0.6};
    for (const auto& [n, rounds] : {std::pair(1, 1), std::pair(4, 4), std::pair(6, 6), std::pair(5, 2), std::pair(5, 3)}) {
        const int64_t size = (1 << n) + 1;
        const HeightMap m = made({{"size", size},
                                  {"rounds", int64_t(rounds)},
                                  {"sigma", 0.4},
                                  {"seed", int64_t(77)},
                                  {"a", 0.1},
                                  {"b", 0.9},
                                  {"c", 0.3},
                                  {"d", 0.6},
                                  {"normalise", false}});
        ASSERT_EQ(m.width(), size);
        const auto h = byDefinition(n, rounds, 0.4, 77, corner);
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) ASSERT_NEAR(m.at(x, y), h[y][x], 1e-6) << n << ": " << x << ", " << y;
    }
}

TEST(DiamondSquare, OtherSizesAreCutFromTheNextGrid)
{
    const HeightMap whole = made({{"size", int64_t(65)}, {"normalise", false}}), cut = made({{"size", int64_t(40)}, {"normalise", false}});
    ASSERT_EQ(cut.width(), 40u);
    ASSERT_EQ(cut.height(), 40u);
    for (uint32_t y = 0; y < 40; ++y)
        for (uint32_t x = 0; x < 40; ++x) ASSERT_EQ(cut.at(x, y), whole.at(x, y));
    EXPECT_EQ(made({{"size", int64_t(2)}}).width(), 2u);
}

TEST(DiamondSquare, IsStretchedToFullHeight)
{
    EXPECT_EQ(made({}).range(), std::pair(0.f, 1.f));
    EXPECT_EQ(made({{"sigma", 0.0}}).range(), std::pair(0.f, 0.f));
    // Stretching moves no sample past another.
    const Array<float> raw = made({{"normalise", false}}).rows(), stretched = made({}).rows();
    const auto [low, high] = std::minmax_element(raw.begin(), raw.end());
    for (size_t i = 0; i < raw.size(); ++i) ASSERT_NEAR(stretched[i], (raw[i] - *low) / (*high - *low), 1e-6);
}

TEST(DiamondSquare, TheSeedDecides)
{
    EXPECT_EQ(contentHash(made({{"seed", int64_t(5)}})), contentHash(made({{"seed", int64_t(5)}})));
    EXPECT_NE(contentHash(made({{"seed", int64_t(5)}})), contentHash(made({{"seed", int64_t(6)}})));
}

TEST(DiamondSquare, DisplacementsAreNormalAndHalveByRound)
{
    const Operation& op = operation("diamond-square");
    const auto run = op.start({}, checked(op.parameters, {{"size", int64_t(257)}, {"sigma", 0.5}}), {}, true);
    std::vector<double> unit;
    std::vector<std::pair<int, double>> squares(9);  // count and sum of squares, by round
    while (run->advance()) {
        double round = 0, displacement = 0;
        bool has = false;
        for (const Number& n : run->step().numbers()) {
            if (std::string_view(n.name) == "round") round = n.value;
            if (std::string_view(n.name) == "displacement") displacement = n.value, has = true;
        }
        if (!has) continue;
        const double z = displacement / (0.5 / std::pow(2, round - 1));
        unit.push_back(z);
        ++squares[size_t(round)].first;
        squares[size_t(round)].second += z * z;
    }
    ASSERT_EQ(unit.size(), 257u * 257 - 4);
    for (size_t k = 4; k <= 8; ++k) {
        const double n = squares[k].first;
        EXPECT_NEAR(squares[k].second / n, 1, 5 * std::sqrt(2 / n)) << "variance of round " << k;
    }
    // Kolmogorov-Smirnov: sqrt(n) D is above 1.95 once in a thousand samples.
    std::sort(unit.begin(), unit.end());
    double distance = 0;
    const double n = double(unit.size());
    for (size_t i = 0; i < unit.size(); ++i)
        distance = std::max({distance, std::abs(phi(unit[i]) - double(i) / n), std::abs(phi(unit[i]) - double(i + 1) / n)});
    EXPECT_LT(std::sqrt(n) * distance, 1.95);
}

TEST(DiamondSquare, WhatIsNotKnownYetLiesBetween)
{
    const Operation& op = operation("diamond-square");
    Stepper s(stepping(op, {}, checked(op.parameters, {{"size", int64_t(17)}, {"a", 0.0}, {"b", 1.0}, {"c", 1.0}, {"d", 0.0}})));
    const auto map = [&] { return std::get<HeightMap>(valueOf(s.value())); };
    ASSERT_TRUE(s.forward());
    EXPECT_EQ(s.step().phase, "square");
    const double height = map().at(8, 8);
    for (uint32_t x = 0; x <= 16; ++x) EXPECT_NEAR(map().at(x, 0), x / 16.0, 1e-6) << "the first row rises evenly";
    EXPECT_NEAR(map().at(4, 4), (0 + 0.5 + 0 + height) / 4, 1e-6) << "a quarter of the square";
    uint32_t squares = 0, diamonds = 0, interpolations = 0;
    std::set<uint32_t> places{0, 16, 16 * 17, 17 * 17 - 1};
    s.seek(0);
    while (s.forward()) {
        squares += s.step().phase == "square", diamonds += s.step().phase == "diamond", interpolations += s.step().phase == "interpolate";
        if (s.step().phase != "square" && s.step().phase != "diamond") continue;
        double sum = 0, mean = 0, moved = 0, count = 0;
        for (const Number& n : s.step().numbers) {
            if (std::string_view(n.name) == "mean") mean = n.value;
            if (std::string_view(n.name) == "displacement") moved = n.value;
        }
        const HeightMap now = map();
        for (const Focus& f : s.step().focus) {
            const double h = now.at(f.index % 17, f.index / 17);
            if (f.role == Role::New) {
                EXPECT_NEAR(h, mean + moved, 1e-6);
                EXPECT_TRUE(places.insert(f.index).second) << "each sample once";
            } else {
                EXPECT_TRUE(places.contains(f.index)) << "parents are known";
                sum += h, ++count;
            }
        }
        EXPECT_NEAR(mean, sum / count, 1e-6);
    }
    EXPECT_EQ(squares, 1u + 4 + 16 + 64);
    EXPECT_EQ(diamonds, 17u * 17 - 4 - squares);
    EXPECT_EQ(interpolations, 3u);
}

}  // namespace
}  // namespace mw
