// Further inputs of operations: what their parameters of type object stand for.
#pragma once
#include <functional>
#include <optional>

#include "core/catalog/catalog.h"

namespace mw {

/// Looks a mesh up by what such a parameter holds, as far as the caller knows meshes (nodes of a scene, files); nothing when there is none.
using FindMesh = std::function<std::optional<Mesh>(const std::string& name)>;

/// True when it has a parameter of type object.
bool needsOthers(const Operation& op);
/// The mesh a source makes: "torus", "torus:radius=2". Nothing when the text names no source of meshes; throws Error on wrong parameters.
std::optional<Mesh> meshOfSource(const std::string& text, Progress* progress = nullptr);
/// All further inputs: asks `find` first, then takes the text as a source. Throws Error naming the parameter and what it may hold.
Others othersOf(const Operation& op, const ParameterValues& values, const FindMesh& find = {}, Progress* progress = nullptr);

}  // namespace mw
