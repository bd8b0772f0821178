// Values of vertices or faces at corners, and back where all corners agree: formats differ in where they keep normals, colours and texture
// coordinates.
#pragma once
#include <optional>

#include "core/mesh/mesh.h"

namespace mw {

/// An attribute of vertices or faces as one of corners.
Attribute atCorners(const Attribute& a, const Mesh& mesh);
/// An attribute of corners as one of vertices or faces, when all corners there have the same bits. Where there is no corner, the
/// value of the mesh's first stands.
std::optional<Attribute> gatheredIfEqual(const Attribute& a, const Mesh& mesh, Domain domain);

}  // namespace mw
