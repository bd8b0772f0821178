// The edit behind the repair buttons: modifiers put into a stack, as one entry of the history.
#pragma once
#include "core/scene/document.h"

namespace mw::edits {

/// After the first `level` modifiers of the node's mesh. Ids are made here.
void insertModifiers(Document& document, NodeId node, size_t level, std::vector<Modifier> modifiers);

}  // namespace mw::edits
