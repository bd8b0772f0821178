// Measures against closed forms, Euler angles against the rotation they make.
#include "core/math/measure.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>
#include <random>

#include "core/math/euler.h"

namespace mw {
namespace {

const double pi = glm::pi<double>();

glm::dvec3 anyPoint(std::mt19937& r, double reach = 5)
{
    std::uniform_real_distribution<double> u(-reach, reach);
    const double x = u(r), y = u(r), z = u(r);
    return {x, y, z};
}

TEST(Measure, AnglesOfKnownTriangles)
{
    EXPECT_NEAR(angleAt({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), pi / 2, 1e-15);
    EXPECT_NEAR(angleAt({1, 1, 1}, {2, 1, 1}, {1 + 0.5, 1 + std::sqrt(3) / 2, 1}), pi / 3, 1e-15);
    EXPECT_NEAR(angleAt({0, 0, 0}, {1, 0, 0}, {-1, 1e-9, 0}), pi - 1e-9, 1e-15);  // nearly straight, where an arc cosine fails
    EXPECT_NEAR(angleAt({0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}), 1e-9, 1e-20);
    EXPECT_EQ(angleAt({0, 0, 0}, {0, 0, 0}, {1, 0, 0}), 0);
}

TEST(Measure, AreaIsHerons)
{
    std::mt19937 r(7);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 a = anyPoint(r), b = anyPoint(r), c = anyPoint(r);
        const double x = glm::distance(a, b), y = glm::distance(b, c), z = glm::distance(c, a), s = (x + y + z) / 2;
        EXPECT_NEAR(triangleArea(a, b, c), std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z))), 1e-6);
        EXPECT_NEAR(angleAt(a, b, c) + angleAt(b, c, a) + angleAt(c, a, b), pi, 1e-9);
    }
}

TEST(Measure, BarycentricsMixToThePoint)
{
    std::mt19937 r(11);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 a = anyPoint(r), b = anyPoint(r), c = anyPoint(r), w0 = anyPoint(r, 2);
        const glm::dvec3 w(w0.x, w0.y, 1 - w0.x - w0.y);
        const glm::dvec3 inPlane = w.x * a + w.y * b + w.z * c;
        const glm::dvec3 off = inPlane + anyPoint(r).x * glm::normalize(glm::cross(b - a, c - a));  // projected back
        const glm::dvec3 got = barycentric(off, a, b, c);
        EXPECT_LT(glm::length(got - w), 1e-6 * (1 + 25 / triangleArea(a, b, c)));
        EXPECT_NEAR(got.x + got.y + got.z, 1, 1e-12);
    }
    EXPECT_TRUE(std::isnan(barycentric({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}).x));
}

TEST(Euler, MakeTheSameRotation)
{
    std::mt19937 r(3);
    const auto check = [](const glm::dquat& q, double within) {
        const glm::dquat back(eulerAnglesOf(q));
        EXPECT_NEAR(std::abs(glm::dot(q, back)), 1, within);
        for (const glm::dvec3 v : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) EXPECT_LT(glm::length(q * v - back * v), 1e-8);
    };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 v = anyPoint(r), w = anyPoint(r);
        check(glm::normalize(glm::dquat(v.x, v.y, v.z, w.x)), 1e-14);
    }
    for (const double y : {pi / 2, -pi / 2})  // where X and Z turn about one line
        for (const double x : {0.0, 0.3, -2.0, pi})
            for (const double z : {0.0, 1.1, -0.7}) check(glm::dquat(glm::dvec3(x, y, z)), 1e-14);
}

}  // namespace
}  // namespace mw
