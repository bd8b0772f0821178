// The linear system of a planar embedding: every inner vertex is the weighted mean of its ring. Book (3.38)-(3.43).
#pragma once
#include "core/mesh/rings.h"
#include "core/parameterize/disk.h"
#include "core/parameterize/edge_weights.h"
#include "core/parameterize/sparse_direct.h"

namespace mw {

/// Weights and matrix of a disk. P_i = sum over its ring of beta_ij P_j, where beta_ij = K_ij / sum_r K_ir.
class SpringSystem {
public:
    SpringSystem(const Disk& disk, EdgeWeights kind);

    SparsePattern pattern() const;  ///< of the unknowns of the disk
    SparseValues values() const;
    std::vector<glm::vec3> places() const;  ///< in space, for ordering
    /// What the border gives to each unknown. `places`: of all vertices.
    std::vector<glm::dvec2> rightSides(std::span<const glm::dvec2> places) const;

    std::span<const uint32_t> ring(uint32_t vertex) const { return rings_->neighboursOf(vertex); }
    /// beta_ij, beside ring(vertex).
    std::span<const double> shares(uint32_t vertex) const;
    double sum(uint32_t vertex) const;  ///< sum of K_ij over the ring
    /// Where the ring of a vertex draws it.
    glm::dvec2 mean(uint32_t vertex, std::span<const glm::dvec2> places) const;
    /// The largest distance of an inner vertex from there: the residual of (3.41).
    double residual(std::span<const glm::dvec2> places) const;
    size_t negative() const { return negative_; }  ///< directed edges at inner vertices with K_ij < 0

private:
    Disk disk_;
    const Rings* rings_;
    EdgeWeights kind_;
    Array<double> share_;  // beside rings().neighbour
    Array<double> sum_;    // of each unknown
    size_t negative_ = 0;
};

}  // namespace mw
