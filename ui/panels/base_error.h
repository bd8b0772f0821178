// How far the result of the modifiers is from the base mesh: Hausdorff and root mean square, with a button that shows it as colours.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

/// Away while there is nothing to compare.
QWidget* makeBaseErrorRow(Session& session, QWidget* parent);

}  // namespace mw
