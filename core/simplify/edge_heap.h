// A heap of edges by cost in which an edge can be found, changed and taken out. Equal costs: the lower edge first.
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

namespace mw {

/// Four children a node: half as deep as a binary heap, and the four lie side by side. Cost (as the bits of a positive float, which are in the
/// order of the numbers) and edge make one 64-bit key, so that one comparison decides and nothing is ever tied.
class EdgeHeap {
public:
    explicit EdgeHeap(size_t edges) : place_(edges, absent) {}

    bool empty() const { return keys_.empty(); }
    size_t size() const { return keys_.size(); }
    uint32_t topEdge() const { return uint32_t(keys_.front()); }
    float topCost() const { return std::bit_cast<float>(uint32_t(keys_.front() >> 32)); }
    bool holds(uint32_t edge) const { return place_[edge] != absent; }

    /// Adds without ordering; order() once, afterwards.
    void append(uint32_t edge, float cost)
    {
        place_[edge] = uint32_t(keys_.size());
        keys_.push_back(keyOf(edge, cost));
    }
    void order()
    {
        for (size_t i = keys_.size() / 4 + 1; i-- > 0;)
            if (i < keys_.size()) sink(i, keys_[i]);
    }
    /// Puts it in, or gives it another cost.
    void set(uint32_t edge, float cost)
    {
        const uint64_t key = keyOf(edge, cost);
        size_t i = place_[edge];
        if (i == absent) {
            i = keys_.size();
            keys_.push_back(key);
        }
        if (i > 0 && key < keys_[(i - 1) / 4])
            rise(i, key);
        else
            sink(i, key);
    }
    void remove(uint32_t edge)
    {
        const size_t i = place_[edge];
        if (i == absent) return;
        place_[edge] = absent;
        const uint64_t last = keys_.back();
        keys_.pop_back();
        if (i == keys_.size()) return;
        if (i > 0 && last < keys_[(i - 1) / 4])
            rise(i, last);
        else
            sink(i, last);
    }

private:
    static constexpr uint32_t absent = ~0u;
    static uint64_t keyOf(uint32_t edge, float cost) { return uint64_t(std::bit_cast<uint32_t>(cost)) << 32 | edge; }
    void put(size_t i, uint64_t key)
    {
        keys_[i] = key;
        place_[uint32_t(key)] = uint32_t(i);
    }
    void rise(size_t i, uint64_t key)
    {
        for (; i > 0 && key < keys_[(i - 1) / 4]; i = (i - 1) / 4) put(i, keys_[(i - 1) / 4]);
        put(i, key);
    }
    void sink(size_t i, uint64_t key)
    {
        const size_t n = keys_.size();
        for (;;) {
            const size_t first = 4 * i + 1, end = first + 4 < n ? first + 4 : n;
            if (first >= n) break;
            size_t least = first;
            for (size_t k = first + 1; k < end; ++k)
                if (keys_[k] < keys_[least]) least = k;
            if (keys_[least] >= key) break;
            put(i, keys_[least]);
            i = least;
        }
        put(i, key);
    }

    std::vector<uint64_t> keys_;
    std::vector<uint32_t> place_;
};

}  // namespace mw
