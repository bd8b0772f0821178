#include "core/repair/hole_triangulation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>

namespace mw {

namespace {

constexpr double stepsOfBend = 10000;

glm::dvec3 unitOrZero(const glm::dvec3& v)
{
    const double l = glm::length(v);
    return l > 0 ? v / l : glm::dvec3(0);
}

/// 0 flat, 2 folded back; a normal of 0 belongs to a triangle without area: as bad as folded, unless there is nothing beyond.
int32_t bendOf(const glm::dvec3& a, const glm::dvec3& b)
{
    const double d = glm::dot(a, b);
    return int32_t(std::lround(stepsOfBend * std::clamp(1 - d, 0.0, 2.0)));
}

}  // namespace

double areaOf(const HoleOutline& hole, const Triple& t)
{
    const auto& p = hole.points;
    return 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

LeastBend::LeastBend(const HoleOutline& hole, bool wanted)
    : hole_(hole), n_(wanted ? hole.points.size() : 0), weight_(n_ * n_), beyond_(n_ * n_, glm::dvec3(0))
{
    for (size_t i = 0; i + 1 < n_; ++i) at(i, i + 1).bend = 0;
}

glm::dvec3 LeastBend::normal(size_t i, size_t m, size_t j) const
{
    const auto& p = hole_.points;
    return unitOrZero(glm::cross(p[m] - p[i], p[j] - p[i]));
}

glm::dvec3 LeastBend::beyond(size_t i, size_t j) const
{
    return j == i + 1 ? hole_.normals[i] : beyond_[i * n_ + j];
}

void LeastBend::fill(size_t i, size_t j)
{
    const bool last = i == 0 && j == n_ - 1;
    if (!last && !hole_.allowed(uint32_t(i), uint32_t(j))) return;
    if (last && n_ == 3 && hole_.isFace) return;
    Weight best;
    glm::dvec3 bestNormal(0);
    for (size_t m = i + 1; m < j; ++m) {
        const Weight &left = at(i, m), &right = at(m, j);
        if (left.bend < 0 || right.bend < 0) continue;
        const int32_t inner = std::max(left.bend, right.bend);
        if (best.bend >= 0 && inner > best.bend) continue;
        const glm::dvec3 across = glm::cross(hole_.points[m] - hole_.points[i], hole_.points[j] - hole_.points[i]);
        const double twice = glm::length(across);
        const glm::dvec3 n = twice > 0 ? across / twice : glm::dvec3(0);
        int32_t bend = std::max({inner, bendOf(n, beyond(i, m)), bendOf(n, beyond(m, j))});
        if (last) bend = std::max(bend, bendOf(n, hole_.normals[n_ - 1]));
        if (!(twice > 0)) bend = int32_t(2 * stepsOfBend);
        const double area = left.area + right.area + 0.5 * twice;
        if (best.bend >= 0 && (bend > best.bend || (bend == best.bend && area >= best.area))) continue;
        best = {bend, uint32_t(m), area};
        bestNormal = n;
    }
    at(i, j) = best;
    beyond_[i * n_ + j] = bestNormal;
}

void LeastBend::row(size_t k)
{
    const size_t gap = k + 2;
    for (size_t i = 0; i + gap < n_; ++i) fill(i, i + gap);
}

bool LeastBend::possible() const
{
    return n_ >= 3 && at(0, n_ - 1).bend >= 0;
}

double LeastBend::bend(const Triple& t) const
{
    const glm::dvec3 n = normal(t[0], t[1], t[2]);
    const double worst = std::min(glm::dot(n, beyond(t[0], t[1])), glm::dot(n, beyond(t[1], t[2])));
    return std::acos(std::clamp(worst, -1.0, 1.0)) * 180 / M_PI;
}

std::vector<Triple> LeastBend::triangles() const
{
    std::vector<Triple> out;
    std::vector<std::pair<uint32_t, uint32_t>> open{{0, uint32_t(n_ - 1)}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j < i + 2) continue;
        const uint32_t m = at(i, j).split;
        out.push_back({i, m, j});
        open.emplace_back(m, j);
        open.emplace_back(i, m);
    }
    return out;
}

namespace {

/// The outline that is left, as a ring of points.
class EarRing {
public:
    explicit EarRing(const HoleOutline& hole);
    std::vector<Triple> run();

private:
    struct Ear {
        double angle;
        uint32_t point, stamp;
        bool operator<(const Ear& e) const { return angle != e.angle ? angle > e.angle : point > e.point; }  // the least on top
    };
    void consider(uint32_t i);
    bool mayCut(uint32_t i) const;

    const HoleOutline& hole_;
    std::vector<uint32_t> next_, before_, stamp_;
    std::vector<glm::dvec3> normal_;  // beyond the edge from point i to the next one left
    std::priority_queue<Ear> ears_;
    uint32_t left_;
};

EarRing::EarRing(const HoleOutline& hole)
    : hole_(hole),
      next_(hole.points.size()),
      before_(hole.points.size()),
      stamp_(hole.points.size(), 0),
      normal_(hole.normals),
      left_(uint32_t(hole.points.size()))
{
    for (uint32_t i = 0; i < left_; ++i) {
        next_[i] = (i + 1) % left_;
        before_[i] = (i + left_ - 1) % left_;
    }
    for (uint32_t i = 0; i < left_; ++i) consider(i);
}

/// The angle on the side of the hole, 0 to 2 pi: seen along the normal of what is round it.
void EarRing::consider(uint32_t i)
{
    const auto& p = hole_.points;
    const glm::dvec3 back = unitOrZero(p[before_[i]] - p[i]), ahead = unitOrZero(p[next_[i]] - p[i]);
    double angle = std::acos(std::clamp(glm::dot(back, ahead), -1.0, 1.0));
    if (glm::dot(glm::cross(ahead, back), normal_[i] + normal_[before_[i]]) < 0) angle = 2 * M_PI - angle;
    ears_.push({angle, i, ++stamp_[i]});
}

bool EarRing::mayCut(uint32_t i) const
{
    return left_ == 3 ? !hole_.isFace : hole_.allowed(before_[i], next_[i]);
}

std::vector<Triple> EarRing::run()
{
    std::vector<Triple> out;
    while (left_ >= 3 && !ears_.empty()) {
        const Ear ear = ears_.top();
        ears_.pop();
        if (ear.stamp != stamp_[ear.point] || !mayCut(ear.point)) continue;
        const uint32_t b = before_[ear.point], n = next_[ear.point];
        out.push_back({b, ear.point, n});
        if (left_-- == 3) return out;
        const auto& p = hole_.points;
        normal_[b] = unitOrZero(glm::cross(p[ear.point] - p[b], p[n] - p[b]));
        ++stamp_[ear.point];
        next_[b] = n;
        before_[n] = b;
        consider(b);
        consider(n);
    }
    return {};
}

}  // namespace

std::vector<Triple> clippedEars(const HoleOutline& hole)
{
    return hole.points.size() < 3 ? std::vector<Triple>() : EarRing(hole).run();
}

}  // namespace mw
