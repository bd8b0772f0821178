// One level of a triangle mesh under dyadic refinement: tables from which the next level follows by formula, without any search.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/subdivide/face_edges.h"
#include "core/subdivide/lanes.h"
#include "core/subdivide/subdivide_loop.h"

namespace mw {

/// Corner c of triangle c/3 has the half-edge half[c] = 2e + s of edge e, s = 0 where the corner runs in the edge's own direction a to b. Edges with
/// more than two faces have several corners with the same half-edge; they are sharp, and nothing else about them matters.
///
///            v0                New vertices: v stays v, edge e gives V + e.
///           /  \               New edges: 2e at a and 2e+1 at b; then three inside each triangle f, 2E + 3f + k around its corner k.
///         m0 -- m2             Triangle f gives 4f + k = (v_k, m_k, m_k-1) and 4f + 3 = (m_0, m_1, m_2).
///        /  \  /  \ .
///      v1 -- m1 -- v2
struct LoopLevel {
    struct Edge {
        uint32_t a, b;  ///< ends
        uint32_t c, d;  ///< opposite corners in the face that runs a to b, and in the other
    };
    size_t vertices = 0;
    Array<uint32_t> vertex, half;
    Array<Edge> edges;
    std::vector<SharpEdge> sharp;                          ///< ascending
    std::vector<SharpVertex> creases;                      ///< what they do to vertices
    std::vector<std::pair<uint32_t, uint32_t>> irregular;  ///< vertices whose valence is not 6, and it
    std::vector<uint32_t> fixed;                           ///< vertices that stay whatever their edges say

    size_t faces() const { return vertex.size() / 3; }
    /// Without what only refining needs: half-edges and corners.
    void keepForPoints();
    size_t bytes() const;
    /// Finds the edges of a triangle mesh. `crease` by corner, or empty; `lasting` as faceEdgesOf.
    static LoopLevel of(const Mesh& triangles, std::span<const float> crease, SubdivideLoop::Corners corners, float lasting = 1);
    /// The next level; without half-edges and edges if it is the last one.
    LoopLevel refined(bool last) const;
};

/// Positions of the next level. Edges first, in any number of calls from 0 on, then vertices; then finish().
class LoopPoints {
public:
    LoopPoints(const LoopLevel& level, const Array<glm::vec3>& old, SubdivideLoop::Weights weights);
    void edges(size_t first, size_t end);
    void vertices();

    Array<glm::vec3> points;  ///< of the next level: vertices, then edges

private:
    const LoopLevel& level_;
    lanes::PaddedView old_;
    SubdivideLoop::Weights weights_;
    Array<lanes::Sum> ring_;  // of the neighbours of each vertex
};

/// The same as rows, for attributes. The first source of a vertex is itself.
Stencils loopVertexRows(const LoopLevel& level, SubdivideLoop::Weights weights);

}  // namespace mw
