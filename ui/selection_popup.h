// A little form over the view for a selection that wants a number: live while it is changed, closed by Enter, Esc or a click elsewhere.
#pragma once
#include "ui/selection_commands.h"

class QFrame;
class QWidget;

namespace mw::selecting {

using FindWith = std::function<ElementSet(const Mesh&, const ElementSet&, const ParameterValues&)>;

/// Begins from what is selected when it opens, and comes back to it on Esc.
QFrame* showPopup(Session& session, QWidget* view, const QString& title, std::vector<Parameter> parameters, FindWith find);

}  // namespace mw::selecting
