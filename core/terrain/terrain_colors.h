// The colour of the ground by height and slope, for viewers that know nothing of layers.
#pragma once
#include "core/terrain/terrain.h"

namespace mw {

/// Linear RGB; `height` in metres, `rise` the cosine of the slope.
glm::vec3 groundColor(const Terrain& t, double height, double rise);

}  // namespace mw
