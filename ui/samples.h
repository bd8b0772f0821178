// Scenes the program makes itself: the welcome scene and a few to try things on.
#pragma once
#include <vector>

#include "core/scene/scene.h"

namespace mw {

struct Sample {
    const char* id;
    const char* title;
    const char* about;  ///< one line
    Scene (*make)();
};
/// The first one is the welcome scene.
const std::vector<Sample>& samples();

}  // namespace mw
