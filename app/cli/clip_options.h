// What the verbs that pose a file share: which clip, and when.
#pragma once
#include <optional>
#include <string>

#include "app/cli/arguments.h"
#include "core/scene/scene.h"

namespace mw::cli {

struct ClipOptions {
    std::optional<std::string> clip;  ///< a name, or "#INDEX"
    std::optional<double> time;       ///< seconds
    explicit operator bool() const { return clip || time; }
};
/// "--clip NAME|#INDEX" and "--time S". Throws UsageError when S is no finite number.
ClipOptions takeClipOptions(Arguments& arguments);

/// The clip that is meant, the first one when none is named. Throws Error that lists those there are.
const Clip& clipOf(const std::string& file, const Scene& scene, const ClipOptions& options);

/// Adds the clips of the file `motion` to the scene of `file`: same skeleton, joints by name (core/scene/adopt_clips.h). Throws Error when none fits.
void addMotion(Scene& scene, const std::string& file, const std::string& motion, Progress* progress);

}  // namespace mw::cli
