// Subdivision curves against polynomials, limit points and counts.
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/error.h"
#include "core/mesh/sample_curve.h"
#include "core/steps/stepper.h"
#include "core/subdivide/subdivide_curve.h"

namespace mw {
namespace {

Curve refined(const Curve& c, const std::string& parameters)
{
    const Operation& op = operation("subdivide-curve");
    return std::get<Curve>(apply(op, c, parsed(op.parameters, parameters)));
}

Curve ring(size_t n)
{
    Curve c;
    c.closed = true;
    for (size_t i = 0; i < n; ++i) c.points.emplace_back(std::cos(double(i * i)), std::sin(double(3 * i)), std::cos(double(2 * i)));
    return c;
}

TEST(SubdivideCurve, FourPointRepeatsCubicsAndLines)
{
    const auto cubic = [](double t) { return glm::dvec3(t, 2 * t * t * t - t * t + 3, 1 - t + t * t * t); };
    Curve c;
    for (int i = 0; i < 10; ++i) c.points.push_back(cubic(i));
    const Curve fine = refined(c, "levels=4");
    ASSERT_EQ(fine.points.size(), 9u * 16 + 1);
    // The ends have their own rule; it reaches two segments in.
    for (size_t i = 32; i <= 7 * 16; ++i) EXPECT_LT(glm::distance(fine.points[i], cubic(double(i) / 16)), 1e-10) << i;
    Curve two{{{0, 0, 0}, {2, 4, 0}}, {}, false};
    const Curve line = refined(two, "levels=3");
    for (const glm::dvec3& p : line.points) EXPECT_NEAR(p.y, 2 * p.x, 1e-12);
}

TEST(SubdivideCurve, InterpolatingSchemesKeepTheirPoints)
{
    for (const char* scheme : {"levels=3", "levels=3,w=0.125", "levels=3,scheme=positive"}) {
        const Curve c = ring(7), fine = refined(c, scheme);
        ASSERT_EQ(fine.points.size(), 56u);
        EXPECT_TRUE(fine.closed);
        for (size_t i = 0; i < 7; ++i) EXPECT_EQ(fine.points[8 * i], c.points[i]) << scheme;
    }
}

TEST(SubdivideCurve, ThePositiveMaskIsEighths)
{
    const Curve c = ring(6), fine = refined(c, "levels=1,scheme=positive");
    const auto& p = c.points;
    EXPECT_LT(glm::distance(fine.points[3], (p[0] + 3.0 * p[1] + 3.0 * p[2] + p[3]) / 8.0), 1e-15);
}

TEST(SubdivideCurve, BSplineTendsToItsLimitPoints)
{
    const Curve c = ring(8), fine = refined(c, "levels=12,scheme=b-spline");
    for (size_t i = 0; i < 8; ++i) {
        const auto& p = c.points;
        const glm::dvec3 limit = (p[(i + 7) % 8] + 4.0 * p[i] + p[(i + 1) % 8]) / 6.0;
        EXPECT_LT(glm::distance(fine.points[i << 12], limit), 1e-6);
    }
    Curve open = c;
    open.closed = false;
    const Curve ends = refined(open, "levels=3,scheme=b-spline");
    EXPECT_EQ(ends.points.front(), c.points.front());
    EXPECT_EQ(ends.points.back(), c.points.back());
}

// The uniform cubic B-spline's own basis, evaluated between the control points.
TEST(SubdivideCurve, BSplineIsTheBSpline)
{
    const Curve c = ring(9), fine = refined(c, "levels=10,scheme=b-spline");
    for (size_t i = 0; i < 9; ++i)
        for (size_t k = 0; k < 1024; k += 128) {
            const double t = double(k) / 1024, u = 1 - t;
            const auto p = [&](size_t j) { return c.points[(i + 8 + j) % 9]; };
            const glm::dvec3 spline =
                (u * u * u * p(0) + (3 * t * t * t - 6 * t * t + 4) * p(1) + (3 * u * u * u - 6 * u * u + 4) * p(2) + t * t * t * p(3)) / 6.0;
            EXPECT_LT(glm::distance(fine.points[i * 1024 + k], spline), 2e-6);
        }
}

// Both of the book's schemes as masks; any other weights against the sum written out.
TEST(SubdivideCurve, AMaskRepeatsTheSchemesItDescribes)
{
    for (const bool closed : {true, false}) {
        Curve c = ring(8);
        c.closed = closed;
        const std::pair<const char*, const char*> same[] = {{"scheme=four-point", "old=1,new=-1/16 9/16 9/16 -1/16"},
                                                            {"scheme=positive", "old=1,new=0.125 0.375 3/8 1/8"},
                                                            {"scheme=b-spline", "old=1/8 6/8 1/8,new=1/2 1/2"},
                                                            {"scheme=b-spline", "old=1/8 6/8 1/8,new=0 4/8 4/8"}};
        for (const auto& [scheme, mask] : same) {
            const Curve a = refined(c, "levels=3," + std::string(scheme)), b = refined(c, "levels=3,scheme=mask," + std::string(mask));
            ASSERT_EQ(a.points.size(), b.points.size());
            for (size_t i = 0; i < a.points.size(); ++i) EXPECT_LT(glm::distance(a.points[i], b.points[i]), 1e-14) << mask << " " << i;
        }
    }
    const Curve c = ring(9), fine = refined(c, "levels=1,scheme=mask,old=0.1 0.2 0.4 0.2 0.1,new=-0.5 1.5");
    const auto p = [&](size_t i) { return c.points[i % 9]; };
    for (size_t i = 0; i < 9; ++i) {
        EXPECT_LT(glm::distance(fine.points[2 * i], 0.1 * (p(i + 7) + p(i + 2)) + 0.2 * (p(i + 8) + p(i + 1)) + 0.4 * p(i)), 1e-14);
        EXPECT_LT(glm::distance(fine.points[2 * i + 1], 1.5 * p(i + 1) - 0.5 * p(i)), 1e-14);
    }
}

TEST(SubdivideCurve, AMaskMustSumToOne)
{
    EXPECT_EQ(weightsIn(" 1/8, 6/8 +0.125", "points"), (std::vector<double>{0.125, 0.75, 0.125}));
    for (const char* bad : {"", "1/2 1/3", "1/0", "a", "1/2 1/2x", "1 nan 0", "1 0 0 0 0 0 0 0 0 0 0 0 0 0"})
        EXPECT_THROW(weightsIn(bad, "points"), Error) << bad;
    EXPECT_THROW(refined(ring(5), "scheme=mask,old=1/2 1/2"), Error);
    try {
        weightsIn("1/2 1/4", "new points");
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("sum to 0.75"), std::string::npos) << e.what();
    }
}

double kinkAfter(const std::string& parameters)
{
    const Operation& op = operation("subdivide-curve");
    const Operation& source = operation("sample-curve");
    Stepper s(stepping(op, apply(source, {}, {}), parsed(op.parameters, parameters)));
    double kink = 0;
    while (s.forward())
        for (const Number& n : s.step().numbers)
            if (std::string_view(n.name) == "kink") kink = n.value;
    return kink;
}

TEST(SubdivideCurve, OnlyTheBadMaskKeepsItsKinks)
{
    for (const char* smooth : {"", ",scheme=b-spline", ",w=0.125"}) {
        const double ratio = kinkAfter("levels=9" + std::string(smooth)) / kinkAfter("levels=6" + std::string(smooth));
        EXPECT_LT(ratio, 0.6) << smooth;  // each level takes a share of it away
    }
    EXPECT_GT(kinkAfter("levels=9,scheme=positive") / kinkAfter("levels=6,scheme=positive"), 0.9);
}

TEST(SubdivideCurve, EveryNewPointIsAStepAndShownAtOnce)
{
    const Curve c = ring(5);
    const Operation& op = operation("subdivide-curve");
    Stepper s(stepping(op, c, parsed(op.parameters, "levels=2")));
    size_t steps = 0;
    while (s.forward()) {
        if (s.step().phase != "insert") continue;
        ++steps;
        const Curve now = std::get<Curve>(valueOf(s.value()));
        const size_t level = steps <= 5 ? 0 : 1, before = level ? 10u : 5u, done = level ? steps - 5 : steps;
        EXPECT_EQ(now.points.size(), before + done);
        for (const Focus& f : s.step().focus)
            if (f.kind == ElementKind::Vertex) {
                EXPECT_EQ(f.index, 2 * done - 1);
            }
    }
    EXPECT_EQ(steps, 15u);
}

TEST(SubdivideCurve, RefusesWhatItCannotDo)
{
    EXPECT_THROW(refined(Curve{}, ""), Error);
    EXPECT_THROW(refined(Curve{{{0, 0, 0}, {1, 0, 0}}, {}, true}, ""), Error);
    Curve many;
    many.points.resize(100000, glm::dvec3(0));
    EXPECT_THROW(refined(many, "levels=16"), Error);
    EXPECT_EQ(refined(ring(5), "levels=0").points.size(), 5u);
    EXPECT_EQ(refined(ring(5), "ends=open,levels=1").points.size(), 9u);
}

TEST(SampleCurve, PointsAreReadFromText)
{
    const Operation& op = operation("sample-curve");
    const Curve c = std::get<Curve>(apply(op, {}, parsed(op.parameters, "given=0,0 1,2 3,-1e1,5,closed=true")));
    ASSERT_EQ(c.points.size(), 3u);
    EXPECT_EQ(c.points[2], glm::dvec3(3, -10, 5));
    EXPECT_TRUE(c.closed);
    EXPECT_THROW(pointsIn("1,2 3"), Error);
    EXPECT_THROW(pointsIn("1,2,3,4"), Error);
    EXPECT_THROW(pointsIn("1,x"), Error);
    EXPECT_THROW(pointsIn("1,nan"), Error);
    for (const char* shape : {"zigzag", "wave", "polygon", "star", "spiral", "letter"}) {
        const Curve s = std::get<Curve>(apply(op, {}, {{"shape", std::string(shape)}, {"points", int64_t(11)}}));
        EXPECT_EQ(s.points.size(), shape == std::string("letter") ? 9u : 11u);
        for (const glm::dvec3& p : s.points) EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1.0);
    }
}

}  // namespace
}  // namespace mw
