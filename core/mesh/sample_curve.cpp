#include "core/mesh/sample_curve.h"

#include <charconv>
#include <cmath>

#include "core/error.h"

namespace mw {

namespace {

glm::dvec3 pointIn(std::string_view word, size_t index)
{
    glm::dvec3 p(0);
    const auto refuse = [&] {
        throw Error("point " + std::to_string(index + 1) + ", \"" + std::string(word.substr(0, 40)) + "\", is not x,y or x,y,z with finite numbers");
    };
    std::string_view rest = word;
    for (int k = 0;; ++k) {
        const size_t comma = rest.find(',');
        const std::string_view number = rest.substr(0, comma);
        if (k > 2) refuse();
        const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), p[k]);
        if (failure != std::errc() || end != number.data() + number.size() || !std::isfinite(p[k])) refuse();
        if (comma == rest.npos) {
            if (k == 0) refuse();
            return p;
        }
        rest.remove_prefix(comma + 1);
    }
}

glm::dvec3 shapePoint(SampleCurve::Shape shape, size_t i, size_t n)
{
    const double t = double(i) / double(n - 1), around = 2 * M_PI * double(i) / double(n);
    switch (shape) {
        case SampleCurve::Shape::Zigzag:
            return {2 * t - 1, i % 2 ? 0.5 : -0.5, 0};
        case SampleCurve::Shape::Wave:
            return {2 * t - 1, 0.6 * std::sin(2 * M_PI * t), 0};
        case SampleCurve::Shape::Polygon:
            return {std::cos(around), std::sin(around), 0};
        case SampleCurve::Shape::Star: {
            const double r = i % 2 ? 0.45 : 1;
            return {r * std::sin(around), r * std::cos(around), 0};
        }
        case SampleCurve::Shape::Spiral:
            return {(0.1 + 0.9 * t) * std::cos(4 * M_PI * t), (0.1 + 0.9 * t) * std::sin(4 * M_PI * t), 0};
        case SampleCurve::Shape::Letter:
            break;
    }
    static constexpr double s[9][2] = {{0.6, 0.8}, {0.1, 1}, {-0.6, 0.8}, {-0.6, 0.2}, {0, 0}, {0.6, -0.2}, {0.6, -0.8}, {-0.1, -1}, {-0.6, -0.8}};
    return {s[i][0], s[i][1], 0};
}

}  // namespace

Array<glm::dvec3> pointsIn(std::string_view text)
{
    constexpr std::string_view gaps = " \t\r\n;";
    Array<glm::dvec3> points;
    while (true) {
        const size_t begin = text.find_first_not_of(gaps);
        if (begin == text.npos) return points;
        text.remove_prefix(begin);
        const std::string_view word = text.substr(0, text.find_first_of(gaps));
        points.push_back(pointIn(word, points.size()));
        text.remove_prefix(word.size());
    }
}

Generator sampleCurve(SampleCurve p, Stage<Curve>& stage)
{
    Curve c;
    c.points = pointsIn(p.given);
    const bool ring = p.shape == SampleCurve::Shape::Polygon || p.shape == SampleCurve::Shape::Star;
    c.closed = p.closed || (c.points.empty() && ring);
    const size_t n = p.shape == SampleCurve::Shape::Letter ? 9 : size_t(p.points);
    if (c.points.empty())
        for (size_t i = 0; i < n; ++i) c.points.push_back(shapePoint(p.shape, i, n));
    stage.finish(std::move(c));
    co_return;
}

}  // namespace mw
