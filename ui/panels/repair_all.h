// "Repair all...": the modifiers that would be added, ticked, with what goes and what comes. What is shown is what they really do: a job runs
// the ticked ones on the mesh.
#pragma once
#include <QFrame>
#include <functional>

#include "ui/panels/inspection.h"
#include "ui/session.h"

namespace mw {

/// Opens below `anchor`; `chosen` is called with what is ticked.
QFrame* showRepairAll(Session& session, QWidget* anchor, std::shared_ptr<const Inspection> inspection,
                      std::function<void(const std::vector<Mending>&)> chosen);

}  // namespace mw
