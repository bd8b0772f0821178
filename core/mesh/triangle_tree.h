// The triangles of a mesh in a tree of boxes: which point of the surface is closest to a given one. Book 3.4.1; Ericson 2005, 5.1 and 6.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

namespace mw {

/// `triangle` counts in Mesh::triangulation(), of triangles as close the lowest; `none` where there is none within reach.
struct ClosestPoint {
    uint32_t triangle = none, face = none;
    glm::dvec3 weights{0};  ///< barycentric, at the triangle's corners
    glm::dvec3 at{0};
    double distance2 = std::numeric_limits<double>::infinity();
};

/// 60 bytes a triangle. Exact: boxes and corners are the mesh's own floats, distances are computed in double.
class TriangleTree {
public:
    /// Throws Cancelled.
    explicit TriangleTree(const Mesh& mesh, Progress* progress = nullptr);

    size_t size() const { return corners_.size(); }
    const BoxTree& boxes() const { return boxes_; }
    /// `near` is a triangle thought to be close (that of a neighbouring query): it saves time and changes nothing.
    ClosestPoint closest(const glm::dvec3& p, uint32_t near = none) const;
    /// The triangle at a place of the tree, held against p.
    void offer(uint32_t place, const glm::dvec3& p, ClosestPoint& best) const;
    uint32_t triangleAt(uint32_t place) const { return boxes_.order()[place]; }
    uint32_t faceOf(uint32_t triangle) const { return faces_[triangle]; }

private:
    BoxTree boxes_;
    Array<std::array<glm::vec3, 3>> corners_;  // in the order of the tree
    Array<uint32_t> place_;                    // of each triangle in that order
    Shared<uint32_t> faces_;
};

/// The search, one box at a time: the nearer child first, boxes farther than the best triangle so far are passed over.
class ClosestWalk {
public:
    enum class Event { Opened, Leaf, Pruned, End };

    ClosestWalk(const TriangleTree& tree, const glm::dvec3& p, const ClosestPoint& best = {});
    Event next();
    const ClosestPoint& best() const { return best_; }
    /// What next() has just dealt with, and how far its box is.
    const BoxTree::Range& node() const { return now_.range; }
    double nodeDistance2() const { return now_.distance2; }

private:
    struct Open {
        BoxTree::Range range;
        double distance2;
    };
    void push(const BoxTree::Range& r) { open_[opens_++] = {r, tree_.boxes().box(r.node).distance2(p_)}; }

    const TriangleTree& tree_;
    glm::dvec3 p_;
    ClosestPoint best_;
    Open now_{};
    std::array<Open, 64> open_;  // deeper than any tree of 32-bit numbers
    size_t opens_ = 0;
};

/// For each point, on all cores. Points in an order in which neighbours follow each other go several times faster. Throws Cancelled.
std::vector<ClosestPoint> closestPoints(const TriangleTree& tree, std::span<const glm::dvec3> points, Progress* progress = nullptr);

}  // namespace mw
