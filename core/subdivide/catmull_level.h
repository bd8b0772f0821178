// One level of a polygon mesh under Catmull-Clark refinement: tables from which the next level follows by formula, without any search.
#pragma once
#include "core/mesh/mesh.h"
#include "core/subdivide/face_edges.h"
#include "core/subdivide/lanes.h"

namespace mw {

/// Half-edges as in FaceEdges. Vertex v stays v, edge e gives vertex V + e, face f gives V + E + f. Corner c of face f, whatever its size, gives the
/// quad c = (v, middle of the side that begins at c, centre of f, middle of the side that ends there). Edge e gives 2e at its end a and 2e+1 at b;
/// then come the edges inside, 2E + c from the middle of side c to the centre.
struct CatmullLevel {
    struct Edge {
        uint32_t a, b;  ///< ends
        uint32_t f, g;  ///< the face that runs a to b, and the other; the same at a border
    };
    struct Irregular {
        uint32_t vertex, edges, faces;
    };
    size_t vertices = 0;
    Array<uint32_t> faceStart;  ///< empty: all are quads
    Array<uint32_t> vertex, half;
    Array<Edge> edges;
    std::vector<SharpEdge> sharp;      ///< ascending
    std::vector<SharpVertex> creases;  ///< what they do to vertices
    std::vector<Irregular> irregular;  ///< vertices without four edges and four faces
    std::vector<uint32_t> fixed;       ///< vertices that stay whatever their edges say

    size_t faces() const { return faceStart.empty() ? vertex.size() / 4 : faceStart.size() - 1; }
    uint32_t firstCorner(size_t f) const { return faceStart.empty() ? uint32_t(4 * f) : faceStart[f]; }
    /// Without what only refining needs: half-edges.
    void keepForPoints() { half = {}; }
    size_t bytes() const;
    /// Finds the edges. Every face has three corners or more. `crease` by corner, or empty; `lasting` as faceEdgesOf.
    static CatmullLevel of(const Mesh& mesh, std::span<const float> crease, bool sharpCorners, float lasting = 1);
    /// The next level, of quads; without half-edges and edges if it is the last one.
    CatmullLevel refined(bool last) const;
};

/// Positions of the next level: faces, then edges, each in any number of calls from 0 on, then vertices.
class CatmullPoints {
public:
    CatmullPoints(const CatmullLevel& level, const Array<glm::vec3>& old);
    void faces(size_t first, size_t end);
    void edges(size_t first, size_t end);
    void vertices();

    Array<glm::vec3> points;  ///< of the next level: vertices, edges, faces

private:
    const CatmullLevel& level_;
    lanes::PaddedView old_;
    Array<lanes::Sum> ring_;  // sum of the neighbours of each vertex and of the points of its faces
};

/// The same as rows, for attributes. The first source of a vertex is itself.
Stencils catmullVertexRows(const CatmullLevel& level);

}  // namespace mw
