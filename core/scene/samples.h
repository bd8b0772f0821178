// Scenes made by the program: to try things on without a file. "sample:NAME" stands for a file wherever one is read.
#pragma once
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace mw {

/// "mannequin": a figure with a skeleton, a skin and the motions "Walk" and "Idle". Throws Error that lists the names.
Scene sampleScene(std::string_view name);
const std::vector<std::string_view>& sampleNames();

}  // namespace mw
