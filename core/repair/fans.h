// Cutting a mesh into manifold fans: which sides of faces stay joined, and a vertex of its own for each fan.
#pragma once
#include <utility>
#include <vector>

#include "core/mesh/connectivity.h"
#include "core/mesh/union_find.h"

namespace mw {

/// Corners at one vertex that hang together across joined sides. A side is named by the corner it starts at.
class CornerFans {
public:
    explicit CornerFans(const Mesh& mesh);
    /// The faces of two sides of one edge stay together.
    void join(uint32_t side, uint32_t otherSide);
    uint32_t fanOf(uint32_t corner) { return sets_.root(corner); }
    uint32_t next(uint32_t corner) const;  ///< within its face

private:
    const Mesh& mesh_;
    Array<uint32_t> cornerFace_;  // empty for triangles
    UnionFind sets_;
};

/// Gives each further fan at a vertex a copy of it; the fan of the lowest corner keeps the vertex, copies follow in the order of corners.
/// Only at vertices marked in `where` (empty: everywhere).
Mesh splitAtFans(const Mesh& mesh, CornerFans& fans, const std::vector<uint8_t>& where = {});

/// Splits non-manifold edges and vertices; no face is lost, none changes its shape. At an edge of more than two faces those stay together
/// that bound the same piece of the inside, if as many run one way as the other, else the flattest pair of opposite ones; further faces get an
/// edge of their own. Without `edges` only vertices are split, without `vertices` only those at the ends of such edges. Degenerate faces stay.
/// In a mesh that was marked before it was welded, what was joined then stays joined, and two sides that only welding brought together part
/// again where the surface would become one-sided, or a face would be glued to its own back.
Mesh splitNonmanifold(const Mesh& mesh, bool edges = true, bool vertices = true);

/// The mesh with what splitNonmanifold wants to know of it later: for each corner its vertex, for each face the piece of surface it belongs to
/// and which way it turns within it.
Mesh markedForWelding(const Mesh& mesh);
Mesh withoutMarks(const Mesh& mesh);

}  // namespace mw
