// Step player: which algorithm, its phases, what this step does in words, formula and numbers.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeStepPlayerPanel(Session& session, QWidget* parent);

/// Opens an algorithm on a node's mesh as the stack leaves it below level `level` (0: the base).
void stepThrough(Session& session, const Operation& op, NodeId node, ParameterValues values = {});
/// Algorithms with steps that the selected mesh can be given to; the node comes back in `node`.
std::vector<const Operation*> steppable(const Session& session, NodeId* node);

}  // namespace mw
