// What an operation is run on, out of a file: a mesh, a skeleton, a curve, a height map.
#pragma once
#include <optional>
#include <string>

#include "app/cli/operation_call.h"
#include "core/character/pose.h"

namespace mw::cli {

/// Of kind `call.operation->accepts`. "-": nothing for a source, else what the lesson of the operation is tried on. `object` names a mesh, or
/// the topmost joint of a skeleton, when there are several, `options` how a file's numbers are meant. Throws Error that lists what there is.
Value subjectOf(const std::string& in, const OperationCall& call, const std::optional<std::string>& object, Progress* progress,
                const ImportOptions& options = {});

/// A skeleton of a scene as it rests: the one with that topmost joint, or with that joint somewhere, or else the one with most joints.
Pose skeletonIn(const std::string& file, const Scene& scene, const std::optional<std::string>& root, const std::string& joint);

}  // namespace mw::cli
