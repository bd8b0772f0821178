// Further meshes of operations on the command line: other=NODE, other=FILE, other=SOURCE.
#pragma once
#include "app/cli/operation_call.h"
#include "core/catalog/others.h"

namespace mw::cli {

/// Of the nodes of `scene` as they are now (it must outlive the function); then of a file, whose only mesh it is. Throws Error.
FindMesh meshesOf(const Scene& scene, Progress* progress);

/// Object parameters of `call` that name a file come to name a hidden node, which is added to the scene: so a project keeps what it works with.
void keepOthers(Scene& scene, OperationCall& call, Progress* progress);

}  // namespace mw::cli
