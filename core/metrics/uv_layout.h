// Texture coordinates of a mesh as a drawing: where its corners lie, where it is cut, and what is folded over.
#pragma once
#include <glm/vec2.hpp>

#include "core/mesh/mesh.h"

namespace mw {

/// The coordinates of set 0, 1, ... ("texcoord", "texcoord1"); null when the mesh has no such set.
const Attribute* textureSet(const Mesh& mesh, int64_t set);
/// How many sets there are, from 0 without a gap.
int64_t textureSets(const Mesh& mesh);

struct UvLayout {
    Array<glm::vec2> corners;      ///< of each corner, v up; a coordinate that is no finite number is 0
    Array<uint32_t> edges;         ///< two corners an edge, every edge once, or once a side where it is a seam
    Array<uint8_t> kinds;          ///< of each of these: Inside, Seam, Border
    Array<double> areas;           ///< of each face, signed: below 0 is folded over (clockwise)
    std::vector<uint32_t> folded;  ///< faces of negative area, ascending
    glm::dvec2 low{0}, high{0};    ///< box of all corners of faces
    size_t seams = 0;              ///< edges of the mesh whose sides lie apart
    enum Kind : uint8_t { Inside, Seam, Border };
};
/// Throws Error when the mesh has no such set.
UvLayout uvLayoutOf(const Mesh& mesh, int64_t set);

/// The faces that have a point of the layout in or on them (even-odd rule, so that folded and concave faces answer, too).
std::vector<uint32_t> facesAt(const Mesh& mesh, const UvLayout& layout, glm::dvec2 point);

}  // namespace mw
