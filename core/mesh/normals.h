// Normals from positions alone, on flat arrays.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// Unit normal of every face, by Newell's formula for polygons; 0 where there is no area.
Array<glm::vec3> faceNormalsOf(const Mesh& mesh);
/// Unit normal of every vertex: the mean of its faces' normals weighted by area (2.6); 0 where there is none.
Array<glm::vec3> vertexNormalsOf(const Mesh& mesh);
/// Twice the area times the unit normal of face f, in double: the sum of the triangles (p0, pi, pi+1).
glm::dvec3 areaVector(const Mesh& mesh, size_t f);

}  // namespace mw
