// Motion that comes in a file of its own, for a character that is there already: same skeleton, no retargeting.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace mw {

/// Adds the clips of `motion` to `scene`, driving the nodes of the same names. Only clips that fit are taken: nine in ten of the nodes they
/// drive, or of the joints here, are found, each name once, and four in five of those rest as far from their parents as in `motion`. Gives the new
/// clips.
std::vector<ClipId> adoptClips(Scene& scene, const Scene& motion);

}  // namespace mw
