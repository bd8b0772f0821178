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

void check(const Curve& input, bool closed, int64_t levels)
{
    const size_t n = input.points.size();
    if (n < (closed ? 3u : 2u)) throw Error(closed ? "a closed curve wants three points or more" : "a curve wants two points or more");
    if (double(n) * std::pow(2.0, double(levels)) > double(mostPoints))
        throw Error("the curve would have more than " + std::to_string(mostPoints) + " points; take fewer levels");
}

}  // namespace mw::curves
