// Where to cut a mesh so that it can be laid flat: shortest paths along edges, and the edges that make it a disk.
#pragma once
#include <span>

#include "core/mesh/mesh.h"
#include "core/steps/progress.h"

namespace mw {

/// Shortest ways along edges from the nearest of several vertices (Dijkstra, lengths of edges; ties by index).
struct EdgeDistances {
    Array<double> distance;  ///< infinite where there is no way
    Array<uint32_t> before;  ///< the vertex before it on the way; none at a start
};
/// `target`: stops there. Hears a cancel at each vertex. O(n log n).
EdgeDistances edgeDistances(const Mesh& mesh, std::span<const uint32_t> starts, uint32_t target = none, Progress* progress = nullptr);

/// Vertices of the shortest way along edges, both ends included. Empty when there is none.
std::vector<uint32_t> edgePath(const Mesh& mesh, uint32_t from, uint32_t to);

/// Edges (pairs of vertices) to cut so that each component becomes a disk: a tree of faces is grown over long loops first (tree-cotree, Eppstein
/// 2003; the lengths of Erickson and Whittlesey 2005), the edges it does not cross are pruned of their twigs. Borders are joined by paths; a closed
/// component of genus 0 gets a path between two far vertices. Empty for disks. Faces must have three different corners and edges at most two faces
/// (else Error). O(n log n).
std::vector<uint32_t> diskCut(const Mesh& mesh);

}  // namespace mw
