#include "ui/panel.h"
#include "ui/panels/history.h"
#include "ui/panels/jobs.h"
#include "ui/panels/modifiers.h"
#include "ui/panels/outliner.h"
#include "ui/panels/properties.h"

namespace mw {

const std::vector<PanelEntry>& panels()
{
    static const std::vector<PanelEntry> all{
        {"outliner", "Outliner", "The nodes of the scene", makeOutlinerPanel},
        {"modifiers", "Modifiers", "What is done to the selected mesh, in order", makeModifiersPanel},
        {"properties", "Properties", "Transform and material of the selected node", makePropertiesPanel},
        {"history", "History", "Every edit; a click goes there", makeHistoryPanel},
        {"jobs", "Jobs", "What runs in the background", makeJobsPanel},
    };
    return all;
}

}  // namespace mw
