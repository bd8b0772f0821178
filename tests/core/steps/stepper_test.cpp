// Stepping an algorithm on a plain list of numbers: forwards, back, far back, to a phase, cancelled, failing.
#include "core/steps/stepper.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace mw {

// A type of its own: byteSize is found by its namespace.
struct Numbers : std::vector<int> {
    using std::vector<int>::vector;
};
size_t byteSize(const Numbers& n)
{
    return n.size() * sizeof(int) + 64;
}

namespace {

// Bubble sort: it compares and swaps, and shows what it looks at.
Generator bubbleSort(Numbers n, Stage<Numbers>& stage)
{
    stage.show([&] { return n; });
    for (size_t end = n.size(); end > 1; --end)
        for (uint32_t i = 0; i + 1 < end; ++i) {
            co_yield Step("compare").vertex(i, Role::Current, "a").vertex(i + 1, Role::Neighbour).number("left", n[i]);
            if (n[i] <= n[i + 1]) continue;
            std::swap(n[i], n[i + 1]);
            const std::vector<uint32_t> both{i, i + 1};
            co_yield Step("swap").ring(ElementKind::Vertex, Role::New, both).number("left", n[i]).progress(1.0 - double(end) / double(n.size()));
        }
    stage.finish(n);
}

StartRun sorting(Numbers n)
{
    return [n](bool watched) -> std::unique_ptr<Run> {
        return std::make_unique<RunOf<Numbers>>(
            watched, [&](Stage<Numbers>& s) { return bubbleSort(n, s); }, n);
    };
}

Numbers mixed(int n)
{
    Numbers v(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) v[size_t(i)] = (i * 37 + 11) % n;
    return v;
}

Numbers shown(Stepper& s)
{
    return std::any_cast<Numbers>(s.value().value);
}

TEST(Stepper, EndsWithTheResult)
{
    Stepper s(sorting(mixed(9)));
    EXPECT_EQ(shown(s), mixed(9));
    while (s.forward()) {
    }
    EXPECT_TRUE(s.atEnd());
    EXPECT_EQ(s.step().phase, "end");
    EXPECT_EQ(s.length(), s.position() + 1);
    Numbers sorted = mixed(9);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(shown(s), sorted);
    EXPECT_FALSE(s.forward());
}

TEST(Stepper, BackGivesTheStatesThatWereThere)
{
    // Memory for a few states only, so that most of the way back runs again from the start.
    Stepper s(sorting(mixed(12)), 500);
    std::vector<std::pair<std::string, Numbers>> seen{{s.step().phase, shown(s)}};
    while (s.forward()) seen.emplace_back(s.step().phase, shown(s));
    for (size_t i = seen.size(); i-- > 1;) {
        EXPECT_EQ(s.position(), i);
        EXPECT_EQ(shown(s), seen[i].second) << i;
        EXPECT_EQ(s.step().phase, seen[i].first) << i;
        ASSERT_TRUE(s.back());
    }
    EXPECT_FALSE(s.back());
    for (size_t i : {7u, 3u, 40u, 1u, 39u}) {
        s.seek(i);
        EXPECT_EQ(shown(s), seen[i].second);
    }
    s.seek(100000);
    EXPECT_TRUE(s.atEnd());
}

TEST(Stepper, RecordsFocusNumbersAndPlace)
{
    Stepper s(sorting({2, 1}));
    ASSERT_TRUE(s.forward());
    EXPECT_EQ(s.step().phase, "compare");
    ASSERT_EQ(s.step().focus.size(), 2u);
    EXPECT_EQ(s.step().focus[0].index, 0u);
    EXPECT_STREQ(s.step().focus[0].label, "a");
    EXPECT_EQ(s.step().numbers[0].value, 2);
    const unsigned compareLine = s.step().line;
    ASSERT_TRUE(s.forward());
    EXPECT_EQ(s.step().phase, "swap");
    EXPECT_EQ(s.step().focus[1].index, 1u);
    EXPECT_EQ(s.step().line, compareLine + 4);
    EXPECT_NE(std::string(s.step().file).find("stepper_test.cpp"), std::string::npos);
}

TEST(Stepper, SeekWhereStopsAtThePhase)
{
    Stepper s(sorting({3, 2, 1}));
    EXPECT_TRUE(s.seekWhere([](const StepRecord& r) { return r.phase == "swap"; }));
    EXPECT_EQ(s.position(), 2u);
    s.seek(0);
    EXPECT_TRUE(s.seekWhere([](const StepRecord& r) { return r.phase == "swap"; }));
    EXPECT_EQ(s.position(), 2u);
    EXPECT_FALSE(s.seekWhere([](const StepRecord& r) { return r.phase == "no such phase"; }));
    EXPECT_TRUE(s.atEnd());
}

TEST(Stepper, CancelLeavesItWhereItWas)
{
    Stepper s(sorting(mixed(20)), 1000);
    s.seek(5);
    const Numbers before = shown(s);
    Progress cancelled;
    cancelled.cancelled = true;
    EXPECT_THROW(s.seek(150, &cancelled), Cancelled);
    EXPECT_EQ(s.position(), 5u);
    EXPECT_EQ(shown(s), before);
}

Generator failing(Stage<Numbers>& stage)
{
    stage.show([] { return Numbers{1}; });
    co_yield Step("begin");
    throw Error("no solution; choose another start");
}

StartRun startFailing()
{
    return [](bool watched) -> std::unique_ptr<Run> { return std::make_unique<RunOf<Numbers>>(watched, failing); };
}

TEST(Stepper, AnErrorComesThrough)
{
    Stepper s(startFailing());
    EXPECT_TRUE(s.forward());
    EXPECT_THROW(s.forward(), Error);
}

}  // namespace
}  // namespace mw
