// Terrain: what the height map is, how large it stands in space, and its level of detail with the formula filled in.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeTerrainPanel(Session& session, QWidget* parent);

}  // namespace mw
