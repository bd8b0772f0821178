// The peers of simplification, behind plain functions: CGAL compiles slowly.
#pragma once
#include <vector>

#include "core/mesh/mesh.h"

namespace mw::bench {

/// CGAL's Garland-Heckbert (planes, normal change bounded). `seconds`: CPU time of the collapses alone, its half-edges built before.
Mesh cgalGarlandHeckbert(const Mesh& mesh, double ratio, double& seconds);

/// CGAL's Lindstrom-Turk cost and placement.
Mesh cgalLindstromTurk(const Mesh& mesh, double ratio, double& seconds);

/// Root mean square distance of `samples` points spread over each surface to the other one, the larger of both directions, as a share of the box
/// diagonal.
double rmsDistance(const Mesh& a, const Mesh& b, size_t samples = 300'000);

/// CGAL's tree of boxes asked for the closest point of each of these; CPU time of making the tree ready and of asking. The sum of the distances.
double cgalClosest(const Mesh& mesh, const std::vector<glm::dvec3>& points, double& makeSeconds, double& askSeconds);

}  // namespace mw::bench
