// A queue that keeps edges by the order of magnitude of their cost: what the quick decimation has instead of a heap.
#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace mw {

/// Bucket k holds costs from 2^(k/4) to 2^((k+1)/4), times a constant: the upper bits of a positive float are the whole and the first quarter of its
/// logarithm. Within a bucket first in, first out; putting in and taking out take constant time. Edges lie in chunks that are used again.
class BucketQueue {
public:
    static constexpr uint32_t buckets = 1024, perOctave = 4, chunk = 254;

    static uint32_t bucketOf(float cost) { return std::bit_cast<uint32_t>(cost) >> 21; }
    static float leastCost(uint32_t bucket) { return std::bit_cast<float>(bucket << 21); }

    BucketQueue() : first_(buckets, -1), last_(buckets, -1) {}
    void reserve(size_t edges) { pool_.reserve(edges / chunk + buckets / 8); }
    bool empty(uint32_t bucket) const { return first_[bucket] < 0; }
    size_t size() const { return size_; }

    void push(uint32_t bucket, int edge)
    {
        int c = last_[bucket];
        if (c < 0 || pool_[size_t(c)].size == int(chunk)) c = grow(bucket, c);
        Chunk& into = pool_[size_t(c)];
        into.edges[into.size++] = edge;
        ++size_;
    }
    /// The oldest chunk of a bucket that is not empty, at most `chunk` edges; how many.
    int take(uint32_t bucket, int* edges)
    {
        const int c = first_[bucket];
        Chunk& from = pool_[size_t(c)];
        std::memcpy(edges, from.edges, size_t(from.size) * sizeof(int));
        first_[bucket] = from.next;
        if (from.next < 0) last_[bucket] = -1;
        from.next = free_;
        free_ = c;
        size_ -= size_t(from.size);
        return from.size;
    }
    /// A new, empty one, and its memory given back.
    void clear() { *this = BucketQueue(); }

private:
    struct Chunk {
        int next, size;
        int edges[chunk];
    };
    int grow(uint32_t bucket, int after)
    {
        int c = free_;
        if (c >= 0) {
            free_ = pool_[size_t(c)].next;
        } else {
            c = int(pool_.size());
            pool_.emplace_back();
        }
        pool_[size_t(c)].next = -1, pool_[size_t(c)].size = 0;
        (after < 0 ? first_[bucket] : pool_[size_t(after)].next) = c;
        return last_[bucket] = c;
    }

    std::vector<Chunk> pool_;
    std::vector<int> first_, last_;
    int free_ = -1;
    size_t size_ = 0;
};

}  // namespace mw
