// The quadric against what it stands for: the sum of squared distances.
#include "core/simplify/quadric.h"

#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "core/simplify/edge_heap.h"
#include "core/simplify/live_rank.h"

using namespace mw;

namespace {

struct Plane {
    glm::dvec3 n;
    double d, weight;
};

std::vector<Plane> randomPlanes(std::mt19937& random, int count)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<Plane> planes;
    for (int i = 0; i < count; ++i)
        planes.push_back({glm::normalize(glm::dvec3(unit(random), unit(random), unit(random))), unit(random), 1 + unit(random)});
    return planes;
}

TEST(Quadric, IsTheSumOfSquaredDistances)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-2, 2);
    for (int round = 0; round < 100; ++round) {
        Quadric q;
        const auto planes = randomPlanes(random, 6);
        for (const Plane& p : planes) q.addPlane(p.n, p.d, p.weight);
        const glm::dvec3 x(unit(random), unit(random), unit(random));
        double direct = 0;
        for (const Plane& p : planes) direct += p.weight * std::pow(glm::dot(p.n, x) + p.d, 2);
        EXPECT_NEAR(q.at(x), direct, 1e-12 * (1 + direct));
    }
}

TEST(Quadric, LeastIsWhereNothingNearIsLess)
{
    std::mt19937 random(2);
    for (int round = 0; round < 100; ++round) {
        Quadric q;
        for (const Plane& p : randomPlanes(random, 8)) q.addPlane(p.n, p.d, p.weight);
        glm::dvec3 p;
        ASSERT_TRUE(q.least(p));
        for (int k = 0; k < 3; ++k)
            for (const double step : {-1e-3, 1e-3}) {
                glm::dvec3 other = p;
                other[k] += step;
                EXPECT_GT(q.at(other), q.at(p));
            }
        EXPECT_GE(q.condition(), 1);
    }
}

TEST(Quadric, FlatAndStraightOnesHaveNoLeastPoint)
{
    Quadric q;
    glm::dvec3 p;
    EXPECT_FALSE(q.least(p));
    q.addPlane({0, 0, 1}, 1, 2);
    EXPECT_FALSE(q.least(p));
    q.addPlane({0, 1, 0}, 1, 2);
    EXPECT_FALSE(q.least(p));
    q.addPoint({3, 0, 0}, 1e-5);
    ASSERT_TRUE(q.least(p));
    EXPECT_NEAR(glm::length(p - glm::dvec3(3, -1, -1)), 0, 1e-4);
}

TEST(EdgeHeap, GivesTheLeastAndTheLowerOfEquals)
{
    std::mt19937 random(3);
    EdgeHeap heap(200);
    std::vector<float> cost(200, -1.f);
    for (uint32_t e = 0; e < 200; ++e) heap.append(e, cost[e] = float(random() % 50));
    heap.order();
    for (int i = 0; i < 500; ++i) {
        const uint32_t e = uint32_t(random() % 200);
        if (i % 3 == 0) {
            heap.remove(e);
            cost[e] = -1;
        } else {
            heap.set(e, cost[e] = float(random() % 50));
        }
    }
    std::pair<float, uint32_t> last(-1.f, 0);
    size_t count = 0;
    while (!heap.empty()) {
        const std::pair<float, uint32_t> now(heap.topCost(), heap.topEdge());
        EXPECT_LT(last, now);
        EXPECT_EQ(cost[now.second], now.first);
        heap.remove(now.second);
        last = now;
        ++count;
    }
    EXPECT_EQ(count, size_t(std::count_if(cost.begin(), cost.end(), [](float c) { return c >= 0; })));
}

TEST(LiveRank, CountsThoseBefore)
{
    LiveRank rank(10);
    rank.remove(0);
    rank.remove(4);
    EXPECT_EQ(rank(1), 0u);
    EXPECT_EQ(rank(4), 3u);
    EXPECT_EQ(rank(9), 7u);
    EXPECT_EQ(LiveRank()(7), 7u);
}

}  // namespace
