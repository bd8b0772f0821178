// Texture coordinates of the active mesh in the plane: seams, fold-overs, distortion; selection in step with the 3D view.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeUvPanel(Session& session, QWidget* parent);

}  // namespace mw
