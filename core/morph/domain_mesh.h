// A triangle mesh laid on the sphere or in the plane, with its neighbours: what two of are overlaid.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"
#include "core/morph/direction.h"

namespace mw {

/// Half-edge h = 3 f + k runs from corner k of triangle f to the next. A closed mesh covers the sphere once, one with a border is a convex region of
/// the plane; in both every triangle is anticlockwise and has an area (folds() is 0).
class DomainMesh {
public:
    DomainMesh() = default;
    /// Throws Error when an edge has more than two triangles or two that run along it the same way.
    DomainMesh(std::vector<Direction> places, std::vector<uint32_t> triangles);

    size_t vertices() const { return places_.size(); }
    size_t triangles() const { return corners_.size() / 3; }
    size_t edges() const { return edgeHalf_.size(); }
    const std::vector<uint32_t>& corners() const { return corners_; }

    static uint32_t next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static uint32_t previous(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    uint32_t from(uint32_t h) const { return corners_[h]; }
    uint32_t to(uint32_t h) const { return corners_[next(h)]; }
    uint32_t opposite(uint32_t h) const { return opposite_[h]; }  ///< none at the border
    uint32_t edge(uint32_t h) const { return edge_[h]; }
    uint32_t half(uint32_t e) const { return edgeHalf_[e]; }  ///< the first of its half-edges
    std::span<const uint32_t> outgoing(uint32_t v) const { return {out_.data() + outStart_[v], outStart_[v + 1] - outStart_[v]}; }
    const Direction& at(uint32_t v) const { return places_[v]; }
    uint32_t triangleLeft(uint32_t h) const { return h / 3; }
    uint32_t triangleRight(uint32_t h) const { return opposite_[h] == none ? none : opposite_[h] / 3; }

    /// Triangles that are turned over or have no area.
    std::vector<uint32_t> folds() const;
    /// How often the sphere is covered: the sum of the solid angles over 4 pi.
    double coverings() const;

private:
    std::vector<Direction> places_;
    std::vector<uint32_t> corners_, opposite_, edge_, edgeHalf_, outStart_, out_;
};

}  // namespace mw
