// The sum of sine waves against its closed form.
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/terrain/maps.h"

namespace mw {
namespace {

HeightMap made(const char* parameters)
{
    const Operation& op = operation("sinusoids");
    return std::get<HeightMap>(apply(op, {}, parsed(op.parameters, parameters)));
}

TEST(Sinusoids, AreTheirSum)
{
    // (5.9), written out.
    const auto g = [](double t) {
        return std::sin(2 * M_PI * t) + std::sin(4 * M_PI * t) / 2 + std::sin(8 * M_PI * t) / 4 + std::sin(16 * M_PI * t) / 8 +
               std::sin(32 * M_PI * t) / 16;
    };
    double least = 1e9, most = -1e9;
    for (int i = 0; i <= 128; ++i) least = std::min(least, g(0.6 * i / 128)), most = std::max(most, g(0.6 * i / 128));
    const HeightMap m = made("size=129");
    for (uint32_t y = 0; y < 129; ++y)
        for (uint32_t x = 0; x < 129; ++x) ASSERT_NEAR(m.at(x, y), (g(0.6 * x / 128) + g(0.6 * y / 128) - 2 * least) / (2 * (most - least)), 1e-6);
    EXPECT_EQ(m.range(), std::pair(0.f, 1.f));
}

TEST(Sinusoids, OneWaveIsOnePeriod)
{
    const HeightMap m = made("size=101,harmonics=1,until=1");
    EXPECT_NEAR(m.at(25, 25), 1, 1e-6);
    EXPECT_NEAR(m.at(75, 75), 0, 1e-6);
    EXPECT_NEAR(m.at(25, 75), 0.5, 1e-6);
    EXPECT_NEAR(m.at(0, 50), 0.5, 1e-6);
}

}  // namespace
}  // namespace mw
