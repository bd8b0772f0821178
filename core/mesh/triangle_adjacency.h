// The triangle-adjacency primitive: a triangle with the vertices beyond its three sides, as a geometry shader takes it. Book 2.9.
#pragma once
#include <array>
#include <optional>

#include "core/mesh/halfedge_walk.h"
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

/// Six vertices for each triangle of mesh.triangulation(), in its order:
///
///            V4               V0 V2 V4 are the triangle; V1 lies beyond V0 V2, V3 beyond V2 V4, V5 beyond V4 V0.
///     V5 ---/  \--- V3        Where there is no triangle beyond, the vertex the side starts at stands again: V1 = V0, V3 = V2, V5 = V4.
///      \   /    \   /         That cannot happen otherwise, so a repeated index marks a border.
///       V0 ----- V2
///          \   /
///           V1
Array<uint32_t> adjacencyIndices(const Mesh& mesh);

/// The same of one face, by its half-edges; beside a polygon by the triangles it is cut into. Nothing when it is no triangle or has no half-edges.
std::optional<std::array<uint32_t, 6>> adjacencyOf(const HalfedgeWalk& walk, const Mesh& mesh, uint32_t face);

struct TriangleAdjacency {
    template <class V>
    void describe(V&)
    {}
};

/// A row a triangle: column "missing" (how many of its neighbours there are not), then v0 to v5 as above. Rows are faces; where polygons had to be
/// cut they are free, and a last column "face" tells whose part each is.
Generator triangleAdjacency(Mesh input, TriangleAdjacency parameters, Stage<Table>& stage);

}  // namespace mw
