// Sorting by halves: what is sorted are middles of boxes with their numbers, 16 bytes side by side, so that each pass over a range is a plain
// scan.
#include "core/mesh/box_tree.h"

#include <cmath>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace mw {

namespace {

constexpr uint32_t alone = 8192;  // a range of fewer is one thread's

struct Entry {
    glm::vec3 middle;
    uint32_t number;
};

struct Builder {
    std::span<const BoundingBox> own;
    Array<Entry> entries;
    Array<BoundingBox>& nodes;
    Progress* progress;

    void build(BoxTree::Range r);
    void split(const BoxTree::Range& r);
};

void Builder::split(const BoxTree::Range& r)
{
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (uint32_t i = r.first; i < r.last; ++i) {
        low = glm::min(low, entries[i].middle);
        high = glm::max(high, entries[i].middle);
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = entries.begin();
    std::nth_element(begin + r.first, begin + r.middle(), begin + r.last, [axis](const Entry& a, const Entry& b) {
        const float x = a.middle[axis], y = b.middle[axis];
        return x != y ? x < y : a.number < b.number;
    });
}

void Builder::build(BoxTree::Range r)
{
    BoundingBox& box = nodes[r.node];
    if (2 * size_t(r.node) + 1 >= nodes.size()) {
        box = {glm::vec3(INFINITY), glm::vec3(-INFINITY)};
        for (uint32_t i = r.first; i < r.last; ++i) box.add(own[entries[i].number]);
        return;
    }
    if (progress && r.last - r.first > 4 * alone) progress->at(progress->fraction);
    split(r);
    const BoxTree::Range left = BoxTree::left(r), right = BoxTree::right(r);
    if (r.last - r.first < alone) {
        build(left);
        build(right);
    } else {
        tbb::parallel_invoke([&] { build(left); }, [&] { build(right); });
    }
    box = nodes[left.node];
    box.add(nodes[right.node]);
}

}  // namespace

BoxTree::BoxTree(std::span<const BoundingBox> boxes, Progress* progress) : order_(boxes.size())
{
    if (boxes.empty()) return;
    size_t leaves = 1;
    while (leaves * leafSize < boxes.size()) leaves *= 2;
    boxes_.resize(2 * leaves - 1);
    Builder b{boxes, Array<Entry>(boxes.size()), boxes_, progress};
    const tbb::blocked_range<size_t> all(0, boxes.size(), alone);
    tbb::parallel_for(all, [&](const auto& part) {
        for (size_t i = part.begin(); i < part.end(); ++i) b.entries[i] = {0.5f * boxes[i].min + 0.5f * boxes[i].max, uint32_t(i)};
    });
    b.build(root());
    tbb::parallel_for(all, [&](const auto& part) {
        for (size_t i = part.begin(); i < part.end(); ++i) order_[i] = b.entries[i].number;
    });
}

}  // namespace mw
