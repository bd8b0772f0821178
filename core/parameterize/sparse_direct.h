// A direct solver for the linear systems of meshes: nested dissection by places in space, then multifrontal Cholesky or LU factors.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/mesh/array.h"

namespace mw {

/// Where a matrix may have entries beside its diagonal, row by row, columns ascending. It must be symmetric: i has j if and only if j has i.
struct SparsePattern {
    Array<uint32_t> start{0u}, column;
    size_t size() const { return start.size() - 1; }
};

/// Entries: `off` beside SparsePattern::column (row i, column j).
struct SparseValues {
    Array<double> diagonal, off;
    bool symmetric = true;  ///< off is symmetric, and all is positive definite
};

/// George's nested dissection with cuts across the longest direction of each part (its unknowns lie in space), and the multifrontal method of
/// Duff and Reid: O(n log n) numbers and O(n^1.5) operations for a surface. Symmetric positive definite by Cholesky, else LU without
/// pivoting, which is sound for rows that are weakly diagonally dominant.
///
/// Everything is done piece by piece, so that a caller can show progress and stop: each of order(), analyse() and factor() works about as
/// much as it is asked to and tells whether something is left. Deterministic, also with threads.
///
///   while (s.order(1e6)) {}      // the pattern alone
///   while (s.analyse(1e6)) {}
///   s.begin(values);             // again whenever the values change
///   while (s.factor(1e8)) {}
///   s.solve(rightSides);         // as often as wanted
class SparseDirect {
public:
    /// `places`: of each unknown; any will do, good ones make the factors small.
    SparseDirect(SparsePattern pattern, std::span<const glm::vec3> places);
    ~SparseDirect();
    SparseDirect(SparseDirect&&) noexcept;
    SparseDirect& operator=(SparseDirect&&) noexcept;

    bool order(double work);
    bool analyse(double work);
    /// Takes `values`. Throws Error when the factors would need more memory than `mostBytes`.
    void begin(SparseValues values, size_t mostBytes = size_t(24) << 30);
    /// Throws Error when a pivot fails. `threads`: on as many cores as there are.
    bool factor(double operations, bool threads = true);
    /// Right sides in, solutions out. Two systems at once.
    void solve(std::span<glm::dvec2> values) const;

    /// The unknowns eliminated together at a step, for showing.
    struct Supernode {
        std::span<const uint32_t> own;  ///< unknowns, in the order of elimination
        size_t border = 0;              ///< later unknowns it is joined to
        double operations = 0;          ///< multiplications
    };
    size_t supernodes() const;
    Supernode supernode(size_t i) const;  ///< in the order of elimination
    size_t factored() const;              ///< supernodes done since begin()
    double operations() const;            ///< of all supernodes together
    size_t factorEntries() const;         ///< numbers in L (in U as many)
    double progress() const;              ///< of ordering, analysing, factoring: each 0 to 1

private:
    struct Parts;
    std::unique_ptr<Parts> p_;
};

}  // namespace mw
