// Which rotation of one spherical map fits the other? Trying many, on a sample; the nearest direction stands for the place between.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "core/math/random.h"
#include "core/morph/morph_maps.h"

namespace mw {

namespace {

constexpr int cells = 24;  // a side of the cube round the sphere

/// Directions by cells of a cube round the sphere.
class DirectionGrid {
public:
    explicit DirectionGrid(std::span<const glm::dvec3> directions) : directions_(directions), start_(6 * cells * cells + 1, 0)
    {
        for (const glm::dvec3& d : directions) ++start_[size_t(cell(d)) + 1];
        for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        order_.resize(directions.size());
        std::vector<uint32_t> fill(start_.begin(), start_.end() - 1);
        for (uint32_t i = 0; i < directions.size(); ++i) order_[fill[size_t(cell(directions[i]))]++] = i;
        // Cells without any take the nearest of a neighbour, found once.
        nearest_.assign(size_t(6 * cells * cells), none);
        for (int c = 0; c < 6 * cells * cells; ++c)
            if (start_[size_t(c)] == start_[size_t(c) + 1]) nearest_[size_t(c)] = byAll(middle(c));
    }
    uint32_t near(const glm::dvec3& d) const
    {
        const size_t c = size_t(cell(d));
        if (nearest_[c] != none) return nearest_[c];
        uint32_t best = order_[start_[c]];
        for (uint32_t i = start_[c]; i < start_[c + 1]; ++i)
            if (glm::dot(directions_[order_[i]], d) > glm::dot(directions_[best], d)) best = order_[i];
        return best;
    }

private:
    static int cell(const glm::dvec3& d)
    {
        const glm::dvec3 a = glm::abs(d);
        const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
        const double u = d[(axis + 1) % 3] / a[axis], v = d[(axis + 2) % 3] / a[axis];
        const auto at = [](double x) { return std::clamp(int((x + 1) / 2 * cells), 0, cells - 1); };
        return ((axis * 2 + (d[axis] < 0)) * cells + at(u)) * cells + at(v);
    }
    static glm::dvec3 middle(int c)
    {
        const int v = c % cells, u = c / cells % cells, face = c / cells / cells, axis = face / 2;
        glm::dvec3 d;
        d[axis] = face % 2 ? -1 : 1;
        d[(axis + 1) % 3] = 2 * (u + 0.5) / cells - 1;
        d[(axis + 2) % 3] = 2 * (v + 0.5) / cells - 1;
        return glm::normalize(d);
    }
    uint32_t byAll(const glm::dvec3& d) const
    {
        const size_t step = std::max<size_t>(1, directions_.size() / 4000);
        uint32_t best = 0;
        for (size_t i = 0; i < directions_.size(); i += step)
            if (glm::dot(directions_[i], d) > glm::dot(directions_[best], d)) best = uint32_t(i);
        return best;
    }

    std::span<const glm::dvec3> directions_;
    std::vector<uint32_t> start_, order_, nearest_;
};

/// Moved to the middle and to size 1.
std::vector<glm::dvec3> normalised(std::span<const glm::dvec3> places)
{
    glm::dvec3 low = places[0], high = low;
    for (const glm::dvec3& p : places) low = glm::min(low, p), high = glm::max(high, p);
    const double size = std::max(glm::distance(low, high), 1e-30);
    std::vector<glm::dvec3> out;
    for (const glm::dvec3& p : places) out.push_back((p - 0.5 * (low + high)) / size);
    return out;
}

class Fit {
public:
    Fit(std::span<const glm::dvec3> d0, std::span<const glm::dvec3> p0, std::span<const glm::dvec3> d1, std::span<const glm::dvec3> p1)
        : grid0_(d0), grid1_(d1), p0_(normalised(p0)), p1_(normalised(p1))
    {
        constexpr int samples = 400;
        for (int i = 0; i < samples; ++i) {  // evenly over the sphere (Fibonacci)
            const double z = 1 - 2 * (i + 0.5) / samples, r = std::sqrt(1 - z * z), a = i * std::numbers::pi * (3 - std::sqrt(5.0));
            samples_.push_back({r * std::cos(a), r * std::sin(a), z});
            at0_.push_back(p0_[grid0_.near(samples_.back())]);
        }
    }
    /// Mean square of the distances when directions of the second are turned by q.
    double distance(const glm::dquat& q, size_t step = 1) const
    {
        double sum = 0;
        const glm::dquat back = glm::conjugate(q);
        for (size_t i = 0; i < samples_.size(); i += step) {
            const glm::dvec3 d = at0_[i] - p1_[grid1_.near(back * samples_[i])];
            sum += glm::dot(d, d);
        }
        return sum * double(step) / double(samples_.size());
    }

private:
    DirectionGrid grid0_, grid1_;
    std::vector<glm::dvec3> p0_, p1_, samples_, at0_;
};

}  // namespace

Generator aligningRotation(std::span<const glm::dvec3> d0, std::span<const glm::dvec3> p0, std::span<const glm::dvec3> d1,
                           std::span<const glm::dvec3> p1, glm::dmat3& turn)
{
    constexpr int tries = 3000, pause = 64;
    const Fit fit(d0, p0, d1, p1);
    Random random(1);
    const auto any = [&] { return 2 * random.uniform() - 1; };
    glm::dquat best(1, 0, 0, 0);
    double least = fit.distance(best, 4) * 0.98;  // the maps as they are unless another is better
    for (int i = 0; i < tries; ++i) {
        if (i % pause == 0) co_yield Step("align").progress(double(i) / tries);
        glm::dquat q(any(), any(), any(), any());
        const double length = glm::length(q);
        if (length > 1 || length < 0.01) continue;
        q = q / length;
        if (const double e = fit.distance(q, 4); e < least) least = e, best = q;
    }
    least = fit.distance(best);
    for (double angle = 0.4; angle > 0.005; angle *= 0.7) {
        co_yield Step("align").progress(1);
        for (int i = 0; i < 24; ++i) {
            const glm::dquat q = glm::normalize(glm::dquat(1, angle * any(), angle * any(), angle * any()) * best);
            if (const double e = fit.distance(q); e < least) least = e, best = q;
        }
    }
    turn = glm::mat3_cast(best);
}

}  // namespace mw
