// What the view shows while something is stepped: the value in place of what it began as, or alone, in a lab.
#pragma once
#include "ui/session.h"

namespace mw {

/// The node that values of a lab have: none of any scene.
inline constexpr NodeId labNode{~0u};

/// True while the stepped value stands by itself and the scene is hidden.
bool isLab(const StepSession& steps);
/// The value alone. Empty while there is none.
Frame labFrame(const Session& session, const ViewSettings& look);
/// Puts the stepped value into a frame of the scene, and the marks of its step.
void markStep(const Session& session, Frame& frame);
/// Where the focus of the step is, in the world.
Bounds stepFocusBounds(const Session& session, const Frame& frame);
/// From where a lab is looked at: as its lesson says; in a plane when it all lies in one.
void lookAtLab(const Session& session, Camera& camera, double aspect);

}  // namespace mw
