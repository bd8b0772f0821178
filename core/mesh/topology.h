// What a mesh is and what is wrong with it: counts, Euler characteristic, genus, components, boundary loops, offenders.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// Of the faces as indexed (nothing is merged). Degenerate faces (fewer than 3 corners, a vertex twice) are left out of edges, components,
/// loops and Euler characteristic, which counts the vertices of the others only. Book 2.3.
struct TopologyReport {
    size_t vertices = 0, edges = 0, faces = 0, triangles = 0;  ///< vertices: all; triangles: after cutting polygons
    size_t components = 0;                                     ///< of faces, joined by common vertices
    long euler = 0;
    std::optional<long> genus;  ///< only for a manifold, orientable mesh without degenerate faces
    bool orientable = true, consistentlyOriented = true, closed = false;
    std::map<size_t, size_t> vertexValences, faceSizes;  ///< valence (edges at the vertex) or size to number of elements
    size_t regularVertices = 0;                          ///< inner valence 6 (triangles) or 4 (else); boundary 4 or 3

    using Edge = std::pair<uint32_t, uint32_t>;        ///< lower vertex first
    std::vector<std::vector<uint32_t>> boundaryLoops;  ///< vertices of each component of the graph of boundary edges, walked round where it is a
                                                       ///< simple loop (the hole on the left), else ascending
    size_t boundaryEdges = 0;
    std::vector<Edge> nonmanifoldEdges;                                       ///< more than two faces
    std::vector<uint32_t> nonmanifoldVertices;                                ///< more than one fan of faces
    std::vector<Edge> inconsistentEdges;                                      ///< two faces run along it the same way
    std::vector<uint32_t> degenerateFaces, duplicateFaces, isolatedVertices;  ///< duplicate: same vertex set as an earlier face
    bool manifold() const { return nonmanifoldEdges.empty() && nonmanifoldVertices.empty(); }
};

TopologyReport topologyOf(const Mesh& mesh);

/// Area of all faces and signed volume enclosed (meaningful when closed), in units of the positions.
double surfaceArea(const Mesh& mesh);
double enclosedVolume(const Mesh& mesh);

}  // namespace mw
