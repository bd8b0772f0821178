// Selecting what lies in a part of the view.
#pragma once
#include "ui/viewport/tool.h"

namespace mw {

enum class SelectMode { Replace, Add, Remove };

ElementKind elementKind(PickKind kind);

/// Visible things of the pick kind in a region; with X-ray, hidden ones as well: vertices and joints that lie in it, edges with both ends,
/// faces by their middle, objects by any vertex. Elements are those of one node, the active one where it is among them.
void selectRegion(ToolView& view, const Region& region, SelectMode mode);

}  // namespace mw
