// The tree of nodes: filter, eye, counts, rename, delete; selects both ways.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeOutlinerPanel(Session& session, QWidget* parent);

}  // namespace mw
