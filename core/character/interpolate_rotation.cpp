#include "core/character/interpolate_rotation.h"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace mw {

namespace {

constexpr double noAngle = std::numeric_limits<double>::quiet_NaN();
constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

glm::dquat fromAngles(const glm::dvec3& degrees, InterpolateRotation::Order order)
{
    const int* axes = orders[size_t(order)];
    const double angles[3] = {glm::radians(degrees[axes[0]]), glm::radians(degrees[axes[1]]), glm::radians(degrees[axes[2]])};
    return quaternionOf(axes, angles);
}

double lengthOf(const glm::dquat& q)
{
    return std::sqrt(glm::dot(q, q));
}

/// By how much the body turns between two orientations, radians.
double turnBetween(const glm::dquat& a, const glm::dquat& b)
{
    const glm::dquat d = glm::conjugate(a) * b;
    return 2 * std::atan2(glm::length(glm::dvec3(d.x, d.y, d.z)), std::abs(d.w));
}

/// Of the two quaternions on the four-sphere, radians; the body turns twice as far.
double arcBetween(const glm::dquat& a, const glm::dquat& b)
{
    return 2 * std::atan2(lengthOf(a - b), lengthOf(a + b));
}

/// Weights of both ends in the sum (6.38); near each other, or opposite, those of a straight line.
glm::dvec2 arcWeights(double arc, double t)
{
    const double sine = std::sin(arc);
    if (sine < 1e-9) return {1 - t, t};
    return {std::sin((1 - t) * arc) / sine, std::sin(t * arc) / sine};
}

/// A path as it grows: how far the body has turned on it, and how fast it turns.
class Walk {
public:
    using At = std::function<glm::dquat(double)>;
    Walk(Rotations& r, const char* name, At at) : r_(r), at_(std::move(at)), axis_(tracedAxis(r)) { r_.paths.push_back({name, {}}); }
    void go(double t, const glm::dvec3& euler)
    {
        std::vector<Rotations::Sample>& s = r_.paths.back().samples;
        const glm::dquat q = at_(t), before = s.empty() ? q : s.back().orientation;
        turned_ += turnBetween(before, q);
        speed_ = turnBetween(at_(t - nearby), at_(t + nearby)) / (2 * nearby);
        from_ = before * axis_;
        tip_ = q * axis_;
        s.push_back({t, q, euler});
    }
    double turned() const { return glm::degrees(turned_); }
    double speed() const { return glm::degrees(speed_); }  ///< degrees for t from 0 to 1, if it went on so
    glm::vec3 before() const { return glm::vec3(from_); }
    glm::vec3 tip() const { return glm::vec3(tip_); }

private:
    static constexpr double nearby = 1e-5;
    Rotations& r_;
    At at_;
    double turned_ = 0, speed_ = 0;
    glm::dvec3 axis_, from_{0}, tip_{0};
};

/// Of unit length; the start where the line goes through 0.
glm::dquat normalised(const glm::dquat& q, const glm::dquat& otherwise)
{
    const double size = lengthOf(q);
    return size > 1e-12 ? q / size : otherwise;
}

}  // namespace

glm::dvec3 tracedAxis(const Rotations& r)
{
    glm::dvec3 best(1, 0, 0);
    double least = 2;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis(0);
        axis[k] = 1;
        const double cosine = glm::dot(r.from * axis, r.to * axis);
        if (cosine < least - 1e-9) {
            least = cosine;
            best = axis;
        }
    }
    return best;
}

Generator interpolateRotation(InterpolateRotation p, Stage<Rotations>& stage)
{
    Rotations r;
    r.from = fromAngles(p.from, p.order);
    r.to = fromAngles(p.to, p.order);
    if ((glm::dot(r.from, r.to) < 0) == p.shorter) r.to = -r.to;
    stage.show([&] { return r; });
    const double arc = arcBetween(r.from, r.to), last = double(p.samples - 1), all = 3 * double(p.samples);
    const glm::dvec3 none(noAngle);
    const auto anglesAt = [&](double t) { return (1 - t) * p.from + t * p.to; };
    const auto lineAt = [from = r.from, to = r.to](double t) { return from * (1 - t) + to * t; };

    Walk byAngles(r, "euler", [&](double t) { return fromAngles(anglesAt(t), p.order); });
    for (int64_t i = 0; i < p.samples; ++i) {
        const double t = double(i) / last;
        const glm::dvec3 angles = anglesAt(t);
        byAngles.go(t, angles);
        co_yield Step("euler")
            .segment(byAngles.before(), byAngles.tip(), Role::Current)
            .point(byAngles.tip(), Role::New, "E")
            .number("t", t)
            .number("x", angles.x)
            .number("y", angles.y)
            .number("z", angles.z)
            .number("turned", byAngles.turned())
            .number("speed", byAngles.speed())
            .progress(double(i) / all);
    }
    Walk byLine(r, "nlerp", [&](double t) { return normalised(lineAt(t), r.from); });
    for (int64_t i = 0; i < p.samples; ++i) {
        const double t = double(i) / last;
        byLine.go(t, none);
        co_yield Step("nlerp")
            .segment(byLine.before(), byLine.tip(), Role::Current)
            .point(byLine.tip(), Role::New, "N")
            .number("t", t)
            .number("norm", lengthOf(lineAt(t)))
            .number("turned", byLine.turned())
            .number("speed", byLine.speed())
            .progress((last + double(i)) / all);
    }
    Walk byArc(r, "slerp", [&](double t) {
        const glm::dvec2 weight = arcWeights(arc, t);
        return normalised(r.from * weight.x + r.to * weight.y, r.from);
    });
    for (int64_t i = 0; i < p.samples; ++i) {
        const double t = double(i) / last;
        const glm::dvec2 weight = arcWeights(arc, t);
        byArc.go(t, none);
        co_yield Step("slerp")
            .segment(byArc.before(), byArc.tip(), Role::Current)
            .point(byArc.tip(), Role::New, "S")
            .number("t", t)
            .number("arc", glm::degrees(arc))
            .number("first", weight.x)
            .number("second", weight.y)
            .number("turned", byArc.turned())
            .number("speed", byArc.speed())
            .progress((2 * last + double(i)) / all);
    }
    stage.finish(std::move(r));
}

}  // namespace mw
