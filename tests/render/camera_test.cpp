// The camera's moves keep what they promise to keep.
#include "render/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace mw {
namespace {

constexpr glm::dvec2 size{1280, 800};

Camera someCamera(bool perspective)
{
    Camera c;
    c.target = {1, 2, -3};
    c.distance = 7;
    c.azimuth = 0.9;
    c.elevation = -0.4;
    c.perspective = perspective;
    return c;
}

class CameraTest : public testing::TestWithParam<bool> {};

TEST_P(CameraTest, RayIsTheInverseOfProject)
{
    const Camera c = someCamera(GetParam());
    for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(640, 400), glm::dvec2(1000, 17.5), glm::dvec2(3, 799)}) {
        const Ray r = c.ray(pixel, size);
        EXPECT_NEAR(glm::length(r.direction), 1, 1e-12);
        for (const double t : {0.5, 4.0, 90.0}) {
            const glm::dvec3 back = c.project(r.origin + t * r.direction, size);
            EXPECT_NEAR(back.x, pixel.x, 1e-6);
            EXPECT_NEAR(back.y, pixel.y, 1e-6);
        }
    }
}

TEST_P(CameraTest, EyeIsTheOriginOfTheView)
{
    const Camera c = someCamera(GetParam());
    EXPECT_NEAR(glm::length(glm::dvec3(c.viewFromWorld() * glm::dvec4(c.eye(), 1))), 0, 1e-12);
    const glm::dvec3 p = c.project(c.target, size);
    EXPECT_NEAR(p.x, 640, 1e-9);
    EXPECT_NEAR(p.y, 400, 1e-9);
}

TEST_P(CameraTest, OrbitKeepsThePivotWhereItIsOnScreen)
{
    Camera c = someCamera(GetParam());
    const glm::dvec3 pivot{1.7, 1.1, -2.2};
    const glm::dvec3 before = c.project(pivot, size);
    c.orbit({137, -61}, pivot);
    c.orbit({-300, 900}, pivot);  // runs into the pole
    const glm::dvec3 after = c.project(pivot, size);
    EXPECT_NEAR(before.x, after.x, 1e-7);
    EXPECT_NEAR(before.y, after.y, 1e-7);
    EXPECT_LE(c.elevation, 0.5 * std::numbers::pi);
}

TEST_P(CameraTest, ZoomKeepsWhatIsUnderTheCursor)
{
    Camera c = someCamera(GetParam());
    const glm::dvec2 pixel{311, 650};
    const Ray r = c.ray(pixel, size);
    const glm::dvec3 under = r.origin + 5.0 * r.direction;
    c.zoom(3, pixel, size);
    EXPECT_LT(c.distance, 7);
    const glm::dvec3 after = c.project(under, size);
    EXPECT_NEAR(after.x, pixel.x, 1e-6);
    EXPECT_NEAR(after.y, pixel.y, 1e-6);
}

TEST_P(CameraTest, PanMovesTheTargetWithTheCursor)
{
    Camera c = someCamera(GetParam());
    const glm::dvec3 held = c.target;
    c.pan({25, -40}, size);
    const glm::dvec3 after = c.project(held, size);
    EXPECT_NEAR(after.x, 640 + 25, 1e-6);
    EXPECT_NEAR(after.y, 400 - 40, 1e-6);
}

TEST_P(CameraTest, FrameFitsAndFills)
{
    for (const glm::dvec3 extent : {glm::dvec3(1, 1, 1), glm::dvec3(100, 0.1, 3), glm::dvec3(1e-3, 5e-3, 0)}) {
        Camera c = someCamera(GetParam());
        Bounds b;
        b.add(glm::dvec3(10, 20, 30));
        b.add(glm::dvec3(10, 20, 30) + extent);
        c.frame(b, size.x / size.y);
        double reach = 0;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner{i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
            const glm::dvec3 p = c.project(corner, size);
            EXPECT_TRUE(p.z > 0 && p.z < 1) << p.z;
            reach = std::max({reach, std::abs(p.x / size.x - 0.5), std::abs(p.y / size.y - 0.5)});
        }
        EXPECT_LT(reach, 0.5);
        EXPECT_GT(reach, 0.4);  // and it fills the view
    }
}

INSTANTIATE_TEST_SUITE_P(Projections, CameraTest, testing::Bool());

TEST(CameraViews, NamesAndAngles)
{
    Camera c;
    c.distance = 2;
    ASSERT_TRUE(setView(c, "front"));
    EXPECT_NEAR(glm::length(c.eye() - glm::dvec3(0, 0, 2)), 0, 1e-12);
    ASSERT_TRUE(setView(c, "right"));
    EXPECT_NEAR(glm::length(c.eye() - glm::dvec3(2, 0, 0)), 0, 1e-12);
    ASSERT_TRUE(setView(c, "top"));
    EXPECT_NEAR(glm::length(c.eye() - glm::dvec3(0, 2, 0)), 0, 1e-12);
    ASSERT_TRUE(setView(c, "30,-12.5"));
    EXPECT_NEAR(c.azimuth, std::numbers::pi / 6, 1e-12);
    EXPECT_FALSE(setView(c, "sideways"));
    EXPECT_FALSE(setView(c, "1,"));
    EXPECT_FALSE(setView(c, "1,91"));
    EXPECT_FALSE(setView(c, "nan,0"));
}

}  // namespace
}  // namespace mw
