// Figures 3.10 to 3.12: curves by subdivision of the unit square.
#include <algorithm>
#include <cmath>

#include "app/figures/figures.h"
#include "core/catalog/catalog.h"

namespace mw::figures {
namespace {

Curve square()
{
    Curve c;
    c.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    c.closed = true;
    return c;
}

Curve refined(const char* scheme, int64_t level)
{
    const Operation& op = operation("subdivide-curve");
    return std::get<Curve>(apply(op, square(), parsed(op.parameters, "levels=" + std::to_string(level) + "," + scheme)));
}

std::vector<At> places(const Curve& c)
{
    std::vector<At> at;
    for (const glm::dvec3& p : c.points) at.emplace_back(p);
    return at;
}

double areaOf(const Curve& c)
{
    double twice = 0;
    for (size_t i = 0; i < c.points.size(); ++i) {
        const glm::dvec3 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

/// The greatest angle between neighbouring segments, degrees.
double kinkOf(const Curve& c)
{
    double most = 0;
    const size_t n = c.points.size();
    for (size_t i = 0; i < n; ++i) {
        const glm::dvec3 a = c.points[(i + 1) % n] - c.points[i], b = c.points[(i + 2) % n] - c.points[(i + 1) % n];
        most = std::max(most, std::atan2(std::abs(a.x * b.y - a.y * b.x), a.x * b.x + a.y * b.y));
    }
    return most * 180 / M_PI;
}

/// How far the farthest point lies outside the square.
double outsideOf(const Curve& c)
{
    double most = 0;
    for (const glm::dvec3& p : c.points) most = std::max({most, -p.x, -p.y, p.x - 1, p.y - 1});
    return most;
}

double offControl(const Curve& c)
{
    double most = 0;
    for (const glm::dvec3& q : square().points) {
        double nearest = 1e9;
        for (const glm::dvec3& p : c.points) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
        most = std::max(most, nearest);
    }
    return most;
}

/// Black, blue, red as in the book, then others.
glm::vec4 levelColor(const Page& page, int64_t level)
{
    return level == 0   ? page.ink(Ink::Text)
           : level == 1 ? page.series(0)
           : level == 2 ? page.ink(Ink::Offender)
           : level == 3 ? page.series(4)
                        : page.ink(Ink::New);
}

struct Look {
    glm::vec4 color;
    float discs;
};

/// A panel with the control polygon under a curve.
Drawing& panel(Page& page, const Curve& c, const std::string& caption, const Look& look, float side)
{
    Drawing& d = page.drawing(caption, {side, side});
    d.window({-0.17, -0.17}, {1.17, 1.17});
    d.margin = 10;
    d.path(places(square()), Pen(page.ink(Ink::Text), 1.5f), true);
    d.path(places(c), Pen(look.color, 2.5f), true);
    if (look.discs > 0)
        for (const At& p : places(c)) d.disc(p, look.color, look.discs);
    for (const At& p : places(square())) d.disc(p, page.ink(Ink::Text), 9);
    return d;
}

/// A row of panels for some levels; numbers by level.
void levels(Page& page, const char* scheme, std::initializer_list<int64_t> which, float side)
{
    std::vector<double> counts, areas, kinks, outside, off;
    for (const int64_t level : which) {
        const Curve c = refined(scheme, level);
        const std::string name = level == 0 ? "control polygon" : "iteration " + std::to_string(level);
        const glm::vec4 color = levelColor(page, level);
        panel(page, c, name + ": N = " + std::to_string(c.points.size()),
              {color, c.points.size() <= 8    ? 8.f
                      : c.points.size() <= 32 ? 6.f
                                              : 0.f},
              side);
        counts.push_back(double(c.points.size()));
        areas.push_back(areaOf(c));
        kinks.push_back(kinkOf(c));
        outside.push_back(outsideOf(c));
        off.push_back(offControl(c));
    }
    page.numbers("N", counts);
    page.numbers("area", areas);
    page.numbers("greatest kink", kinks);
    page.numbers("outside the square", outside);
    page.numbers("distance of control points", off);
}

void badCurve(Page& page)
{
    levels(page, "scheme=positive", {0, 1, 2, 4}, 260);
    page.row();
    Plot& plot = page.plot("the kinks that are left", "iteration", "greatest angle between segments (degrees)", {560, 280});
    for (const auto& [scheme, name, color] : {std::tuple("scheme=positive", "1/8 3/8 3/8 1/8", page.ink(Ink::Offender)),
                                              std::tuple("scheme=four-point", "\u22121/16 9/16 9/16 \u22121/16", page.series(0))}) {
        std::vector<double> at, kinks;
        for (int64_t level = 0; level <= 8; ++level) {
            at.push_back(double(level));
            kinks.push_back(kinkOf(refined(scheme, level)));
        }
        plot.series(name, at, kinks, Pen(color, 2.5f), 7);
        page.numbers(std::string("kinks, ") + scheme, kinks);
    }
}

void fourPoint(Page& page)
{
    levels(page, "scheme=four-point,w=0.0625", {0, 1, 2, 3, 4}, 240);
    page.note("New points on w = 1/16: \u22121/16, 9/16, 9/16, \u22121/16. The first lie " + shortNumber(outsideOf(refined("scheme=four-point", 1))) +
              " outside the unit square.");
}

void approximation(Page& page)
{
    levels(page, "scheme=b-spline", {0, 1, 2, 4}, 270);
    page.row();
    Drawing& all = page.drawing("all of them, and where the corner (0, 0) goes", {420, 420});
    all.window({-0.08, -0.08}, {1.08, 1.08});
    all.margin = 14;
    for (const int64_t level : {0, 1, 2, 4}) {
        const glm::vec4 color = levelColor(page, level);
        all.path(places(refined("scheme=b-spline", level)), Pen(color, level == 0 ? 1.5f : 2.5f), true);
        all.lineKey(color, level == 0 ? "control polygon" : "iteration " + std::to_string(level));
    }
    std::vector<double> corner;
    TablePanel& table = page.table("the corner and the area", {"iteration", "N", "area", "corner x = y"});
    for (int64_t level = 0; level <= 8; ++level) {
        const Curve c = refined("scheme=b-spline", level);
        const glm::dvec3 p = c.points[0];
        corner.push_back(p.x);
        char area[32], x[32];
        std::snprintf(area, sizeof area, "%.4f", areaOf(c));
        std::snprintf(x, sizeof x, "%.6f", p.x);
        table.row({std::to_string(level), std::to_string(c.points.size()), area, x});
        all.disc({p.x, p.y}, page.ink(Ink::Focus), level == 0 ? 9.f : 5.f);
    }
    page.numbers("corner", corner);
}

}  // namespace

std::vector<Figure> chapter3CurveFigures()
{
    return {
        {"3.10-bad-curve", "3.10", "A mask of positive weights keeps its kinks", {"3.5"}, badCurve},
        {"3.11-four-point", "3.11", "The interpolating four-point scheme", {"3.5"}, fourPoint},
        {"3.12-approximation", "3.12", "The approximating scheme", {"3.5"}, approximation},
    };
}

}  // namespace mw::figures
