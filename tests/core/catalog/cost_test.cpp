// What an operation is told to take: as its work grows, as a machine has shown. What it takes in truth is measured by tests/bench/cost_check.cpp.
#include "core/catalog/cost.h"

#include <gtest/gtest.h>

namespace mw {
namespace {

Cost told(const char* id, size_t faces, const char* values = "", const CostRecord* record = nullptr)
{
    const Operation& op = operation(id);
    return *expectedCost(op, {faces, 22 * faces}, parsed(op.parameters, values), record);
}

TEST(Cost, GrowsWithTheWork)
{
    // n log n: ten times the faces take more than ten times, and less than thirty times as long.
    const double small = told("decimate-quadric", 100'000).seconds, large = told("decimate-quadric", 1'000'000).seconds;
    EXPECT_GT(large, 10 * small);
    EXPECT_LT(large, 30 * small);
    EXPECT_LT(told("decimate-quadric", 1'000'000, "quality=fast").seconds, large);
    EXPECT_GT(told("decimate-quadric", 1'000'000, "quality=textbook").seconds, large);
    EXPECT_GT(told("decimate-quadric", 100'000, "ratio=0.1").seconds, told("decimate-quadric", 100'000, "ratio=0.9").seconds);
    EXPECT_EQ(told("decimate-quadric", 100'000, "stop=faces,faces=20000").result.faces, 20'000u);
    // Loop makes four faces of one, at each level.
    EXPECT_EQ(told("subdivide-loop", 1000, "levels=3").result.faces, 64'000u);
    EXPECT_NEAR(told("subdivide-loop", 1000, "levels=4").seconds / told("subdivide-loop", 1000, "levels=3").seconds, 4, 0.25);
    EXPECT_NEAR(told("subdivide-loop", 1'000'000, "levels=3").result.bytes, 64 * 22e6, 1);
    // Rounds of smoothing.
    const double ten = told("smooth", 1000, "iterations=100").seconds, twenty = told("smooth", 1000, "iterations=200").seconds;
    EXPECT_GT(twenty, 1.8 * ten);
    EXPECT_LT(twenty, 2.0 * ten);
    // Factors of n^1.5 operations; rounds and sweeps.
    const double disk = told("embed-planar", 100'000).seconds, larger = told("embed-planar", 1'000'000).seconds;
    EXPECT_GT(larger, 10 * disk);
    EXPECT_LT(larger, 32 * disk);
    EXPECT_GT(told("embed-planar", 100'000, "solver=jacobi").seconds, 10 * disk);
    EXPECT_GT(told("embed-spherical", 1000, "iterations=400").seconds, 1.7 * told("embed-spherical", 1000, "iterations=200").seconds);
    EXPECT_FALSE(expectedCost(operation("icosphere"), {}, {}));
    for (const Operation& op : catalog())
        if (const auto cost = expectedCost(op, {50'000, 1'100'000}, {})) {
            EXPECT_GT(cost->seconds, 0) << op.id;
            EXPECT_LT(cost->seconds, 10) << op.id;
            EXPECT_TRUE(std::isfinite(cost->bytes)) << op.id;
        }
    EXPECT_EQ(expectedCost(operation("weld"), {}, {})->seconds, 0);
}

TEST(Cost, LearnsFromRuns)
{
    CostRecord record;
    const Operation& op = operation("smooth");
    const double before = told("smooth", 1'000'000).seconds;
    for (int i = 0; i < 20; ++i) record.learn(op, {1'000'000, 22'000'000}, {}, 3 * before);
    EXPECT_NEAR(told("smooth", 500'000, "", &record).seconds / told("smooth", 500'000).seconds, 3, 0.01);
    EXPECT_EQ(record.factor("weld"), 1);
    record.learn(operation("weld"), {10, 220}, {}, 1e-5);
    EXPECT_EQ(record.factor("weld"), 1) << "runs too short to tell anything";
    const CostRecord back = CostRecord::fromText(record.text());
    EXPECT_NEAR(back.factor("smooth"), record.factor("smooth"), 1e-9);
    for (const char* wrong : {"", "[]", "{\"smooth\":\"x\"}", "{\"smooth\":1e300}", "{"}) {
        EXPECT_LE(CostRecord::fromText(wrong).factor("smooth"), 20.0001);
    }
}

TEST(Cost, IsSaidInWords)
{
    EXPECT_EQ(costText({0.2, 1e6}), "");
    EXPECT_EQ(costText({2.2, 1e6}), "about 2 s");
    EXPECT_EQ(costText({14.2, 1e6}), "about 14 s");
    EXPECT_EQ(costText({14.2, 2.1e9}), "about 14 s, 2.1 GB");
    EXPECT_EQ(costText({600, 1e6}), "about 10 min");
    EXPECT_TRUE((Cost{11, 0}).heavy());
    EXPECT_TRUE((Cost{1, 3e9}).heavy());
    EXPECT_FALSE((Cost{9, 1e9}).heavy());
}

}  // namespace
}  // namespace mw
