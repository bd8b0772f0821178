#include "core/subdivide/curve_mask.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/subdivide/curve_polygon.h"

namespace mw {

namespace {

using namespace curves;

constexpr size_t mostWeights = 13;

/// "3", "-0.5" or "-1/16".
double weightIn(std::string_view word, const char* what)
{
    const size_t slash = word.find('/');
    const auto number = [&](std::string_view part) {
        double v = 0;
        if (part.starts_with('+')) part.remove_prefix(1);
        const auto [end, wrong] = std::from_chars(part.data(), part.data() + part.size(), v);
        if (wrong != std::errc() || end != part.data() + part.size() || !std::isfinite(v))
            throw Error("a weight of the " + std::string(what) + " is \"" + std::string(word) + "\"; give numbers or fractions such as -1/16");
        return v;
    };
    const double over = number(word.substr(0, slash)), under = slash == std::string_view::npos ? 1 : number(word.substr(slash + 1));
    if (under == 0) throw Error("a weight of the " + std::string(what) + " is divided by 0: \"" + std::string(word) + "\"");
    return over / under;
}

std::string sumText(double v)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, v, std::chars_format::general, 6).ptr};
}

glm::dvec3 weighed(const Polygon& polygon, const std::vector<double>& weights, int64_t from)
{
    glm::dvec3 sum(0);
    for (size_t k = 0; k < weights.size(); ++k) sum += weights[k] * polygon.at(from + int64_t(k));
    return sum;
}

/// A step about a point and the points it is weighed from.
Step weighing(const char* phase, const Polygon& polygon, const std::vector<double>& weights, int64_t from, glm::dvec3 before, glm::dvec3 after)
{
    Step step(phase);
    std::move(step).segment(glm::vec3(before), glm::vec3(after), Role::Removed);
    for (size_t k = 0; k < weights.size(); ++k)
        if (weights[k] != 0) std::move(step).point(glm::vec3(polygon.at(from + int64_t(k))), Role::Neighbour);
    return step;
}

}  // namespace

std::vector<double> weightsIn(std::string_view text, const char* what)
{
    std::vector<double> out;
    double sum = 0;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" ,;\t\n"), text.size()));
        if (text.empty()) break;
        const size_t end = std::min(text.find_first_of(" ,;\t\n"), text.size());
        out.push_back(weightIn(text.substr(0, end), what));
        sum += out.back();
        text.remove_prefix(end);
    }
    if (out.empty() || out.size() > mostWeights)
        throw Error("the " + std::string(what) + " have " + std::to_string(out.size()) + " weights; give 1 to " + std::to_string(mostWeights));
    if (!(std::abs(sum - 1) <= 1e-6))
        throw Error("the weights of the " + std::string(what) + " sum to " + sumText(sum) + "; they must sum to 1, or the curve drifts off");
    return out;
}

Generator byMask(Curve input, SubdivideCurve p, CurveMask mask, Stage<Curve>& stage)
{
    Refining at(input, p);
    if (mask.old.size() % 2 == 0)
        throw Error("the old points have " + std::to_string(mask.old.size()) +
                    " weights; give an odd number: the point itself and as many on both sides");
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
            const glm::dvec3 moved = polygon.moves(i) ? weighed(polygon, mask.old, k + mask.oldFrom()) : old[i];
            fresh.push_back(moved);
            at.taken = i + 1;
            if (stage.watched() || (++made & 1023) == 0) {
                Step step = weighing("weigh-old", polygon, mask.old, k + mask.oldFrom(), old[i], moved);
                std::move(step).vertex(uint32_t(fresh.size() - 1), Role::New, "v").number("level", double(level)).number("index", double(i));
                std::move(step).number("weights", double(mask.old.size())).number("moved", glm::distance(old[i], moved)).progress(done);
                co_yield std::move(step);
            }
            if (i >= segments(n, at.closed)) continue;
            const glm::dvec3 point = weighed(polygon, mask.fresh, k + mask.freshFrom()), middle = 0.5 * (old[i] + polygon.at(k + 1));
            fresh.push_back(point);
            if (!stage.watched() && (++made & 1023) != 0) continue;
            Step step = weighing("weigh-new", polygon, mask.fresh, k + mask.freshFrom(), middle, point);
            std::move(step).vertex(uint32_t(fresh.size() - 1), Role::New, "e").number("level", double(level)).number("index", double(i));
            std::move(step).number("weights", double(mask.fresh.size())).number("offset", glm::distance(middle, point)).progress(done);
            co_yield std::move(step);
        }
        co_yield at.endLevel(level, stage.watched());
    }
    stage.finish(at.result());
}

}  // namespace mw
