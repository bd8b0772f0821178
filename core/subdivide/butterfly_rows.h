// Which vertices make the new point of an edge under butterfly subdivision.
#pragma once
#include <vector>

#include "core/subdivide/loop_level.h"

namespace mw {

enum class ButterflyRule { Regular, Extraordinary, Border };

/// Rows of one level; `level` stays as long as this.
class ButterflyRows {
public:
    struct Term {
        uint32_t vertex;
        double weight;
    };
    ButterflyRows(const LoopLevel& level, double w, bool modified);
    /// Puts the row of edge e into `terms`; its ends come first.
    ButterflyRule row(uint32_t e, std::vector<Term>& terms) const;

private:
    bool extraordinary(uint32_t v) const;
    void border(uint32_t e, std::vector<Term>& terms) const;
    void wings(uint32_t e, std::vector<Term>& terms) const;
    void addWing(uint32_t corner, uint32_t away, std::vector<Term>& terms) const;
    /// The modified rule at the start of half-edge h, times `share`.
    void ring(uint32_t h, double share, std::vector<Term>& terms) const;
    uint32_t across(uint32_t corner) const { return cornerOf_[level_.half[corner] ^ 1]; }

    const LoopLevel& level_;
    double w_;
    bool modified_;
    Array<uint32_t> cornerOf_, valence_;    // by half-edge; by vertex
    std::vector<uint8_t> sharp_, onSharp_;  // by edge; by vertex: number of sharp edges, at most 3
    Array<uint32_t> along_;                 // by vertex: sum of its sharp neighbours, which with one of two gives the other
};

}  // namespace mw
