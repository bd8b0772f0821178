// A model that turns once before a camera and lights that stand still.
#pragma once
#include "render/renderer.h"

namespace mw {

/// Moves the frame's camera to where everything fits at every angle; it turns about the middle of what is there, its height above it is kept.
void frameTurntable(Frame& frame, double aspect);
/// Picture `i` of `count` of a whole turn: to the eye the model has turned to the left, and the light has stayed.
void turn(Frame& frame, const Camera& first, double firstTurn, int i, int count);

}  // namespace mw
