// Bucket by bucket: what is due, what has become dearer, what is tried again.
#include "core/simplify/quick_worker.h"

#include <algorithm>

namespace mw::quick {

void Worker::push(uint32_t bucket, int h)
{
    t_.faces[size_t(h >> 2)].setQueued(h);
    queue_.push(bucket, h);
}

void Worker::rank(int h)
{
    if (!t_.alive(h)) return;
    t_.faces[size_t(h >> 2)].clearQueued(h);
    const int g = t_.twin(h);
    if (g < 0 || !t_.faces[size_t(g >> 2)].queued(g)) push(BucketQueue::bucketOf(t_.target(h).cost), h);
}

// The lower half-edge names an edge, unless its face is one that nobody ranks here.
void Worker::rank(int first, int end)
{
    for (int f = first; f < end; ++f) {
        const Face& face = t_.faces[size_t(f)];
        if (face.v[0] < 0) continue;
        if (!range_.holds(face.v[0]) || !range_.holds(face.v[1]) || !range_.holds(face.v[2])) {
            mixed_.push_back(f);
            continue;
        }
        for (int h = 4 * f; h < 4 * f + 3; ++h) {
            const int g = face.twin[h & 3];
            if (g < 0 || g > h || !range_.holds(t_.from(prev(g)))) push(BucketQueue::bucketOf(t_.target(h).cost), h);
        }
    }
}

void Worker::takeOver(Worker& other)
{
    int edges[BucketQueue::chunk];
    other.putBack();
    for (uint32_t b = 0; b <= last; ++b)
        while (!other.queue_.empty(b)) {
            const int n = other.queue_.take(b, edges);
            for (int i = 0; i < n; ++i) queue_.push(b, edges[i]);
        }
    other.queue_.clear();
    for (const int h : other.outside_) rank(h);
    for (const int f : other.mixed_)
        for (int h = 4 * f; h < 4 * f + 3; ++h)
            if (t_.alive(h) && !t_.faces[size_t(f)].queued(h)) rank(h);
}

size_t Worker::deferred() const
{
    return size_t(std::count_if(outside_.begin(), outside_.end(), [&](int h) { return t_.alive(h); }));
}

bool Worker::load(uint32_t cap)
{
    while (bucket_ <= cap && queue_.empty(bucket_)) ++bucket_;
    if (bucket_ > cap) return false;
    size_ = queue_.take(bucket_, entries_);
    for (int i = 0; i < ahead; ++i) entries_[size_ + i] = entries_[size_ - 1];
    at_ = 0;
    loaded_ += size_t(size_);
    return true;
}

void Worker::putBack()
{
    while (lineSize_ > 0) {
        const int h = popLine();
        if (t_.alive(h)) push(bucket_, h);
    }
    for (; at_ < size_; ++at_)
        if (t_.alive(entries_[at_])) queue_.push(bucket_, entries_[at_]);
}

// Before an edge is collapsed it waits in a short line while its two fans are walked, one step whenever another edge comes in, so that the memory of
// some collapses arrives at once and not of one after the other.
MW_INLINE void Worker::stepAhead(int& half)
{
    if (half < 0) return;
    const Face& f = t_.faces[size_t(half >> 2)];
    const int k = half & 3;
    __builtin_prefetch(&t_.vertices[size_t(f.v[k == 2 ? 0 : k + 1])]);
    const int rim = f.twin[k == 2 ? 0 : k + 1];
    if (rim >= 0) __builtin_prefetch(&t_.faces[size_t(rim >> 2)]);
    half = f.twin[k == 0 ? 2 : k - 1];
    if (half >= 0) __builtin_prefetch(&t_.faces[size_t(half >> 2)]);
}

void Worker::pushLine(int h)
{
    for (int i = 0; i < lineSize_; ++i) {
        Slot& s = line_[(lineFirst_ + i) % depth];
        if (!t_.alive(s.edge)) continue;
        stepAhead(s.walkA);
        stepAhead(s.walkB);
    }
    const int g = t_.twin(h);
    if (g >= 0) __builtin_prefetch(&t_.faces[size_t(g >> 2)]);
    line_[(lineFirst_ + lineSize_++) % depth] = {h, h, g};
}

int Worker::popLine()
{
    const int h = line_[lineFirst_].edge;
    lineFirst_ = (lineFirst_ + 1) % depth;
    --lineSize_;
    return h;
}

MW_INLINE void Worker::prefetchEntry(int i)
{
    __builtin_prefetch(&t_.faces[size_t(entries_[i + ahead] >> 2)]);
    const int near = entries_[i + ahead / 2], k = near & 3;
    const Face& f = t_.faces[size_t(near >> 2)];
    if (f.v[0] < 0) return;
    __builtin_prefetch(&t_.vertices[size_t(f.v[k])]);
    __builtin_prefetch(&t_.vertices[size_t(f.v[k == 2 ? 0 : k + 1])]);
}

// False for one that is gone, or for whose edge another entry stands.
MW_INLINE bool Worker::takeEntry(int& h)
{
    prefetchEntry(at_);
    h = entries_[at_++];
    Face& f = t_.faces[size_t(h >> 2)];
    if (f.v[0] < 0 || !f.queued(h)) return false;
    f.clearQueued(h);
    return true;
}

Worker::Found Worker::findNext(uint32_t cap, Candidate& found)
{
    for (;;) {
        int h = -1;
        bool waited = !lookAhead_;
        if (lineSize_ == depth || (lineSize_ > 0 && at_ == size_ && queue_.empty(bucket_))) {
            h = popLine();
            waited = true;
            if (!t_.alive(h)) continue;
        } else if (at_ < size_) {
            if (!takeEntry(h)) continue;
        } else if (loaded_ >= pauseAt_) {
            return Found::Pause;
        } else if (load(cap)) {
            continue;
        } else {
            return Found::Nothing;
        }
        const Target to = t_.target(h);
        const uint32_t now = BucketQueue::bucketOf(to.cost);
        if (now > bucket_) {
            push(now, h);
        } else if (!waited) {
            pushLine(h);
        } else {
            found = {h, to, bucket_};
            return Found::Edge;
        }
    }
}

Attempt Worker::tryNext(const Candidate& next)
{
    static const uint32_t cheapest = BucketQueue::bucketOf(1e-20f), dearest = BucketQueue::bucketOf(1e3f);
    const int h = next.edge;
    const size_t faces = t_.twin(h) >= 0 ? 2 : 1;
    const Attempt a = collapser_.attempt(h, next.to);
    if (a.outside) {
        t_.faces[size_t(h >> 2)].setQueued(h);
        outside_.push_back(h);
    } else if (a.refusal == Refusal::None) {
        removed_ += faces;
        requeueJoined(next.bucket);
    } else if (a.refusal == Refusal::Link || a.refusal == Refusal::Turn || a.refusal == Refusal::Fold ||
               (a.refusal == Refusal::Feature && t_.collapsible(h))) {
        const uint32_t again = std::max(next.bucket, cheapest) + retry;
        if (again < dearest) push(again, h);
    }
    return a;
}

// Two edges have become one, of which one entry is enough.
void Worker::requeueJoined(uint32_t bucket)
{
    const int(&joined)[4] = collapser_.joined();
    for (int i = 0; i < 4; i += 2) {
        const int x = joined[i], y = joined[i + 1];
        const bool xThere = x >= 0 && t_.faces[size_t(x >> 2)].queued(x), yThere = y >= 0 && t_.faces[size_t(y >> 2)].queued(y);
        if (xThere && yThere)
            t_.faces[size_t(y >> 2)].clearQueued(y);
        else if (!xThere && !yThere && (x >= 0 || y >= 0))
            push(bucket, x >= 0 ? x : y);
    }
}

bool Worker::run(uint32_t cap, size_t entries, size_t most)
{
    pauseAt_ = loaded_ + entries;
    Candidate next;
    while (removed_ < most) {
        const Found found = findNext(cap, next);
        if (found != Found::Edge) return found == Found::Pause;
        tryNext(next);
    }
    return false;
}

}  // namespace mw::quick
