// The focus of a step as marks, ranges of heat maps, texts of ticks and labels.
#include <cmath>
#include <gtest/gtest.h>

#include "render/colors.h"
#include "render/overlay.h"
#include "render/value_frame.h"

#include "shapes.h"

namespace mw {
namespace {

using namespace test;

TEST(Labels, OfASmallElementLieApart)
{
    const glm::vec2 picture(640, 480), extent(80, 21), point(320, 240);
    std::vector<Rectangle> taken;
    for (int i = 0; i < 9; ++i) ASSERT_TRUE(placeLabel(point + glm::vec2(2 * i, i), extent, 9, picture, taken)) << i;
    ASSERT_EQ(taken.size(), 9u);
    for (size_t i = 0; i < taken.size(); ++i) {
        EXPECT_EQ(taken[i].high - taken[i].low, extent);
        EXPECT_TRUE(taken[i].low.x >= 0 && taken[i].low.y >= 0 && taken[i].high.x <= picture.x && taken[i].high.y <= picture.y) << i;
        for (size_t k = 0; k < i; ++k)
            EXPECT_FALSE(taken[i].low.x < taken[k].high.x && taken[k].low.x < taken[i].high.x && taken[i].low.y < taken[k].high.y &&
                         taken[k].low.y < taken[i].high.y)
                << i << " over " << k;
    }
    // The first one is where it has always been, and what finds no room is left out.
    EXPECT_EQ(taken[0].low, point + glm::vec2(9));
    while (placeLabel(point, extent, 9, picture, taken) && taken.size() < 1000) continue;
    EXPECT_LT(taken.size(), 1000u);
}

TEST(Focus, RolesDifferInShapeAndColour)
{
    StepRecord step;
    step.focus = {{ElementKind::Edge, Role::Current, "e", 4, 5, {}, {}},         {ElementKind::Vertex, Role::Neighbour, nullptr, 1, 0, {}, {}},
                  {ElementKind::Vertex, Role::Neighbour, nullptr, 2, 0, {}, {}}, {ElementKind::Face, Role::Removed, nullptr, 1, 0, {}, {}},
                  {ElementKind::Edge, Role::Rejected, nullptr, 0, 1, {}, {}},    {ElementKind::Point, Role::New, "p", 0, 0, {0, 2, 0}, {}},
                  {ElementKind::Vertex, Role::Current, "gone", 999, 0, {}, {}}};
    Frame frame;
    glm::dmat4 world(1);
    world[3] = {10, 0, 0, 1};
    addFocus(frame, step, quadCube(), NodeId{3}, world);
    ASSERT_EQ(frame.marks.size(), 4u);
    for (const Mark& m : frame.marks) {
        EXPECT_EQ(m.node, NodeId{3});
        EXPECT_TRUE(m.kind != ElementKind::Vertex || m.indices == (std::vector<uint32_t>{1, 2}));
        EXPECT_EQ(m.style == Mark::Style::Hatched, m.kind == ElementKind::Face);
        EXPECT_EQ(m.style == Mark::Style::Dashed, m.kind == ElementKind::Edge && m.indices[0] == 0);
    }
    ASSERT_EQ(frame.points.size(), 1u);
    EXPECT_EQ(frame.points[0].atWorld, glm::vec3(10, 2, 0));
    ASSERT_EQ(frame.labels.size(), 2u);
    EXPECT_EQ(frame.labels[0].text, "e");
    EXPECT_EQ(frame.labels[0].atWorld, glm::vec3(10, -1, 1));  // the middle of the edge
    EXPECT_EQ(glm::vec3(frame.labels[0].color), roleColor(Role::Current));
}

// Two links along x from the origin, each 1 long, and a target above the end.
Pose arm()
{
    Skeleton s;
    for (uint32_t i = 0; i < 3; ++i) s.joints.push_back({"j" + std::to_string(i), i ? i - 1 : none, {}, NodeId{i + 1}, false});
    Pose p;
    p.skeleton = std::make_shared<Skeleton>(s);
    p.locals.resize(3);
    p.locals[1].translation = p.locals[2].translation = {1, 0, 0};
    p.targets = {{2, {2, 1, 0}}};
    return p;
}

TEST(Focus, JointsOfAPoseAreMarkedWhereTheyStand)
{
    StepRecord step;
    step.focus = {{ElementKind::Joint, Role::Current, "e", 2, 0, {}, {}},
                  {ElementKind::Edge, Role::New, nullptr, 0, 1, {}, {}},
                  {ElementKind::Joint, Role::Current, nullptr, 3, 0, {}, {}},
                  {ElementKind::Vertex, Role::Current, nullptr, 0, 0, {}, {}}};
    Frame frame;
    addFocus(frame, step, arm(), {}, glm::dmat4(1));
    ASSERT_EQ(frame.points.size(), 2u);
    EXPECT_EQ(frame.points[0].atWorld, glm::vec3(2, 0, 0));
    EXPECT_TRUE(frame.points[0].through);
    EXPECT_EQ(frame.points[1].toWorld, glm::vec3(1, 0, 0));
    const Bounds b = focusBounds(step, arm(), glm::dmat4(1));
    EXPECT_EQ(b.min, glm::dvec3(0));
    EXPECT_EQ(b.max, glm::dvec3(2, 0, 0));
}

TEST(Focus, SamplesAndCellsOfAHeightMap)
{
    StepRecord step;
    step.focus = {{ElementKind::Vertex, Role::Current, nullptr, 4, 0, {}, {}},
                  {ElementKind::Cell, Role::Neighbour, nullptr, 3, 0, {}, {}},
                  {ElementKind::Cell, Role::Neighbour, nullptr, 4, 0, {}, {}}};
    const HeightMap small = HeightMap::flat(3, 3, 1);
    Frame frame;
    addValue(frame, small, NodeId{1}, glm::dmat4(1));
    addFocus(frame, step, small, NodeId{1}, glm::dmat4(1));
    ASSERT_EQ(frame.marks.size(), 2u);
    EXPECT_EQ(frame.marks[0].indices, std::vector<uint32_t>{3});
    // Face 3 of the grid has the four samples of cell 3.
    const Mesh& grid = frame.objects.at(0).mesh;
    Bounds cell;
    for (const uint32_t v : grid.face(3)) cell.add(glm::dvec3(grid.positions()[v]));
    EXPECT_EQ(cell.min.x, 0);
    EXPECT_EQ(cell.min.z, 0);
    EXPECT_EQ(cell.max.x, 0.5);
    EXPECT_GT(grid.faceNormals()[3].y, 0.99f);

    // One too large to be drawn sample by sample: marks by place.
    const HeightMap large = HeightMap::flat(1025, 1025, 0);
    Frame far;
    addValue(far, large, NodeId{1}, glm::dmat4(1));
    addFocus(far, step, large, NodeId{1}, glm::dmat4(1));
    EXPECT_TRUE(far.marks.empty());
    EXPECT_EQ(far.points.size(), 1u + 4 + 4);
    EXPECT_LE(far.objects.at(0).mesh.faceCount(), 256u * 256);
}

TEST(Values, EachKindIsDrawnWithinItsBounds)
{
    Frame frame;
    addValue(frame, arm(), NodeId{9}, glm::dmat4(1));
    ASSERT_EQ(frame.bones.size(), 3u);  // two links and the joint at their end
    EXPECT_EQ(frame.bones[1].head, glm::vec3(1, 0, 0));
    EXPECT_EQ(frame.bones[1].tail, glm::vec3(2, 0, 0));
    EXPECT_EQ(frame.bones[1].node, NodeId{2});
    EXPECT_EQ(boundsOf(frame).max, glm::dvec3(2, 0, 0));

    Frame curve;
    addValue(curve, Curve{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {2, 2, 0}}, true}, NodeId{9}, glm::dmat4(1));
    ASSERT_EQ(curve.objects.size(), 2u);
    EXPECT_EQ(curve.objects[1].mesh.lines().size(), 6u);  // closed
    EXPECT_EQ(curve.objects[1].node, NodeId{9});
    EXPECT_EQ(boundsOf(curve).max, glm::dvec3(2, 2, 0));

    Rotations r;
    r.to = aboutAxis(2, 1);
    r.paths = {{"slerp", {{0, r.from, {}}, {0.5, aboutAxis(2, 0.5), {}}, {1, r.to, {}}}}};
    Frame sphere;
    addValue(sphere, r, NodeId{9}, glm::dmat4(1));
    size_t path = 0;
    for (const MarkPoint& p : sphere.points)
        if (p.toWorld && p.diameter == 3) {
            ++path;
            EXPECT_NEAR(glm::length(p.atWorld), 1, 1e-6);  // traced on the sphere, in the plane of the turn
            EXPECT_NEAR(p.atWorld.z, 0, 1e-6);
        }
    EXPECT_EQ(path, 2u);
    for (const Value& none : {Value{}, Value{Table{}}, Value{ElementSet{}}}) {
        Frame nothing;
        addValue(nothing, none, NodeId{9}, glm::dmat4(1));
        EXPECT_TRUE(nothing.objects.empty() && nothing.points.empty() && nothing.bones.empty());
        EXPECT_FALSE(isDrawable(none));
    }
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
