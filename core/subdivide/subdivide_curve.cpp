#include "core/subdivide/subdivide_curve.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/subdivide/curve_mask.h"
#include "core/subdivide/curve_polygon.h"

namespace mw {

namespace {

using namespace curves;

Generator byScheme(Curve input, SubdivideCurve p, Stage<Curve>& stage)
{
    Refining at(input, p);
    const double w = p.scheme == SubdivideCurve::Scheme::Positive ? -0.125 : p.w;
    const bool spline = p.scheme == SubdivideCurve::Scheme::BSpline;
    stage.show([&at] { return at.asItStands(); });
    size_t made = 0;
    const Points& old = at.old;
    Points& fresh = at.fresh;
    for (int64_t level = 1; level <= p.levels; ++level) {
        const Polygon polygon(old, at.closed);
        const size_t n = old.size();
        for (size_t i = 0; i < n; ++i) {
            const auto k = int64_t(i);
            const double done = at.done(level, i);
            glm::dvec3 point = old[i];
            if (spline && polygon.moves(i)) {
                const glm::dvec3 before = polygon.at(k - 1), after = polygon.at(k + 1);
                point = (before + 6.0 * old[i] + after) / 8.0;
                fresh.push_back(point);
                at.taken = i + 1;
                if (stage.watched() || (++made & 1023) == 0)
                    co_yield Step("move")
                        .segment(glm::vec3(old[i]), glm::vec3(point), Role::Removed)
                        .point(glm::vec3(before), Role::Neighbour, "a")
                        .point(glm::vec3(old[i]), Role::Current, "b")
                        .point(glm::vec3(after), Role::Neighbour, "c")
                        .vertex(uint32_t(fresh.size() - 1), Role::New, "v")
                        .number("level", double(level))
                        .number("index", double(i))
                        .number("moved", glm::distance(old[i], point))
                        .progress(done);
            } else {
                fresh.push_back(point);
                at.taken = i + 1;
            }
            if (i >= segments(n, at.closed)) continue;
            const glm::dvec3 a = polygon.at(k - 1), b = old[i], c = polygon.at(k + 1), d = polygon.at(k + 2);
            const glm::dvec3 middle = 0.5 * (b + c);
            point = spline ? middle : -w * a + (0.5 + w) * (b + c) - w * d;
            fresh.push_back(point);
            if (!stage.watched() && (++made & 1023) != 0) continue;
            if (spline)
                co_yield Step("middle")
                    .point(glm::vec3(b), Role::Current, "b")
                    .point(glm::vec3(c), Role::Current, "c")
                    .vertex(uint32_t(fresh.size() - 1), Role::New, "e")
                    .number("level", double(level))
                    .number("index", double(i))
                    .progress(done);
            else
                co_yield Step("insert")
                    .segment(glm::vec3(middle), glm::vec3(point), Role::Removed)
                    .point(glm::vec3(a), Role::Neighbour, "a")
                    .point(glm::vec3(b), Role::Current, "b")
                    .point(glm::vec3(c), Role::Current, "c")
                    .point(glm::vec3(d), Role::Neighbour, "d")
                    .vertex(uint32_t(fresh.size() - 1), Role::New, "e")
                    .number("level", double(level))
                    .number("index", double(i))
                    .number("outer", -w)
                    .number("inner", 0.5 + w)
                    .number("offset", glm::distance(middle, point))
                    .progress(done);
        }
        co_yield at.endLevel(level, stage.watched());
    }
    stage.finish(at.result());
}

}  // namespace

Generator subdivideCurve(Curve input, SubdivideCurve p, Stage<Curve>& stage)
{
    if (p.scheme != SubdivideCurve::Scheme::Mask) return byScheme(std::move(input), std::move(p), stage);
    CurveMask mask{weightsIn(p.old, "old points"), weightsIn(p.fresh, "new points")};
    return byMask(std::move(input), std::move(p), std::move(mask), stage);
}

}  // namespace mw
