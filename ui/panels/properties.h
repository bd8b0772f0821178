// Where the selected nodes are, what the active one is made of, and the matrices that lead to it.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makePropertiesPanel(Session& session, QWidget* parent);

}  // namespace mw
