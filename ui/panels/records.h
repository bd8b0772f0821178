// Records: what the half-edge, winged-edge and face-based structures store at the pick, as linked tables; the nine queries; the drawing in the view.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeRecordsPanel(Session& session, QWidget* parent);

}  // namespace mw
