#include "ui/panel.h"
#include "ui/panels/curve_lab.h"
#include "ui/panels/generators.h"
#include "ui/panels/history.h"
#include "ui/panels/inspector.h"
#include "ui/panels/jobs.h"
#include "ui/panels/lessons.h"
#include "ui/panels/modifiers.h"
#include "ui/panels/outliner.h"
#include "ui/panels/painter.h"
#include "ui/panels/properties.h"
#include "ui/panels/records.h"
#include "ui/panels/terrain.h"
#include "ui/panels/timeline.h"
#include "ui/panels/uv.h"
#include "ui/steps/plot_panel.h"
#include "ui/steps/source_panel.h"
#include "ui/steps/step_player.h"

namespace mw {

const std::vector<PanelEntry>& panels()
{
    static const std::vector<PanelEntry> all{
        {"outliner", "Outliner", "The nodes of the scene", makeOutlinerPanel},
        {"modifiers", "Modifiers", "What is done to the selected mesh, in order", makeModifiersPanel},
        {"properties", "Properties", "Transform and material of the selected node", makePropertiesPanel},
        {"inspector", "Inspector", "What a mesh is, and what to fix", makeInspectorPanel},
        {"records", "Records", "What half-edge, winged-edge and face-based structures store at the pick", makeRecordsPanel},
        {"uv", "UV", "Texture coordinates of the selected mesh, and how they stretch", makeUvPanel},
        {"history", "History", "Every edit; a click goes there", makeHistoryPanel},
        {"jobs", "Jobs", "What runs in the background", makeJobsPanel},
        {"lessons", "Lessons", "What can be learnt, by chapter", makeLessonsPanel},
        {"lesson-text", "Lesson text", "The text of the chosen lesson", makeLessonTextPanel},
        {"step-player", "Step player", "Phase, formula and numbers of the running algorithm", makeStepPlayerPanel},
        {"lab", "Lab", "Curves by subdivision of a polygon drawn by hand", makeCurveLabPanel},
        {"source", "Source", "The algorithm's own source, at the line that runs", makeSourcePanel},
        {"timeline", "Timeline", "Clips, their keys and the playhead", makeTimelinePanel},
        {"painter", "Painter", "The brush, layers of the ground, height maps in and out", makePainterPanel},
        {"terrain", "Terrain", "Size, water and level of detail of the terrain", makeTerrainPanel},
        {"generators", "Generators", "What makes height maps", makeGeneratorsPanel},
        {"plot", "Plot", "A number of the algorithm over its steps", makePlotPanel},
    };
    return all;
}

}  // namespace mw
