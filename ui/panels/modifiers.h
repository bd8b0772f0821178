// The modifier stack of the active node: add, order, change, step through.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeModifiersPanel(Session& session, QWidget* parent);

}  // namespace mw
