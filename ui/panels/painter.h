// Painter: the brush, its falloff, the layers of the ground, and height maps in and out.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makePainterPanel(Session& session, QWidget* parent);

}  // namespace mw
