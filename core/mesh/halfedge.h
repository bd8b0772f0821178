// The half-edge view of a mesh: OpenMesh's connectivity, filled in bulk from the flat arrays. Include it in .cpp files only.
#pragma once
#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Always a manifold, whatever the payload: a third face on an edge, or a neighbour of the same direction, gets an edge of its own; a further
/// fan at a vertex gets a copy of the vertex; a degenerate face is left out. View index = payload index wherever nothing was split or left out.
/// Connectivity only: positions are those of the mesh, `mesh.positions()[view.vertexOf(v)]`.
/// Beware: two edges between the same two vertices may occur; hot code uses the inline handles, not find_halfedge().
class HalfedgeView {
public:
    explicit HalfedgeView(const Mesh& mesh);

    OpenMesh::PolyConnectivity kernel;
    size_t payloadVertices = 0;
    std::vector<uint32_t> extraVertex;  ///< view vertex payloadVertices + i is another fan of payload vertex extraVertex[i]
    std::vector<uint32_t> payloadFace;  ///< empty: view face f is payload face f
    Array<uint32_t> cornerHalfedge;     ///< payload corner to the half-edge leaving it towards the next corner; none where left out
    size_t degenerateFaces = 0, boundaryEdges = 0, splitVertices = 0;

    uint32_t vertexOf(uint32_t v) const { return v < payloadVertices ? v : extraVertex[v - payloadVertices]; }
    uint32_t faceOf(uint32_t f) const { return payloadFace.empty() ? f : payloadFace[f]; }
};

}  // namespace mw
