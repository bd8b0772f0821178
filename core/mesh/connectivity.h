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
/// Of all faces, or of those whose entry in `leftOut` is 0.
Rings ringsOf(const Mesh& mesh, std::span<const uint8_t> leftOut = {});
/// Of the faces that are not degenerate: those the mesh keeps, or where it has degenerate ones `own`, which is made.
const Rings& ringsOfGoodFaces(const Mesh& mesh, Rings& own);

/// 1 for every face with fewer than three corners or a vertex twice; empty when there is none.
std::vector<uint8_t> degenerateFacesOf(const Mesh& mesh);

/// Face of each corner.
Array<uint32_t> cornerFacesOf(const Mesh& mesh);

/// From corner to corner round faces, and to their faces: without a table where all are triangles.
class FaceCorners {
public:
    explicit FaceCorners(const Mesh& mesh)
        : start_(mesh.faceStart()), triangles_(mesh.isTriangles()), face_(triangles_ ? Array<uint32_t>() : cornerFacesOf(mesh))
    {}
    uint32_t faceOf(uint32_t c) const { return triangles_ ? c / 3 : face_[c]; }
    uint32_t next(uint32_t c) const
    {
        if (triangles_) return c % 3 == 2 ? c - 2 : c + 1;
        return c + 1 == start_[face_[c] + 1] ? start_[face_[c]] : c + 1;
    }
    uint32_t previous(uint32_t c) const
    {
        if (triangles_) return c % 3 == 0 ? c + 2 : c - 1;
        return (c == start_[face_[c]] ? start_[face_[c] + 1] : c) - 1;
    }

private:
    Shared<uint32_t> start_;
    bool triangles_;
    Array<uint32_t> face_;
};

}  // namespace mw
