#include "core/mesh/triangle_tree.h"

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/math/closest.h"

namespace mw {

namespace {

constexpr size_t piece = 8192;
// A box's distance is rounded as that of a triangle in it is: only what is clearly farther is passed over, so that ties are seen.
constexpr double clearly = 1 - 1e-12;

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh, Progress* progress) : faces_(mesh.triangulation().faces)
{
    const Shared<uint32_t>& vertices = mesh.triangulation().vertices;
    const Shared<glm::vec3>& positions = mesh.positions();
    const size_t n = vertices.size() / 3;
    const tbb::blocked_range<size_t> all(0, n, piece);
    Array<BoundingBox> own(n);
    tbb::parallel_for(all, [&](const auto& part) {
        for (size_t t = part.begin(); t < part.end(); ++t) {
            const glm::vec3 a = positions[vertices[3 * t]], b = positions[vertices[3 * t + 1]], c = positions[vertices[3 * t + 2]];
            own[t] = {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
        }
    });
    boxes_ = BoxTree(own, progress);
    corners_.resize(n);
    place_.resize(n);
    tbb::parallel_for(all, [&](const auto& part) {
        for (size_t i = part.begin(); i < part.end(); ++i) {
            const size_t t = boxes_.order()[i];
            for (size_t k = 0; k < 3; ++k) corners_[i][k] = positions[vertices[3 * t + k]];
            place_[t] = uint32_t(i);
        }
    });
}

void TriangleTree::offer(uint32_t place, const glm::dvec3& p, ClosestPoint& best) const
{
    const glm::dvec3 a = corners_[place][0], b = corners_[place][1], c = corners_[place][2];
    const glm::dvec3 w = closestOnTriangle(p, a, b, c), at = w.x * a + w.y * b + w.z * c, gap = at - p;
    const double d = glm::dot(gap, gap);
    const uint32_t t = triangleAt(place);
    if (d < best.distance2 || (d == best.distance2 && t < best.triangle)) best = {t, faces_[t], w, at, d};
}

ClosestPoint TriangleTree::closest(const glm::dvec3& p, uint32_t near) const
{
    ClosestPoint best;
    if (near != none) offer(place_[near], p, best);
    ClosestWalk walk(*this, p, best);
    while (walk.next() != ClosestWalk::Event::End) {
    }
    return walk.best();
}

ClosestWalk::ClosestWalk(const TriangleTree& tree, const glm::dvec3& p, const ClosestPoint& best) : tree_(tree), p_(p), best_(best)
{
    if (tree.size() > 0) push(tree.boxes().root());
}

ClosestWalk::Event ClosestWalk::next()
{
    if (opens_ == 0) return Event::End;
    now_ = open_[--opens_];
    if (now_.distance2 * clearly > best_.distance2) return Event::Pruned;
    if (tree_.boxes().isLeaf(now_.range)) {
        for (uint32_t i = now_.range.first; i < now_.range.last; ++i) tree_.offer(i, p_, best_);
        return Event::Leaf;
    }
    push(BoxTree::left(now_.range));
    push(BoxTree::right(now_.range));
    if (open_[opens_ - 2].distance2 < open_[opens_ - 1].distance2) std::swap(open_[opens_ - 2], open_[opens_ - 1]);
    return Event::Opened;
}

std::vector<ClosestPoint> closestPoints(const TriangleTree& tree, std::span<const glm::dvec3> points, Progress* progress)
{
    std::vector<ClosestPoint> found(points.size());
    const float from = progress ? progress->fraction.load() : 0;
    for (size_t first = 0; first < points.size(); first += 16 * piece) {
        const size_t last = std::min(points.size(), first + 16 * piece);
        tbb::parallel_for(tbb::blocked_range<size_t>(first, last, piece / 4), [&](const auto& part) {
            uint32_t near = none;
            for (size_t i = part.begin(); i < part.end(); ++i) {
                found[i] = tree.closest(points[i], near);
                near = found[i].triangle;
            }
        });
        if (progress) progress->at(from + (1 - from) * float(last) / float(points.size()));
    }
    return found;
}

}  // namespace mw
