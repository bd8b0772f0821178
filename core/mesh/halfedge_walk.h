// Walking the half-edge view one half-edge at a time, in payload indices: what circulators, records and lessons are made of.
// For loops over a whole mesh the handles of halfedge.h are faster.
#pragma once
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Half-edges have the numbers of the view: 2e and 2e + 1 are the two of its edge e. Vertices and faces are the payload's. `none` where there is
/// nothing (the face of a half-edge of the boundary).
class HalfedgeWalk {
public:
    explicit HalfedgeWalk(const Mesh& mesh);

    size_t size() const;  ///< half-edges
    uint32_t next(uint32_t h) const;
    uint32_t prev(uint32_t h) const;
    uint32_t pair(uint32_t h) const { return h ^ 1; }
    uint32_t target(uint32_t h) const;
    uint32_t source(uint32_t h) const { return target(pair(h)); }
    uint32_t face(uint32_t h) const;
    uint32_t ofEdge(uint32_t h) const { return h / 2; }  ///< its edge

    /// The half-edge its record names: it leads to the first corner. None for a face that was left out (degenerate).
    uint32_t ofFace(uint32_t face) const;
    /// The half-edge a vertex names: it leaves the vertex, at a boundary along it. None for a vertex without faces.
    uint32_t ofVertex(uint32_t vertex) const;
    /// One leaving half-edge for each fan of faces at a vertex: more than one where the view had to split it.
    std::vector<uint32_t> fans(uint32_t vertex) const;
    /// All half-edges between two vertices, those from a to b first: two, or more where the view had to split an edge.
    std::vector<uint32_t> between(uint32_t a, uint32_t b) const;
    /// Faces that have no half-edges, ascending.
    std::vector<uint32_t> leftOut() const;

private:
    Mesh mesh_;  // keeps the view
    const HalfedgeView& view_;
    std::vector<std::pair<uint32_t, uint32_t>> copies_;  // payload vertex and further vertex of the view, ascending
};

}  // namespace mw
