// A tree of boxes over many small ones: what searches for neighbours, closest points and intersections walk.
#pragma once
#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/mesh/array.h"
#include "core/steps/progress.h"

namespace mw {

/// Parallel to the axes; its sides belong to it.
struct BoundingBox {
    glm::vec3 min, max;
    bool overlaps(const BoundingBox& b) const
    {
        return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y && min.z <= b.max.z && b.min.z <= max.z;
    }
    void add(const BoundingBox& b)
    {
        min = {std::min(min.x, b.min.x), std::min(min.y, b.min.y), std::min(min.z, b.min.z)};
        max = {std::max(max.x, b.max.x), std::max(max.y, b.max.y), std::max(max.z, b.max.z)};
    }
    /// Squared distance of a point; 0 inside.
    double distance2(const glm::dvec3& p) const
    {
        double sum = 0;
        for (int k = 0; k < 3; ++k) {
            const double d = std::max({double(min[k]) - p[k], p[k] - double(max[k]), 0.0});
            sum += d * d;
        }
        return sum;
    }
};

/// A complete binary tree: node k has the children 2k + 1 and 2k + 2, which share its range of places by halves. Ranges are cut at the middle of the
/// boxes along the longest side; ties by number, so that the order is the same on every run. O(n log n), on all cores.
class BoxTree {
public:
    /// A node and the places it covers: order()[first] .. order()[last - 1] are the numbers of its boxes.
    struct Range {
        uint32_t node = 0, first = 0, last = 0;
        uint32_t middle() const { return first + (last - first) / 2; }
    };
    static constexpr uint32_t leafSize = 4;

    BoxTree() = default;
    /// Throws Cancelled. At most 2^31 boxes.
    explicit BoxTree(std::span<const BoundingBox> boxes, Progress* progress = nullptr);

    uint32_t size() const { return uint32_t(order_.size()); }
    const Array<uint32_t>& order() const { return order_; }
    size_t nodes() const { return boxes_.size(); }
    const BoundingBox& box(uint32_t node) const { return boxes_[node]; }
    Range root() const { return {0, 0, size()}; }
    bool isLeaf(const Range& r) const { return 2 * size_t(r.node) + 1 >= boxes_.size(); }
    static Range left(const Range& r) { return {2 * r.node + 1, r.first, r.middle()}; }
    static Range right(const Range& r) { return {2 * r.node + 2, r.middle(), r.last}; }

private:
    Array<uint32_t> order_;
    Array<BoundingBox> boxes_;  // of nodes
};

}  // namespace mw
