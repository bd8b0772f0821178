// Sampling of channels against closed forms.
#include "core/character/clip.h"

#include <cmath>
#include <gtest/gtest.h>

namespace mw {
namespace {

using Path = Channel::Path;
using Interpolation = Channel::Interpolation;

Channel channel(Path path, int components, Interpolation how, Array<double> times, Array<double> values)
{
    Channel c;
    c.path = path;
    c.components = components;
    c.interpolation = how;
    c.times = std::move(times);
    c.values = std::move(values);
    return c;
}

double at(const Channel& c, double time)
{
    double v = NAN;
    sample(c, time, &v);
    return v;
}

TEST(Clip, LinearStepAndHolds)
{
    const Channel linear = channel(Path::Weights, 1, Interpolation::Linear, {1, 2, 4}, {10, 20, -20});
    EXPECT_EQ(at(linear, -5), 10);
    EXPECT_EQ(at(linear, 1), 10);
    EXPECT_EQ(at(linear, 1.25), 12.5);
    EXPECT_EQ(at(linear, 2), 20);
    EXPECT_EQ(at(linear, 3), 0);
    EXPECT_EQ(at(linear, 4), -20);
    EXPECT_EQ(at(linear, 1e9), -20);
    const Channel step = channel(Path::Weights, 1, Interpolation::Step, {1, 2, 4}, {10, 20, -20});
    EXPECT_EQ(at(step, 0), 10);
    EXPECT_EQ(at(step, 1.999), 10);
    EXPECT_EQ(at(step, 2), 20);
    EXPECT_EQ(at(step, 3.999), 20);
    EXPECT_EQ(at(step, 4), -20);
    const Channel single = channel(Path::Weights, 1, Interpolation::Linear, {3}, {7});
    EXPECT_EQ(at(single, 0), 7);
    EXPECT_EQ(at(single, 9), 7);
}

TEST(Clip, OfEqualTimesTheLaterKeyCounts)
{
    const Channel c = channel(Path::Weights, 1, Interpolation::Linear, {0, 1, 1, 1, 2}, {0, 10, 20, 30, 40});
    EXPECT_EQ(at(c, 1), 30);
    EXPECT_NEAR(at(c, std::nextafter(1.0, 0.0)), 10, 1e-9);
    EXPECT_EQ(at(c, 1.5), 35);
    const Channel ends = channel(Path::Weights, 1, Interpolation::Linear, {1, 1}, {5, 6});
    EXPECT_EQ(at(ends, 1), 6);
    EXPECT_EQ(at(ends, 2), 6);
}

// A cubic through its own values and derivatives at two times is reproduced everywhere: tangents are per second.
TEST(Clip, CubicReproducesACubic)
{
    const auto f = [](double t) { return 2 * t * t * t - 5 * t * t + 3 * t - 7; };
    const auto df = [](double t) { return 6 * t * t - 10 * t + 3; };
    Array<double> times{0.5, 1.25, 4}, values;
    for (const double t : times) values.insert(values.end(), {df(t), f(t), df(t)});
    const Channel c = channel(Path::Weights, 1, Interpolation::Cubic, times, values);
    for (double t = 0.5; t <= 4; t += 0.0625) EXPECT_NEAR(at(c, t), f(t), 1e-12) << t;
    EXPECT_EQ(at(c, 0), f(0.5));
    EXPECT_EQ(at(c, 5), f(4));
}

TEST(Clip, RotationsTakeTheShorterArcAtConstantSpeed)
{
    // 0 to 100 degrees about z, the second one written as its negative.
    const double half = glm::radians(50.0);
    const Channel c = channel(Path::Rotation, 4, Interpolation::Linear, {0, 1}, {0, 0, 0, 1, 0, 0, -std::sin(half), -std::cos(half)});
    for (double t = 0; t <= 1; t += 0.125) {
        double q[4];
        sample(c, t, q);
        const double sign = q[3] < 0 ? -1 : 1;
        EXPECT_NEAR(sign * q[2], std::sin(t * half), 1e-12);
        EXPECT_NEAR(sign * q[3], std::cos(t * half), 1e-12);
    }
    // Not unit in the file: unit when sampled, also when cubic.
    const Channel cubic = channel(Path::Rotation, 4, Interpolation::Cubic, {0, 1}, {0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0,  //
                                                                                    0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0});
    double q[4];
    sample(cubic, 0.5, q);
    EXPECT_NEAR(q[0], std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(q[3], std::sqrt(0.5), 1e-12);
    sample(cubic, 0, q);
    EXPECT_EQ(q[3], 1);
}

glm::dmat3 rotation(int axis, double degrees)
{
    const double a = glm::radians(degrees), c = std::cos(a), s = std::sin(a);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dmat3 m(1);
    m[u][u] = m[v][v] = c;
    m[u][v] = s;
    m[v][u] = -s;
    return m;
}

// Angles multiply in the order of the channels, the first one leftmost; positions are added to the rest.
TEST(Clip, EulerChannelsInEveryOrder)
{
    const double angles[3] = {400, -75, 31};  // x, y, z; more than a turn is a turn and more
    const int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& order : orders) {
        std::vector<Channel> channels;
        for (const int axis : order) channels.push_back(channel(Path(int(Path::EulerX) + axis), 1, Interpolation::Linear, {0}, {angles[axis]}));
        channels.push_back(channel(Path::PositionZ, 1, Interpolation::Linear, {0, 1}, {4, 8}));
        std::vector<const Channel*> list;
        for (const Channel& c : channels) list.push_back(&c);
        Transform rest;
        rest.translation = {1, 2, 3};
        rest.scale = {1, 2, 1};
        const Transform t = sampled(rest, list, 0.5);
        const glm::dmat3 expected =
            rotation(order[0], angles[order[0]]) * rotation(order[1], angles[order[1]]) * rotation(order[2], angles[order[2]]);
        const glm::dmat3 actual = glm::mat3_cast(t.rotation);
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(actual[i][k], expected[i][k], 1e-12);
        EXPECT_EQ(t.translation, glm::dvec3(1, 2, 9));
        EXPECT_EQ(t.scale, glm::dvec3(1, 2, 1));
    }
}

TEST(Clip, UndrivenPropertiesRest)
{
    Transform rest;
    rest.translation = {1, 2, 3};
    rest.rotation = glm::angleAxis(1.0, glm::dvec3(0, 1, 0));
    rest.scale = {2, 2, 2};
    const Channel scale = channel(Path::Scale, 3, Interpolation::Linear, {0, 2}, {1, 1, 1, 3, 5, 7}),
                  empty = channel(Path::Translation, 3, Interpolation::Linear, {}, {});
    const Channel* list[] = {&scale, &empty};
    const Transform t = sampled(rest, list, 1);
    EXPECT_EQ(t.translation, rest.translation);
    EXPECT_EQ(t.rotation, rest.rotation);
    EXPECT_EQ(t.scale, glm::dvec3(2, 3, 4));
}

}  // namespace
}  // namespace mw
