// Iterators: all vertices, faces, edges or half-edges in order, with the numbers of listings 2.2 to 2.4. Book 2.6.1.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct Iterate {
    enum class Elements { Vertices, Faces, Edges, Halfedges } elements = Elements::Vertices;
    template <class V>
    void describe(V& v)
    {
        v.choice(
            "elements", elements, {"vertices", "faces", "edges", "half-edges"},
            {.title = "Elements",
             .help = "What is gone through: vertices with place and valence, faces with their number of vertices, edges with length and dihedral "
                     "angle, half-edges with what their records name."});
    }
};

/// Vertices: valence (edges that meet there) and place. Faces: size and the half-edge the face names. Edges of the half-edge view, in its order:
/// the angle between the normals of their faces in degrees, positive where the surface bulges, negative where it is hollow, undefined at the
/// boundary; length; middle. Half-edges: source, target, face, next, previous and pair (undefined: no face).
/// Vertices and faces are the payload's, all of them; edges are those of all faces that are not degenerate, and appear again where more than two
/// faces meet or two run the same way.
Generator iterate(Mesh input, Iterate parameters, Stage<Table>& stage);

}  // namespace mw
