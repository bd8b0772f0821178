#include "core/simplify/star_hole.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace mw {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Sine of the least angle: opposite the shortest side, between the other two.
double leastSine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    double side[] = {glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)};
    std::sort(side, side + 3);
    const double twice = glm::length(glm::cross(b - a, c - a));
    return side[1] > 0 ? twice / (side[1] * side[2]) : 0;
}

class EarCutter {
public:
    EarCutter(const StarHole& hole, double turn);
    bool isStar() const;
    bool cutAll(Filling& out);
    bool folds(const Filling& out) const;

private:
    using Triple = std::array<uint32_t, 3>;
    bool crossesClosing(size_t i) const;
    bool isEar(const Triple& t) const;
    glm::dvec3 normalOf(const Triple& t) const;
    bool turned(const Triple& t) const { return !(glm::dot(normalOf(t), hole_.normal) >= turn_); }

    const StarHole& hole_;
    double turn_;
    std::vector<glm::dvec2> flat_;
    glm::dvec2 apex_{0};
    std::vector<uint32_t> left_;
    double tiny_ = 0;  // twice an area that counts as none
};

EarCutter::EarCutter(const StarHole& hole, double turn) : hole_(hole), turn_(turn), left_(hole.points.size())
{
    const glm::dvec3 n = hole.normal, axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, n)), v = glm::cross(n, u);
    double reach = 0;
    for (const glm::dvec3& p : hole.points) {
        flat_.emplace_back(glm::dot(p - hole.apex, u), glm::dot(p - hole.apex, v));  // the apex is the origin
        reach = std::max(reach, glm::dot(flat_.back(), flat_.back()));
    }
    tiny_ = 1e-9 * reach;
    std::iota(left_.begin(), left_.end(), 0u);
}

/// The edge that closes an open ring, and edge i of the ring.
bool EarCutter::crossesClosing(size_t i) const
{
    const glm::dvec2 &a = flat_.back(), &b = flat_.front(), &c = flat_[i], &d = flat_[i + 1];
    return (cross(a, b, c) > 0) != (cross(a, b, d) > 0) && (cross(c, d, a) > 0) != (cross(c, d, b) > 0);
}

bool EarCutter::isStar() const
{
    const size_t n = flat_.size(), faces = hole_.open ? n - 1 : n;
    double angle = 0;
    for (size_t i = 0; i < faces; ++i) {
        const glm::dvec2 &a = flat_[i], &b = flat_[(i + 1) % n];
        if (!(cross(apex_, a, b) > tiny_)) return false;
        angle += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    }
    if (!hole_.open) return angle < 3 * M_PI;  // once round
    if (angle >= 2 * M_PI) return false;
    for (size_t i = 1; i + 2 < n; ++i)
        if (crossesClosing(i)) return false;
    double area = 0;
    for (size_t i = 0; i < n; ++i) area += cross(apex_, flat_[i], flat_[(i + 1) % n]);
    return area > tiny_;
}

glm::dvec3 EarCutter::normalOf(const Triple& t) const
{
    const glm::dvec3 n = glm::cross(hole_.points[t[1]] - hole_.points[t[0]], hole_.points[t[2]] - hole_.points[t[0]]);
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0);
}

bool EarCutter::isEar(const Triple& t) const
{
    const glm::dvec2 &a = flat_[t[0]], &b = flat_[t[1]], &c = flat_[t[2]];
    if (!(cross(a, b, c) > tiny_)) return false;
    return std::none_of(left_.begin(), left_.end(), [&](uint32_t i) {
        const glm::dvec2& p = flat_[i];
        return i != t[0] && i != t[1] && i != t[2] && cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
    });
}

bool EarCutter::cutAll(Filling& out)
{
    double least = 1;
    while (left_.size() >= 3) {
        const size_t n = left_.size();
        double best = 0;
        size_t at = n;
        NoFilling why = NoFilling::NotStar;
        for (size_t i = 0; i < (n == 3 ? 1 : n); ++i) {
            const Triple t{left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
            if (!isEar(t)) continue;
            if (turned(t)) {
                why = std::max(why, NoFilling::Fold);
                continue;
            }
            if (n > 3 && !hole_.allowed(t[0], t[2])) {
                why = std::max(why, NoFilling::Exists);
                continue;
            }
            const double sine = leastSine(hole_.points[t[0]], hole_.points[t[1]], hole_.points[t[2]]);
            if (sine > best) best = sine, at = i;
        }
        if (at == n) {
            out = {why, {}, 0};
            return false;
        }
        out.triangles.push_back({left_[(at + n - 1) % n], left_[at], left_[(at + 1) % n]});
        least = std::min(least, best);
        if (n == 3) break;
        left_.erase(left_.begin() + std::ptrdiff_t(at));
    }
    out.leastAngle = glm::degrees(std::asin(std::min(1.0, least)));
    return true;
}

bool EarCutter::folds(const Filling& out) const
{
    const auto n = uint32_t(hole_.points.size());
    for (size_t s = 0; s < out.triangles.size(); ++s) {
        const glm::dvec3 own = normalOf(out.triangles[s]);
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t i = out.triangles[s][k], j = out.triangles[s][(k + 1) % 3];
            if (j == (i + 1) % n && i < hole_.beyond.size() && glm::dot(own, hole_.beyond[i]) < 0) return true;
        }
        for (size_t t = s + 1; t < out.triangles.size(); ++t) {
            int common = 0;
            for (const uint32_t i : out.triangles[s])
                for (const uint32_t j : out.triangles[t]) common += i == j;
            if (common == 2 && glm::dot(own, normalOf(out.triangles[t])) < 0) return true;
        }
    }
    return false;
}

}  // namespace

Filling filled(const StarHole& hole, double turn)
{
    Filling out;
    if (hole.points.size() < 3) return out;
    EarCutter cutter(hole, turn);
    if (!cutter.isStar()) {
        out.why = NoFilling::NotStar;
        return out;
    }
    if (cutter.cutAll(out) && cutter.folds(out)) out = {NoFilling::Fold, {}, 0};
    return out;
}

}  // namespace mw
