// Edges of polygons gathered by sorting: the base of edge lists, rings and reports. Works on any soup.
#pragma once
#include "core/mesh/mesh.h"
#include "core/mesh/rings.h"

namespace mw {

/// The sides of faces by edge. Side c runs from corner c to the next corner of its face; sides from a vertex to itself are left out.
/// Edges are ordered by their lower vertex, then by the other; the sides of one edge ascend.
struct EdgeSides {
    Array<uint32_t> start{0u};  ///< edge e has the sides corner[start[e]] .. corner[start[e+1]-1]
    Array<uint32_t> corner;
    Array<uint32_t> ends;  ///< two vertices an edge, the lower first

    size_t size() const { return start.size() - 1; }
    std::span<const uint32_t> sides(size_t e) const { return {corner.data() + start[e], start[e + 1] - start[e]}; }
};

/// Of all faces, or of those whose entry in `leftOut` is 0.
EdgeSides edgeSidesOf(const Mesh& mesh, std::span<const uint8_t> leftOut = {});

/// For each corner the corner whose side runs the other way along the same edge; none where there is no such side. Sides are paired in the order
/// of corners, the oldest first: a third side of an edge, or one of the same direction, finds nothing unless a fourth fits it. Faces whose entry in
/// `leftOut` is not 0, and sides from a vertex to itself, have none. One pass, linear for any input.
Array<uint32_t> oppositeCornersOf(const Mesh& mesh, std::span<const uint8_t> leftOut = {});

/// Pairs of vertices, see Mesh::edges().
Array<uint32_t> edgesOf(const Mesh& mesh);
Rings ringsOf(const Mesh& mesh);

/// 1 for every face with fewer than three corners or a vertex twice; empty when there is none.
std::vector<uint8_t> degenerateFacesOf(const Mesh& mesh);

/// Face of each corner.
Array<uint32_t> cornerFacesOf(const Mesh& mesh);

}  // namespace mw
