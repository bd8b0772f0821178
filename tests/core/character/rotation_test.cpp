// Paths between orientations against closed forms.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/character/interpolate_rotation.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

Rotations paths(const std::string& parameters)
{
    const Operation& op = operation("interpolate-rotation");
    return std::get<Rotations>(apply(op, {}, parsed(op.parameters, parameters)));
}

const std::vector<Rotations::Sample>& path(const Rotations& r, std::string_view name)
{
    for (const Rotations::Path& p : r.paths)
        if (name == p.name) return p.samples;
    throw std::runtime_error("no such path");
}

// The angle between two orientations by the trace of the matrix between them (6.7).
double angleBetween(const glm::dquat& a, const glm::dquat& b)
{
    const glm::dmat3 m = glm::transpose(glm::mat3_cast(a)) * glm::mat3_cast(b);
    const glm::dvec3 w(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]);
    return std::atan2(glm::length(w), m[0][0] + m[1][1] + m[2][2] - 1);
}

TEST(InterpolateRotation, AllPathsLeadFromStartToEnd)
{
    const Rotations r = paths("from=10/-40/80,to=120/50/-30,order=yxz,samples=9");
    ASSERT_EQ(r.paths.size(), 3u);
    // Intrinsic yxz: Ry Rx Rz, written as matrices.
    const auto matrix = [](double x, double y, double z) {
        x = glm::radians(x), y = glm::radians(y), z = glm::radians(z);
        const glm::dmat3 rx(1, 0, 0, 0, std::cos(x), std::sin(x), 0, -std::sin(x), std::cos(x));
        const glm::dmat3 ry(std::cos(y), 0, -std::sin(y), 0, 1, 0, std::sin(y), 0, std::cos(y));
        const glm::dmat3 rz(std::cos(z), std::sin(z), 0, -std::sin(z), std::cos(z), 0, 0, 0, 1);
        return ry * rx * rz;
    };
    for (const Rotations::Path& p : r.paths) {
        ASSERT_EQ(p.samples.size(), 9u);
        const glm::dmat3 first = glm::mat3_cast(p.samples.front().orientation), last = glm::mat3_cast(p.samples.back().orientation);
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(glm::distance(glm::column(first, c), glm::column(matrix(10, -40, 80), c)), 1e-12) << p.name;
            EXPECT_LT(glm::distance(glm::column(last, c), glm::column(matrix(120, 50, -30), c)), 1e-12) << p.name;
        }
    }
    const Rotations::Sample& middle = path(r, "euler")[4];
    EXPECT_EQ(middle.euler, glm::dvec3(65, 5, 25));
    EXPECT_TRUE(std::isnan(path(r, "slerp")[4].euler.x));
}

TEST(InterpolateRotation, SlerpHasConstantSpeedAndOneAxis)
{
    for (const char* to : {"100/20/-60", "0/0/30", "0/0/179.9", "0.001/0/0"}) {
        const Rotations r = paths("from=0/0/0,samples=33,to=" + std::string(to));
        const auto& s = path(r, "slerp");
        const double whole = angleBetween(r.from, r.to);
        for (size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(angleBetween(s[0].orientation, s[i].orientation), whole * s[i].t, 1e-7) << to;
        for (size_t i = 0; i + 1 < s.size(); ++i)
            EXPECT_NEAR(angleBetween(s[i].orientation, s[i + 1].orientation), whole / 32, 1e-7) << to;  // steps add up: one axis
    }
}

TEST(InterpolateRotation, NlerpFollowsTheTangentFormula)
{
    const Rotations r = paths("from=0/0/0,to=0/0/170,samples=41");
    const double om = glm::radians(85.0);
    for (const Rotations::Sample& s : path(r, "nlerp"))
        EXPECT_NEAR(angleBetween(r.from, s.orientation), 2 * std::atan2(s.t * std::sin(om), 1 - s.t + s.t * std::cos(om)), 1e-9);

    // Slow at the ends, fast in the middle: the formula's derivative at t = 0 and t = 1/2, as shares of the mean speed.
    const Operation& op = operation("interpolate-rotation");
    Stepper steps(stepping(op, {}, parsed(op.parameters, "from=0/0/0,to=0/0/170,samples=41")));
    double slowest = 1e9, fastest = 0;
    while (steps.forward()) {
        if (steps.step().phase != "nlerp") continue;
        for (const Number& n : steps.step().numbers)
            if (std::string_view(n.name) == "speed") slowest = std::min(slowest, n.value / 170), fastest = std::max(fastest, n.value / 170);
    }
    EXPECT_NEAR(slowest, std::sin(om) / om, 1e-6);
    EXPECT_NEAR(fastest, 2 * std::tan(om / 2) / om, 1e-6);
}

TEST(InterpolateRotation, TheShorterWayIsNeverBeyondHalfATurn)
{
    const auto length = [](const Rotations& r) {
        double sum = 0;
        const auto& s = path(r, "slerp");
        for (size_t i = 0; i + 1 < s.size(); ++i) sum += angleBetween(s[i].orientation, s[i + 1].orientation);
        return glm::degrees(sum);
    };
    EXPECT_NEAR(length(paths("from=0/0/0,to=0/0/250,samples=50")), 110, 1e-6);
    EXPECT_NEAR(length(paths("from=0/0/0,to=0/0/250,samples=50,shorter=false")), 250, 1e-6);
    EXPECT_NEAR(length(paths("from=0/0/0,to=0/0/100,samples=50,shorter=false")), 260, 1e-6);
}

}  // namespace
}  // namespace mw
