// The named edits: a click goes there.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeHistoryPanel(Session& session, QWidget* parent);

}  // namespace mw
