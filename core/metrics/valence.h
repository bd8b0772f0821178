// Query: how many edges meet at each vertex. Book 2.3.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct VertexValence {
    template <class V>
    void describe(V&)
    {}
};

/// A row a vertex: the number of its edges (degenerate faces left out, isolated vertices 0). The summary tells mean, least and greatest valence
/// of the vertices that have edges, their share that is regular (6 inside and 4 on the boundary of triangles, else 4 and 3), and the sum of all
/// valences, which is twice the number of edges.
Generator vertexValence(Mesh input, VertexValence parameters, Stage<Table>& stage);

}  // namespace mw
