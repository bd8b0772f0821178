// What object parameters of operations can be set to in the window: meshes of the scene, files.
#pragma once
#include "ui/parameter_form.h"
#include "ui/session.h"

namespace mw {

/// Names of the nodes that show a mesh other than `except`, each once, in the order of the tree.
std::vector<std::string> otherMeshNames(const Scene& scene, MeshId except);
/// For the forms of operations on `mesh`. A file that is chosen comes into the scene as hidden nodes.
ObjectChoices objectChoices(Session& session, MeshId mesh, QWidget* parent);
/// The only mesh there is beside `mesh` for each object parameter of the operation; nothing when there are more, or none.
ParameterValues onlyOthers(const Scene& scene, MeshId mesh, const Operation& op);
/// True when a parameter that it cannot do without names no mesh yet.
bool wantsOther(const Operation& op, const ParameterValues& values);

}  // namespace mw
