// The focus of a step as marks, ranges of heat maps, texts of ticks and labels.
#include <cmath>
#include <gtest/gtest.h>

#include "render/colors.h"
#include "render/overlay.h"

#include "shapes.h"

namespace mw {
namespace {

using namespace test;

TEST(Focus, RolesDifferInShapeAndColour)
{
    StepRecord step;
    step.focus = {{ElementKind::Edge, Role::Current, "e", 4, 5, {}, {}},         {ElementKind::Vertex, Role::Neighbour, nullptr, 1, 0, {}, {}},
                  {ElementKind::Vertex, Role::Neighbour, nullptr, 2, 0, {}, {}}, {ElementKind::Face, Role::Removed, nullptr, 1, 0, {}, {}},
                  {ElementKind::Edge, Role::Rejected, nullptr, 0, 1, {}, {}},    {ElementKind::Point, Role::New, "p", 0, 0, {0, 2, 0}, {}},
                  {ElementKind::Vertex, Role::Current, "gone", 999, 0, {}, {}}};
    std::vector<Mark> marks;
    std::vector<MarkPoint> points;
    std::vector<Label> labels;
    glm::dmat4 world(1);
    world[3] = {10, 0, 0, 1};
    addFocus(step, quadCube(), NodeId{3}, world, marks, points, labels);
    ASSERT_EQ(marks.size(), 4u);
    for (const Mark& m : marks) {
        EXPECT_EQ(m.node, NodeId{3});
        EXPECT_TRUE(m.kind != ElementKind::Vertex || m.indices == (std::vector<uint32_t>{1, 2}));
        EXPECT_EQ(m.style == Mark::Style::Hatched, m.kind == ElementKind::Face);
        EXPECT_EQ(m.style == Mark::Style::Dashed, m.kind == ElementKind::Edge && m.indices[0] == 0);
    }
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].atWorld, glm::vec3(10, 2, 0));
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_EQ(labels[0].text, "e");
    EXPECT_EQ(labels[0].atWorld, glm::vec3(10, -1, 1));  // the middle of the edge
    EXPECT_EQ(glm::vec3(labels[0].color), roleColor(Role::Current));
}

TEST(HeatRange, LeavesOutTheExtremes)
{
    Column c;
    for (int i = 0; i <= 1000; ++i) c.values.push_back(i);
    c.values.push_back(std::nan(""));
    EXPECT_EQ(heatRange(c), (std::pair<double, double>(20, 980)));
    c.values.assign(100, 6.0);
    c.values[3] = 7;
    EXPECT_EQ(heatRange(c), (std::pair<double, double>(6, 7)));  // nearly constant: all of it
    c.values.assign(4, 2.0);
    EXPECT_EQ(heatRange(c), (std::pair<double, double>(2, 2)));
    c.values.assign(4, std::nan(""));
    EXPECT_EQ(heatRange(c), (std::pair<double, double>(0, 1)));
    c.values = {-3, -1, 0, 1, 1};
    EXPECT_EQ(heatRange(c), (std::pair<double, double>(-3, 3)));  // both signs: zero in the middle
}

TEST(Legend, BarsCountEveryFiniteValue)
{
    Column c;
    c.values = {-5, 0, 0.1, 0.99, 1, 7, std::nan("")};
    EXPECT_EQ(histogramOf(c, 0, 1, 4), (std::vector<size_t>{3, 0, 0, 3}));
    EXPECT_EQ(tickText(0), "0");
    EXPECT_EQ(tickText(0.025), "0.025");
    EXPECT_EQ(tickText(-1234.5), "\u22121.23e+03");
    EXPECT_EQ(tickText(980), "980");
}

TEST(Letters, BrokenTextIsNoTrouble)
{
    std::string_view s = "a\u2265\xF0\x9F\x98\x80";
    EXPECT_EQ(nextLetter(s), U'a');
    EXPECT_EQ(nextLetter(s), U'\u2265');
    EXPECT_EQ(nextLetter(s), U'\U0001F600');
    EXPECT_TRUE(s.empty());
    std::string_view broken = "\xE2\x89x\xFF\xC3";
    std::u32string letters;
    while (!broken.empty()) letters += nextLetter(broken);
    EXPECT_EQ(letters, U"\uFFFDx\uFFFD\uFFFD");
}

TEST(Views, FrameTightlyShowsEveryVertex)
{
    Frame f = frameWith(sphere(3));
    f.camera.azimuth = 1;
    f.camera.elevation = 0.4;
    for (const bool perspective : {true, false}) {
        f.camera.perspective = perspective;
        frameTightly(f, 1.6);
        double reach = 0;
        for (const glm::vec3& p : f.objects[0].mesh.positions()) {
            const glm::dvec3 at = f.camera.project(p, {1600, 1000});
            reach = std::max({reach, std::abs(at.x / 1600 - 0.5), std::abs(at.y / 1000 - 0.5)});
        }
        EXPECT_GT(reach, 0.45);
        EXPECT_LT(reach, 0.5);
    }
}

}  // namespace
}  // namespace mw
