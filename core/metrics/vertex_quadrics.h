// The matrix K of every vertex: the planes of its faces as a quadric. Book (3.6)-(3.10).
#pragma once
#include "core/metrics/fan.h"
#include "core/simplify/quadric.h"

namespace mw {

enum class PlaneWeight { Plain, Area };

/// Quadrics about a common centre: pass places as `local(place)`.
struct VertexQuadrics {
    glm::dvec3 centre{0};
    Array<Quadric> quadric;
    Array<uint32_t> planes;  ///< of each vertex: faces with an area
    glm::dvec3 local(const glm::dvec3& place) const { return place - centre; }
};
/// `measures`: faceMeasuresOf(mesh).
VertexQuadrics vertexQuadricsOf(const Mesh& mesh, const Array<FaceMeasure>& measures, PlaneWeight weight);

}  // namespace mw
