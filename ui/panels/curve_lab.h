// The lab's page for curves: a control polygon edited by hand, refined by any scheme, each iteration in its own colour.
#pragma once
#include <QWidget>

#include "ui/session.h"

namespace mw {

/// The polygon belongs to the page, not to the scene: Ctrl+Z within the page takes its edits back.
QWidget* makeCurveLabPanel(Session& session, QWidget* parent);

}  // namespace mw
