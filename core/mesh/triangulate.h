// Polygons cut into triangles, for drawing and for algorithms that take triangles only.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// A face of n >= 3 corners gives n-2 triangles with its own corners and orientation; one of fewer gives none. Convex faces are cut as a fan,
/// concave ones by ear clipping in the plane of their Newell normal; what crosses itself gets some cut. Time is bounded: beyond a budget of
/// tests (polygons of tens of thousands of concave corners) the rest of a face is cut as a fan.
Mesh::Triangulation triangulationOf(const Mesh& mesh);

}  // namespace mw
