// The peers of simplification, behind plain functions: CGAL compiles slowly.
#pragma once
#include "core/mesh/mesh.h"

namespace mw::bench {

/// CGAL's Garland-Heckbert (planes, normal change bounded). `seconds`: CPU time of the collapses alone, its half-edges built before.
Mesh cgalGarlandHeckbert(const Mesh& mesh, double ratio, double& seconds);

/// Root mean square distance of `samples` points spread over each surface to the other one, the larger of both directions, as a share of the box
/// diagonal.
double rmsDistance(const Mesh& a, const Mesh& b, size_t samples = 300'000);

}  // namespace mw::bench
