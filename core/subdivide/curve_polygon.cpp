#include "core/subdivide/curve_polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/error.h"

namespace mw::curves {

size_t segments(size_t points, bool closed)
{
    return closed ? points : points - 1;
}

double greatestKink(const Points& p, bool closed)
{
    double most = 0;
    const Polygon polygon(p, closed);
    for (size_t i = 0; i < p.size(); ++i) {
        if (!polygon.moves(i)) continue;
        const glm::dvec3 a = p[i] - polygon.at(int64_t(i) - 1), b = polygon.at(int64_t(i) + 1) - p[i];
        most = std::max(most, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
    return glm::degrees(most);
}

Refining::Refining(const Curve& input, const SubdivideCurve& how)
    : old(input.points),
      closed(how.ends == SubdivideCurve::Ends::AsGiven ? input.closed : how.ends == SubdivideCurve::Ends::Closed),
      control_(input.control.empty() ? input.points : input.control),
      levels_(how.levels)
{
    const size_t n = old.size();
    if (n < (closed ? 3u : 2u)) throw Error(closed ? "a closed curve wants three points or more" : "a curve wants two points or more");
    if (double(n) * std::pow(2.0, double(levels_)) > double(mostPoints))
        throw Error("the curve would have more than " + std::to_string(mostPoints) + " points; take fewer levels");
}

Curve Refining::asItStands() const
{
    Curve c{fresh, control_, closed};
    c.points.insert(c.points.end(), old.begin() + ptrdiff_t(taken), old.end());
    return c;
}

Step Refining::endLevel(int64_t level, bool measured)
{
    old = std::move(fresh);
    fresh.clear();
    taken = 0;
    return Step("level")
        .number("level", double(level))
        .number("points", double(old.size()))
        .number("kink", measured ? greatestKink(old, closed) : 0)
        .progress(double(level) / double(levels_));
}

}  // namespace mw::curves
