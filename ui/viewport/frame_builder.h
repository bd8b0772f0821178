// From document and view state to the frame the renderer draws: shown levels, the thing being stepped, heat maps, marks.
#pragma once
#include "ui/session.h"
#include "ui/viewport/heat_service.h"

namespace mw {

/// The mesh to show of a mesh object: a chosen level of its stack, else the last good result.
Mesh shownMesh(const Session& session, const ViewSettings& look, MeshId id);
Mesh shownMesh(const Session& session, MeshId id);  ///< in the active view; for a variant the result, to which selections belong

Frame buildFrame(const Session& session, const ViewSettings& look, HeatService& heats);

/// What the pointer is over, as a mark of the pick kind; nothing for objects.
std::optional<Mark> hoverMark(const Pick& pick, PickKind kind);

}  // namespace mw
