// A mesh with new vertices and triangles behind the old ones.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// New vertices and corners are mixed from old ones, row by row; each new triangle takes the attributes of one old face.
struct Addition {
    Array<glm::vec3> positions;  ///< of the new vertices
    Stencils vertices;           ///< a row for each of them
    Array<uint32_t> triangles;   ///< vertices, three for each; new ones count on from the old
    Stencils corners;            ///< a row for each corner of a triangle
    Array<uint32_t> faceFrom;    ///< an old face for each triangle
};

/// What was there keeps its number and its values.
Mesh appended(const Mesh& mesh, const Addition& added);

}  // namespace mw
