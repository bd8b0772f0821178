// What a mesh under collapse carries: its curves from where values part, its wedges, and the way back to a payload.
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/simplify/collapse_mesh.h"

namespace mw {

namespace {

/// The end of a chain of parents.
uint32_t rootOf(const std::vector<uint32_t>& parent, uint32_t x)
{
    while (parent[x] != x) x = parent[x];
    return x;
}

/// All roots at once; parents of higher and lower index occur.
std::vector<uint32_t> rootsOf(std::vector<uint32_t> parent)
{
    for (uint32_t i = 0; i < parent.size(); ++i) {
        const uint32_t root = rootOf(parent, i);
        for (uint32_t x = i; parent[x] != root;) x = std::exchange(parent[x], root);
    }
    return parent;
}

}  // namespace

void CollapseMesh::markSeams(const SeamTest& seams)
{
    if (seams.creases()) {
        crease_.assign(vertex_.size(), 0.f);
        for (uint32_t h = 0; h < vertex_.size(); ++h) crease_[h] = seams.crease(h);
    }
    for (uint32_t h = 0; seams.any() && h < vertex_.size(); ++h)
        if (twin_[h] != none && twin_[h] > h && seams.parts(h, twin_[h])) sharp_[h] = sharp_[twin_[h]] = rule;
}

void CollapseMesh::joinWedges()
{
    wedge_.resize(vertex_.size());
    std::iota(wedge_.begin(), wedge_.end(), 0u);
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        const uint32_t g = twin_[h];
        if (g == none || g < h || onCurve(h)) continue;
        unite(wedge_, h, next(g));
        unite(wedge_, next(h), g);
    }
}

Mesh CollapseMesh::payload() const
{
    Collapsed c;
    c.into = rootsOf(into_);
    for (uint32_t v = 0; v < vertexSlots(); ++v) {
        if (into_[v] != v) continue;
        const glm::vec3 old = input_.positions()[v];
        const bool moved = place_[v] != (glm::dvec3(old) - centre_) / scale_;
        c.positions.push_back(moved ? position(place_[v]) : old);
    }
    c.corners.reserve(3 * faces_);
    for (uint32_t f = 0; f < faceSlots(); ++f) {
        if (!alive(f)) continue;
        c.triangles.push_back(f);
        c.corners.insert(c.corners.end(), vertex_.begin() + 3 * f, vertex_.begin() + 3 * f + 3);
        if (!crease_.empty()) c.creases.insert(c.creases.end(), crease_.begin() + 3 * f, crease_.begin() + 3 * f + 3);
    }
    if (!wedge_.empty()) {
        c.wedge = rootsOf(wedge_);
        std::vector<uint32_t> number(c.wedge.size(), none);
        for (uint32_t& w : c.wedge) {
            if (number[w] == none) number[w] = c.wedges++;
            w = number[w];
        }
    }
    return carried(input_, old_, std::move(c));
}

}  // namespace mw
