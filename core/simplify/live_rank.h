// Numbers among those still there: what index an element has once all that were removed are left out.
#pragma once
#include <cstdint>
#include <vector>

namespace mw {

/// A Fenwick tree of presence: rank, removal and adding again in logarithmic time. An empty one answers with the index itself.
class LiveRank {
public:
    LiveRank() = default;
    explicit LiveRank(size_t n) : tree_(n + 1, 0)
    {
        for (size_t i = 1; i <= n; ++i) tree_[i] = uint32_t(i & (~i + 1));
    }
    void remove(uint32_t i)
    {
        for (size_t k = i + 1; k < tree_.size(); k += k & (~k + 1)) --tree_[k];
    }
    /// What was removed is there again.
    void add(uint32_t i)
    {
        for (size_t k = i + 1; k < tree_.size(); k += k & (~k + 1)) ++tree_[k];
    }
    uint32_t operator()(uint32_t i) const
    {
        if (tree_.empty()) return i;
        uint32_t n = 0;
        for (size_t k = i; k > 0; k &= k - 1) n += tree_[k];
        return n;
    }

private:
    std::vector<uint32_t> tree_;
};

}  // namespace mw
