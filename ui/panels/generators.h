// Generators: sources of height maps of the catalog with their parameters; the result takes the place of the map.
#pragma once
#include "ui/session.h"

class QWidget;

namespace mw {

QWidget* makeGeneratorsPanel(Session& session, QWidget* parent);

}  // namespace mw
