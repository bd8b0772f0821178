// Sets of vertices, edges or faces of one mesh: combined, grown, walked along, converted, and written as text. Pure functions on the mesh as
// indexed, near-linear; none of them needs a manifold.
#pragma once
#include <string>
#include <string_view>

#include "core/mesh/table.h"

namespace mw {

/// Ascending and each once, edges with the lower vertex first: what every function here expects and gives. Entries of an edge that is none
/// (a vertex twice) are dropped.
ElementSet sorted(ElementSet gathered);
size_t countOf(const ElementSet& set);  ///< of elements: half the indices of edges

// Of two sets of one kind.
ElementSet united(const ElementSet& a, const ElementSet& b);
ElementSet without(const ElementSet& a, const ElementSet& b);
ElementSet toggled(const ElementSet& a, const ElementSet& b);  ///< in one of them, not in both

// Of a mesh. Edges are those of faces. Indices that the mesh does not have are left out.
ElementSet allElements(const Mesh& mesh, ElementKind kind);
ElementSet inverted(const Mesh& mesh, const ElementSet& set);
/// Down (faces to edges to vertices): all that belong to one of the set. Up: those that lie wholly in it, or, `touching`, those that have part
/// in it.
ElementSet converted(const Mesh& mesh, const ElementSet& set, ElementKind kind, bool touching = false);
/// One ring more: vertices joined to the set by an edge; edges and faces that share a vertex with it.
ElementSet grown(const Mesh& mesh, const ElementSet& set);
/// One ring less: without what has a neighbour outside. The border of the mesh itself does not shrink.
ElementSet shrunk(const Mesh& mesh, const ElementSet& set);
/// All of the components the set touches. A component is faces joined by common vertices, or a vertex without faces.
ElementSet connected(const Mesh& mesh, const ElementSet& set);

/// Every edge is followed straight on, both ways: across vertices of four edges, or of six among triangles, as long as they are inside. An edge
/// of the border follows the border.
ElementSet edgeLoop(const Mesh& mesh, const ElementSet& edges);
/// Every edge is followed across quads to the opposite one, both ways.
ElementSet edgeRing(const Mesh& mesh, const ElementSet& edges);

/// Edges of one face (degenerate faces left out), their vertices, or the faces that have one.
ElementSet boundary(const Mesh& mesh, ElementKind kind);
/// Edges of the boundary loops that the set touches.
ElementSet boundaryLoops(const Mesh& mesh, const ElementSet& set);
/// Vertices that have from `least` to `most` edges (degenerate faces left out).
ElementSet ofValence(const Mesh& mesh, size_t least, size_t most);
/// Edges at which two faces meet at more than `degrees`.
ElementSet sharpEdges(const Mesh& mesh, double degrees);
/// The faces (of a set of vertices or edges: those that touch it) and all that are reached from them without crossing a bend of more than
/// `degrees`, edges of three and more faces, or faces without area.
ElementSet flatRegion(const Mesh& mesh, const ElementSet& set, double degrees);
/// Faces anywhere in the mesh that lie in the mean plane of the set's faces: normals at most `degrees` apart, either way round, all vertices at
/// most `distance` from it (units of the positions). Empty when the set has no area.
ElementSet coplanar(const Mesh& mesh, const ElementSet& set, double degrees, double distance);
/// The `rank`-th largest component, 0 the one with most faces; empty when there are fewer.
ElementSet component(const Mesh& mesh, ElementKind kind, size_t rank);

/// Compact text of a set, without commas or plus signs: "0-99;105;200-210"; edges as "3~7;3~9", the lower vertex first. Empty for an empty set.
std::string elementText(const ElementSet& set);
/// The inverse, in any order and with repetitions. Every index must be below `below`: pass the mesh's count, so that hostile text cannot fill the
/// memory. `kind` is Vertex, Edge or Face. Throws Error naming the part that does not fit.
ElementSet parsedElements(ElementKind kind, std::string_view text, size_t below = 50'000'000);

}  // namespace mw
