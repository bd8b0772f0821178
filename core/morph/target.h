// Putting a morph target on a mesh.
#pragma once
#include <string>

#include "core/mesh/mesh.h"

namespace mw {

/// Adds "morph:NAME" (three numbers a vertex), under a name that the mesh has not, and "morph-normal:NAME": what smooth shading at the target differs
/// by from the normals the mesh has, or from those of its own smooth shading.
Mesh withTarget(const Mesh& mesh, const std::string& name, Array<float> displacement);
/// The mesh part of the way to its last target.
Mesh towardsTarget(const Mesh& mesh, double t);

}  // namespace mw
