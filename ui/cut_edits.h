// Cutting what is in view: the modifier goes behind the level that is shown, to which elements picked there belong.
#pragma once
#include "core/catalog/parameters.h"
#include "ui/session.h"

namespace mw::edits {

/// How many modifiers of the mesh the active view shows; all of them for its result.
size_t levelInView(const Session& session, MeshId mesh);
/// A `cut` with these values behind that level; elements are selected no more (vertices along the cut get other numbers), the result is shown.
void addCut(Session& session, NodeId node, const ParameterValues& values);

}  // namespace mw::edits
