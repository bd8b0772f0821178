// Putting a morph target on a mesh.
#pragma once
#include <string>

#include "core/mesh/mesh.h"

namespace mw {

/// Adds "morph:NAME" (three numbers a vertex), under a name that the mesh has not, and "morph-normal:NAME": what smooth shading at the target differs
/// by from the normals the mesh has, or from those of its own smooth shading.
Mesh withTarget(const Mesh& mesh, const std::string& name, Array<float> displacement);
/// The colours of a mesh, by corner or vertex; null when it has none of 3 or 4 numbers.
const Attribute* colorOf(const Mesh& mesh);
/// Adds the colours at the last target: "morph-color:NAME", what `color` (of vertices or corners of this mesh, 3 or 4 numbers) differs by from the
/// mesh's own, which become white where it has none, and go to the corners when either lies there.
Mesh withTargetColor(const Mesh& mesh, const Attribute& color);
/// The mesh part of the way to its last target.
Mesh towardsTarget(const Mesh& mesh, double t);

}  // namespace mw
