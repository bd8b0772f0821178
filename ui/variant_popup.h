// A little form over a view: which operation, with which parameters, it shows in place of the last modifier. Live while it is changed.
#pragma once
#include "ui/session.h"

class QFrame;

namespace mw {

class Viewport;

/// Null when the mesh has no modifier that runs.
QFrame* showVariantPopup(Session& session, Viewport& view, MeshId mesh);

}  // namespace mw
