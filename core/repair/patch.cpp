#include "core/repair/patch.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace mw {

namespace {

/// Triangles with the way to their neighbours: each directed edge knows its triangle.
class Refiner {
public:
    Refiner(Patch& patch, const std::vector<double>& spacing, const std::function<bool(uint32_t, uint32_t)>& allowed, size_t most)
        : patch_(patch), spacing_(spacing), allowed_(allowed), most_(patch.points.size() + most)
    {
        for (uint32_t t = 0; t < patch.triangles.size(); ++t) enter(t);
    }
    void run();

private:
    static uint64_t key(uint32_t a, uint32_t b) { return uint64_t(a) << 32 | b; }
    void enter(uint32_t t)
    {
        const Triple& v = patch_.triangles[t];
        for (size_t k = 0; k < 3; ++k) at_[key(v[k], v[(k + 1) % 3])] = t;
    }
    bool split(uint32_t t);
    bool turn(uint32_t a, uint32_t b);
    bool relax();
    double angleAt(uint32_t tip, uint32_t a, uint32_t b) const;
    uint32_t third(uint32_t t, uint32_t a, uint32_t b) const;

    Patch& patch_;
    std::vector<double> spacing_;
    const std::function<bool(uint32_t, uint32_t)>& allowed_;
    size_t most_;
    std::unordered_map<uint64_t, uint32_t> at_;
};

/// In the middle, when that is further from the corners than they want their neighbours.
bool Refiner::split(uint32_t t)
{
    const Triple v = patch_.triangles[t];
    const glm::dvec3 middle = (patch_.points[v[0]] + patch_.points[v[1]] + patch_.points[v[2]]) / 3.0;
    const double wanted = (spacing_[v[0]] + spacing_[v[1]] + spacing_[v[2]]) / 3;
    for (const uint32_t c : v) {
        const double far = std::sqrt(2.0) * glm::length(middle - patch_.points[c]);
        if (far <= wanted || far <= spacing_[c]) return false;
    }
    const uint32_t m = uint32_t(patch_.points.size()), n = uint32_t(patch_.triangles.size());
    patch_.points.push_back(middle);
    spacing_.push_back(wanted);
    patch_.triangles[t] = {v[0], v[1], m};
    patch_.triangles.push_back({v[1], v[2], m});
    patch_.triangles.push_back({v[2], v[0], m});
    for (const uint32_t u : {t, n, n + 1}) enter(u);
    for (size_t k = 0; k < 3; ++k) turn(v[k], v[(k + 1) % 3]);
    return true;
}

double Refiner::angleAt(uint32_t tip, uint32_t a, uint32_t b) const
{
    const glm::dvec3 u = patch_.points[a] - patch_.points[tip], w = patch_.points[b] - patch_.points[tip];
    return std::atan2(glm::length(glm::cross(u, w)), glm::dot(u, w));
}

uint32_t Refiner::third(uint32_t t, uint32_t a, uint32_t b) const
{
    for (const uint32_t v : patch_.triangles[t])
        if (v != a && v != b) return v;
    return a;
}

/// The edge a b goes the other way through its two triangles when the angles facing it are together more than a half turn.
bool Refiner::turn(uint32_t a, uint32_t b)
{
    const auto one = at_.find(key(a, b)), two = at_.find(key(b, a));
    if (one == at_.end() || two == at_.end()) return false;  // on the outline
    const uint32_t s = one->second, t = two->second, c = third(s, a, b), d = third(t, a, b);
    if (c == d || angleAt(c, a, b) + angleAt(d, a, b) <= M_PI + 1e-6) return false;
    if (at_.contains(key(c, d)) || at_.contains(key(d, c))) return false;
    if (c < patch_.outline && d < patch_.outline && !allowed_(c, d)) return false;
    at_.erase(key(a, b));
    at_.erase(key(b, a));
    patch_.triangles[s] = {a, d, c};
    patch_.triangles[t] = {d, b, c};
    enter(s);
    enter(t);
    return true;
}

bool Refiner::relax()
{
    bool any = false;
    for (size_t t = 0; t < patch_.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const Triple v = patch_.triangles[t];
            if (v[k] < v[(k + 1) % 3]) any |= turn(v[k], v[(k + 1) % 3]);
        }
    return any;
}

void Refiner::run()
{
    for (int round = 0; round < 40; ++round) {
        bool any = false;
        const size_t n = patch_.triangles.size();
        for (uint32_t t = 0; t < n && patch_.points.size() < most_; ++t) any |= split(t);
        for (int k = 0; k < 20 && relax(); ++k) continue;
        if (!any) return;
    }
}

/// Neighbours within the patch of every point, each once, ascending.
std::vector<std::vector<uint32_t>> neighbours(const Patch& patch)
{
    std::vector<std::vector<uint32_t>> out(patch.points.size());
    for (const Triple& t : patch.triangles)
        for (size_t k = 0; k < 3; ++k) {
            out[t[k]].push_back(t[(k + 1) % 3]);
            out[t[(k + 1) % 3]].push_back(t[k]);
        }
    for (auto& ring : out) {
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }
    return out;
}

}  // namespace

void refine(Patch& patch, const std::vector<double>& spacing, const std::function<bool(uint32_t, uint32_t)>& allowed, size_t most)
{
    Refiner(patch, spacing, allowed, most).run();
}

void fair(Patch& patch, const std::vector<std::vector<glm::dvec3>>& beyond)
{
    const size_t fixed = patch.outline, free = patch.points.size() - fixed;
    if (free == 0) return;
    const auto rings = neighbours(patch);
    // One row a point: the mean of its neighbours minus itself. What is fixed goes to the right-hand side.
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(long(patch.points.size()), 3);
    const auto add = [&](size_t row, size_t point, double weight) {
        if (point >= fixed)
            entries.emplace_back(int(row), int(point - fixed), weight);
        else
            for (int k = 0; k < 3; ++k) right(long(row), k) -= weight * patch.points[point][k];
    };
    for (size_t v = 0; v < patch.points.size(); ++v) {
        const size_t outside = v < fixed ? beyond[v].size() : 0;
        const double share = 1 / double(std::max<size_t>(1, rings[v].size() + outside));
        add(v, v, -1);
        for (const uint32_t w : rings[v]) add(v, w, share);
        for (size_t i = 0; i < outside; ++i)
            for (int k = 0; k < 3; ++k) right(long(v), k) -= share * beyond[v][i][k];
    }
    Eigen::SparseMatrix<double> umbrella(long(patch.points.size()), long(free));
    umbrella.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> normal = umbrella.transpose() * umbrella;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() != Eigen::Success) return;
    const Eigen::MatrixXd places = solver.solve(umbrella.transpose() * right);
    if (!places.allFinite()) return;
    for (size_t v = 0; v < free; ++v) patch.points[fixed + v] = {places(long(v), 0), places(long(v), 1), places(long(v), 2)};
}

}  // namespace mw
