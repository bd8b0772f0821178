// Light and shading of the view as a form; no part of the scene.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeViewSection(Session& session, QWidget* parent);

}  // namespace mw
