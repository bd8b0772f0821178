// Weights made to shares once, then matrix and right sides row by row.
#include "core/parameterize/spring_system.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"

namespace mw {

SpringSystem::SpringSystem(const Disk& disk, EdgeWeights kind)
    : disk_(disk), rings_(&disk_.triangles.rings()), kind_(kind), share_(edgeWeights(disk_.triangles, kind)), sum_(disk_.inner.size(), 0.0)
{
    for (size_t i = 0; i < disk_.inner.size(); ++i) {
        const uint32_t v = disk_.inner[i], first = rings_->neighbourStart[v], last = rings_->neighbourStart[v + 1];
        double largest = 0;
        for (uint32_t k = first; k < last; ++k) {
            sum_[i] += share_[k];
            largest = std::max(largest, std::abs(share_[k]));
            negative_ += share_[k] < 0;
        }
        if (!(std::abs(sum_[i]) > 1e-12 * largest) || !std::isfinite(sum_[i]))
            throw Error("the weights round vertex " + std::to_string(v) +
                        " add up to nothing, so it has no place; choose mean-value or uniform weights");
        for (uint32_t k = first; k < last; ++k) share_[k] /= sum_[i];
    }
}

SparsePattern SpringSystem::pattern() const
{
    SparsePattern p;
    for (const uint32_t v : disk_.inner) {
        for (const uint32_t w : ring(v))
            if (disk_.unknown[w] != none) p.column.push_back(disk_.unknown[w]);
        p.start.push_back(uint32_t(p.column.size()));
    }
    return p;
}

/// Rows of (3.42); those of symmetric weights times the sum of their weights, which makes the matrix symmetric.
SparseValues SpringSystem::values() const
{
    SparseValues out;
    out.symmetric = symmetric(kind_);
    for (size_t i = 0; i < disk_.inner.size(); ++i) {
        const uint32_t v = disk_.inner[i];
        const double scale = out.symmetric ? sum_[i] : 1;
        out.diagonal.push_back(scale);
        const auto neighbours = ring(v);
        const auto share = shares(v);
        for (size_t k = 0; k < neighbours.size(); ++k)
            if (disk_.unknown[neighbours[k]] != none) out.off.push_back(-share[k] * scale);
    }
    return out;
}

std::vector<glm::vec3> SpringSystem::places() const
{
    std::vector<glm::vec3> out;
    out.reserve(disk_.inner.size());
    for (const uint32_t v : disk_.inner) out.push_back(disk_.triangles.positions()[v]);
    return out;
}

std::vector<glm::dvec2> SpringSystem::rightSides(std::span<const glm::dvec2> places) const
{
    std::vector<glm::dvec2> out(disk_.inner.size(), glm::dvec2(0));
    for (size_t i = 0; i < out.size(); ++i) {
        const auto neighbours = ring(disk_.inner[i]);
        const auto share = shares(disk_.inner[i]);
        for (size_t k = 0; k < neighbours.size(); ++k)
            if (disk_.unknown[neighbours[k]] == none) out[i] += share[k] * places[neighbours[k]];
        if (symmetric(kind_)) out[i] *= sum_[i];
    }
    return out;
}

std::span<const double> SpringSystem::shares(uint32_t v) const
{
    return {share_.data() + rings_->neighbourStart[v], ring(v).size()};
}

double SpringSystem::sum(uint32_t v) const
{
    return sum_[disk_.unknown[v]];
}

glm::dvec2 SpringSystem::mean(uint32_t v, std::span<const glm::dvec2> places) const
{
    const auto neighbours = ring(v);
    const auto share = shares(v);
    glm::dvec2 m(0);
    for (size_t k = 0; k < neighbours.size(); ++k) m += share[k] * places[neighbours[k]];
    return m;
}

double SpringSystem::residual(std::span<const glm::dvec2> places) const
{
    double worst = 0;
    for (const uint32_t v : disk_.inner) {
        const glm::dvec2 gap = places[v] - mean(v, places);
        const double d = glm::dot(gap, gap);
        if (!(d <= worst)) worst = d;  // what is no number is worst
    }
    return std::sqrt(worst);
}

}  // namespace mw
