// What runs off the window's thread, and what ran.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeJobsPanel(Session& session, QWidget* parent);

}  // namespace mw
