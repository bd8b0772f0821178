// The faces between the pieces of edges, cut into triangles. In the map each lies in one triangle of either mesh and is convex, but may have corners
// of 180 degrees: such an ear is never cut, and of the others the one whose shape is best in both meshes.
#include <algorithm>

#include "core/error.h"
#include "core/morph/overlay.h"

namespace mw {

namespace {

bool straight(const std::array<uint32_t, 2>& a, const std::array<uint32_t, 2>& b)
{
    return (a[0] != none && a[0] == b[0]) || (a[1] != none && a[1] == b[1]);
}

}  // namespace

/// Area against the squares of the sides: 1 for the equilateral; the worse of the two shapes.
double Overlay::quality(uint32_t a, uint32_t b, uint32_t c) const
{
    double worst = 1;
    for (const std::vector<glm::dvec3>& p : positions_) {
        const glm::dvec3 u = p[b] - p[a], v = p[c] - p[a], w = p[c] - p[b];
        const double sides = glm::dot(u, u) + glm::dot(v, v) + glm::dot(w, w);
        worst = std::min(worst, sides > 0 ? 3.4641 * glm::length(glm::cross(u, v)) / sides : 0);
    }
    return worst;
}

void Overlay::emit(const Side& a, const Side& b, const Side& c, std::array<uint32_t, 2> lastLine, std::array<uint32_t, 2> from)
{
    corners_.insert(corners_.end(), {a.vertex, b.vertex, c.vertex});
    for (int in = 0; in < 2; ++in) {
        from_[in].push_back(from[in]);
        line_[in].insert(line_[in].end(), {a.line[in], b.line[in], lastLine[in]});
    }
}

void Overlay::triangulate(std::vector<Side>& polygon, std::array<uint32_t, 2> from)
{
    const std::array<uint32_t, 2> inside{none, none};
    while (polygon.size() > 3) {
        const size_t n = polygon.size();
        size_t best = n;
        double bestQuality = -1;
        for (size_t i = 0; i < n; ++i) {
            const Side &before = polygon[(i + n - 1) % n], &here = polygon[i], &after = polygon[(i + 1) % n];
            if (straight(before.line, here.line)) continue;
            // What is left must not lie on one line.
            size_t bends = 0;
            for (size_t k = 1; k + 2 < n; ++k) bends += !straight(polygon[(i + k) % n].line, polygon[(i + k + 1) % n].line);
            if (bends == 0) continue;
            const double q = quality(before.vertex, here.vertex, after.vertex);
            if (q > bestQuality) best = i, bestQuality = q;
        }
        if (best == n) throw Error("a face between the edges of the two maps has no area; one of the maps is folded");
        const size_t before = (best + n - 1) % n, after = (best + 1) % n;
        emit(polygon[before], polygon[best], polygon[after], inside, from);
        polygon[before].line = inside;
        polygon.erase(polygon.begin() + ptrdiff_t(best));
    }
    emit(polygon[0], polygon[1], polygon[2], polygon[2].line, from);
}

bool Overlay::fill(size_t most)
{
    std::vector<Side> polygon;
    for (; fillAt_ < nextHalf_.size() && most > 0; ++fillAt_) {
        if (filled_[fillAt_]) continue;
        --most;
        polygon.clear();
        const Piece& first = pieces_[fillAt_ / 2];
        const std::array<uint32_t, 2> from = fillAt_ & 1 ? first.right : first.left;
        for (uint32_t h = fillAt_; !filled_[h]; h = nextHalf_[h]) {
            filled_[h] = true;
            polygon.push_back({origin(h), pieces_[h / 2].line});
        }
        if (from[0] == none || from[1] == none) continue;  // what lies outside the border
        if (polygon.size() < 3) throw Error("a face between the edges of the two maps has no area; one of the maps is folded");
        triangulate(polygon, from);
    }
    return fillAt_ < nextHalf_.size();
}

}  // namespace mw
