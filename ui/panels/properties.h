// Transform and material of the active node as forms.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makePropertiesPanel(Session& session, QWidget* parent);

}  // namespace mw
