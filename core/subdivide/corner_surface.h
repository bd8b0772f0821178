// Texture coordinates as a surface of their own: its vertices are the distinct values at each vertex of the mesh, so that a seam is a border there.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// What happens to texture coordinates: linear in every face, or smooth as the places are. Seams stay seams either way.
enum class Texturing { Linear, Smooth };

struct CornerSurface {
    Attribute attribute;  ///< of the corners of the mesh
    Mesh mesh;            ///< the same faces over (u, v, 0)
};

/// Of all sets of texture coordinates.
std::vector<CornerSurface> cornerSurfacesOf(const Mesh& mesh);

/// The attribute on finer corners, given the points of its surface and the point of each corner.
Attribute cornerValues(const CornerSurface& surface, const Array<glm::vec3>& points, std::span<const uint32_t> corners);

}  // namespace mw
