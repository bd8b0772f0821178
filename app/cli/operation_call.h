// "ID[:k=v,...]" as the command line says an operation.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "app/cli/output.h"
#include "core/catalog/others.h"
#include "core/io/io.h"
#include "core/scene/evaluation.h"
#include "core/scene/scene.h"
#include "core/steps/progress.h"

namespace mw::cli {

struct OperationCall {
    const Operation* operation = nullptr;
    ParameterValues values;
};

/// Throws Error: an unknown operation with what is near, a parameter with its range.
OperationCall parseCall(std::string_view text);

/// The scene in which an input of the command line begins: a file's, or with "-" that of the source `first`. Warnings of the file go to
/// standard error; `options` say how its numbers are meant. Throws Error when a source and a file do not fit.
struct Input {
    Scene scene;
    bool project = false;     ///< the file carried MESHWRIGHT_project
    bool sourceUsed = false;  ///< `first` has run already
};
Input readInput(const std::string& in, const OperationCall& first, Progress* progress, const ImportOptions& options = {});

/// What a mesh object shows: its stack evaluated, by `evaluator` if given; `scene` has the meshes that modifiers work with. Throws Error naming
/// the modifier that could not run.
Mesh evaluated(const MeshObject& object, Progress* progress, Evaluator* evaluator = nullptr, const Scene* scene = nullptr);

/// The mesh operations in turn on one object: its mesh after them; with `project` they become modifiers of its stack instead. Throws Error
/// naming object and operation.
MeshObject processed(MeshObject object, std::span<const OperationCall> calls, Scene& scene, bool project, Working& working, const FindMesh& find);

}  // namespace mw::cli
