// Walking through a mesh on the sphere or in the plane along an arc: point location, and what the arc meets on its way.
#pragma once
#include "core/morph/domain_mesh.h"

namespace mw {

/// Where a place lies in a mesh: at a vertex, inside an edge (`index` is a half-edge), inside a triangle.
struct Location {
    enum class Kind : uint8_t { Vertex, Edge, Triangle };
    Kind kind = Kind::Triangle;
    uint32_t index = none;
};

/// A piece of an arc and what ends it. The piece lies within a triangle, or runs along a half-edge.
struct Hop {
    enum class Met : uint8_t { Edge, Vertex, End };
    uint32_t within = none;  ///< triangle, or the half-edge it runs along
    uint32_t met = none;     ///< half-edge crossed (of the triangle left), or vertex passed
    int8_t along = 0;        ///< 1 along that half-edge, -1 against it
    Met kind = Met::End;
};

/// By looking at every triangle; throws Error when there is none.
Location located(const DomainMesh& mesh, const Direction& place);
/// Walks from u, which lies at `from`, to v along the shorter arc, and tells where v lies. All decisions are exact, also where the arc passes through
/// vertices and along edges. O(triangles passed). Throws Error when it leaves the mesh.
Location traced(const DomainMesh& mesh, const Direction& u, const Direction& v, Location from, std::vector<Hop>* hops);

}  // namespace mw
