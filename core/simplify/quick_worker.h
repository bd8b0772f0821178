// The order of collapses in the quick decimation. Lazy: an edge lies in the bucket of the cost it had when it was last looked at, and is looked at
// again only when that bucket comes up; if it has become dearer it moves on, else it is collapsed. Nothing is ranked anew after a collapse.
#pragma once
#include "core/simplify/bucket_queue.h"
#include "core/simplify/quick_collapse.h"

namespace mw::quick {

/// What is at the head of the queue, for who watches.
struct Candidate {
    int edge = -1;
    Target to{};
    uint32_t bucket = 0;
};

/// Works on the vertices of one range, or on all of them. Several may run at once when their ranges are apart.
class Worker {
public:
    static constexpr uint32_t last = BucketQueue::buckets - 1;
    static constexpr uint32_t retry = 2 * BucketQueue::perOctave;  ///< refused edges come again at four times the cost

    Worker(Tables& tables, Range range, bool lookAhead) : t_(tables), range_(range), collapser_(tables, range), lookAhead_(lookAhead) {}

    /// Puts in the edges of faces [first, end) that lie in the range, each once; faces that reach out of it are left for mixed().
    void rank(int first, int end);
    /// Puts in an edge unless it is there.
    void rank(int h);
    /// All that another worker has left, and what it could not do.
    void takeOver(Worker& other);
    void reserve(size_t edges) { queue_.reserve(edges); }

    /// Collapses what is due in buckets up to `cap`, until `most` faces are gone in all, or about `entries` entries of the queue were looked at: then
    /// true, there may be more to do.
    bool run(uint32_t cap, size_t entries, size_t most);
    /// From the cheapest one again.
    void rewind() { bucket_ = 0; }

    // One by one, in the same order: the next edge that is due, and trying it.
    enum class Found { Edge, Nothing, Pause };
    Found findNext(uint32_t cap, Candidate& next);
    Attempt tryNext(const Candidate& next);

    size_t removed() const { return removed_; }
    size_t waiting() const { return queue_.size() + size_t(size_ - at_) + size_t(lineSize_); }
    uint32_t bucket() const { return bucket_; }
    /// Edges that reach out of the range and are still there.
    size_t deferred() const;
    Collapser& collapser() { return collapser_; }

private:
    static constexpr int depth = 6, ahead = 16;
    struct Slot {
        int edge, walkA, walkB;
    };

    void push(uint32_t bucket, int h);
    bool load(uint32_t cap);
    int popLine();
    bool takeEntry(int& h);
    void pushLine(int h);
    MW_INLINE void stepAhead(int& half);
    MW_INLINE void prefetchEntry(int i);
    void putBack();
    void requeueJoined(uint32_t bucket);

    Tables& t_;
    Range range_;
    Collapser collapser_;
    BucketQueue queue_;
    uint32_t bucket_ = 0;
    int entries_[BucketQueue::chunk + ahead], size_ = 0, at_ = 0;  // the chunk in hand
    Slot line_[depth];
    int lineSize_ = 0, lineFirst_ = 0;
    bool lookAhead_;
    size_t removed_ = 0, loaded_ = 0, pauseAt_ = ~size_t(0);
    std::vector<int> outside_, mixed_;
};

}  // namespace mw::quick
