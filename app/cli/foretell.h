// Told before it begins: what a run will take when it will take long.
#pragma once
#include "core/catalog/cost.h"
#include "core/scene/scene.h"

namespace mw::cli {

/// A line on standard error when an operation on a mesh is expected to take more than 10 s or 2 GB.
void foretell(const Operation& op, const Mesh& input, const ParameterValues& values);
/// The same for the modifiers of an object, all together.
void foretell(const MeshObject& object);

}  // namespace mw::cli
