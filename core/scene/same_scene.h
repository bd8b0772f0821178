// Whether an edit has changed anything.
#pragma once
#include "core/scene/scene.h"

namespace mw {

/// Nodes and settings are compared, arrays by their addresses: quick on large scenes, and never true for scenes that differ.
bool sameScene(const Scene& a, const Scene& b);

}  // namespace mw
