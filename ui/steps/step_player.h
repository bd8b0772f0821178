// Step player: which algorithm, its phases, what this step does in words, formula and numbers.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeStepPlayerPanel(Session& session, QWidget* parent);

/// Opens an algorithm on what is selected, or on the example of its lesson. False when there is nothing to run it on.
bool stepThrough(Session& session, const Operation& op, ParameterValues values = {});
/// All algorithms that have steps, in menu order.
std::vector<const Operation*> steppable();

}  // namespace mw
