// Inspector: what a mesh is and what is wrong with it, as a list to work through.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeInspectorPanel(Session& session, QWidget* parent);

}  // namespace mw
