// One round of sqrt(3) subdivision: centres put in, edges flipped, old vertices relaxed, as tables.
#pragma once
#include "core/mesh/mesh.h"
#include "core/subdivide/face_edges.h"

namespace mw {

/// Side k of triangle f (corner 3f + k) makes triangle 3f + k, at first (start, end, apex) with the centre of f as its apex. In a round that cuts
/// sharp edges, a triangle at one of them gets no centre: its two other sides have the nearer of the two new points as their apex, the third piece
/// lies between. Flipping an edge turns the triangles of its two sides into (start, other apex, own apex).
struct Sqrt3Round {
    Mesh mesh;  ///< of triangles, as the round begins
    bool cutsSharp;
    FaceEdges edges;
    std::vector<uint8_t> sharp;    ///< by edge
    Array<uint32_t> centre;        ///< by face; none where it has none
    Array<uint32_t> firstOnSharp;  ///< by edge: the point nearer to its end a, the other one follows; none where it is not cut
    Array<uint32_t> triangles;     ///< as they stand
    Array<glm::vec3> points;       ///< as they stand: old vertices, centres, points on sharp edges
    Stencils rows;                 ///< of all vertices when the round has ended

    Sqrt3Round(Mesh triangleMesh, bool cutsSharpEdges);
    size_t centres() const { return centres_; }
    bool flips(uint32_t e) const { return !sharp[e]; }
    void flip(uint32_t e);
    /// Where old vertex v goes.
    glm::vec3 relaxed(uint32_t v) const;
    /// The other corner of an edge that is flipped; none if it is not.
    uint32_t partner(uint32_t corner) const;

private:
    void addVertexRows();
    void addPieces();
    void cutAlong(uint32_t e);
    size_t centres_ = 0;
    Array<Ends> along_;  // by vertex: its two neighbours on sharp edges; a none where there are none, b none where it is a corner
};

/// The weight of the mean of n neighbours: (4 - 2 cos(2 pi/n))/9.
double sqrt3Weight(size_t n);

}  // namespace mw
