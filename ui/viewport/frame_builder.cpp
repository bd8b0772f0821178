#include "ui/viewport/frame_builder.h"

#include <limits>

#include "render/colors.h"
#include "ui/evaluation_service.h"
#include "ui/playback.h"
#include "ui/steps/step_subject.h"
#include "ui/variants.h"
#include "ui/viewport/step_frame.h"

namespace mw {
namespace {

void addSketch(const ViewState::Sketch& sketch, Frame& frame)
{
    frame.marks.insert(frame.marks.end(), sketch.marks.begin(), sketch.marks.end());
    frame.points.insert(frame.points.end(), sketch.points.begin(), sketch.points.end());
    frame.labels.insert(frame.labels.end(), sketch.labels.begin(), sketch.labels.end());
}

const Mesh& baseOf(const Session& s, const DrawObject& o)
{
    static const Mesh nothing;
    const MeshObject* object = s.document.scene().find(s.document.scene().node(o.node).mesh);
    return object ? object->base : nothing;
}

/// One range, and one legend, for all views that colour by the same: from the least low to the greatest high of what they show. What one of them
/// still computes comes in with HeatService::ready().
void shareRange(const Session& s, const ViewSettings& look, const Operation& query, HeatService& heats, Frame& frame)
{
    int alike = 0;
    bool first = true;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int v = 0; v < s.view.views(); ++v) {
        const ViewSettings& other = s.view.of(v);
        if (other.colourBy != look.colourBy) continue;
        if (alike++ == 0) first = &other == &look;
        for (const DrawObject& o : frame.objects) {
            const auto h = heats.heat(query, shownMesh(s, other, s.document.scene().node(o.node).mesh), baseOf(s, o));
            if (!h || h->table->columns[h->column].categorical) continue;
            low = std::min(low, h->low);
            high = std::max(high, h->high);
        }
    }
    if (alike < 2 || !(low <= high)) return;
    if (!first) frame.options.legend = false;
    for (DrawObject& o : frame.objects) {
        if (!o.heat || o.heat->table->columns[o.heat->column].categorical) continue;
        HeatMap h = *o.heat;
        h.low = low;
        h.high = high;
        h.shared = true;
        o.heat = std::make_shared<const HeatMap>(std::move(h));
    }
}

void markSelection(const Session& s, const ViewSettings& look, Frame& frame)
{
    const Selection& selection = s.document.selection();
    if (s.steps.isOpen()) return;  // hidden while stepping: the focus speaks
    for (DrawObject& o : frame.objects) {
        o.selected = selection.has(o.node) && s.view.pickKind == PickKind::Object && selection.elements.indices.empty();
        o.hovered = s.view.hovered == o.node && s.view.pickKind == PickKind::Object;
        o.dimmed = s.view.dimOthers;  // the marked elements are drawn over it in full
    }
    for (DrawBone& b : frame.bones) {
        b.selected = selection.has(b.node);
        b.hovered = s.view.hovered == b.node;
    }
    for (DrawTerrain& t : frame.terrains) {
        // With the brush in hand a line round the ground would only be in the way.
        t.selected = selection.has(t.node) && s.view.pickKind == PickKind::Object && s.view.tool != ToolKind::Brush;
        t.hovered = s.view.hovered == t.node && s.view.pickKind == PickKind::Object && s.view.tool != ToolKind::Brush;
    }
    if (!selection.elementsOf || selection.elements.indices.empty()) return;
    if (showsVariant(look, s.document.scene(), selection.elementsOf)) return;  // they are elements of the result
    Mark m;
    m.node = selection.elementsOf;
    m.kind = selection.elements.kind;
    m.indices = selection.elements.indices;
    m.color = glm::vec4(selectedColor, m.kind == ElementKind::Face ? 0.45f : 1.f);
    m.width = m.kind == ElementKind::Vertex ? 8.f : 2.f;
    m.through = s.view.dimOthers;  // an offender is found from behind, too
    frame.marks.push_back(std::move(m));
}

}  // namespace

Mesh shownMesh(const Session& session, const ViewSettings& look, MeshId id)
{
    const auto evaluation = session.document.evaluation(id);
    const auto level = look.shownLevel.find(id);
    if (level != look.shownLevel.end()) {
        if (level->second == 0) return session.document.scene().find(id)->base;
        if (level->second == variantLevel) return shownVariant(session, look, id);
        if (evaluation && level->second <= evaluation->levels.size()) return evaluation->at(level->second);
    }
    return session.document.shownMesh(id);
}

Mesh shownMesh(const Session& session, MeshId id)
{
    const auto level = session.view.shownLevel.find(id);
    if (level != session.view.shownLevel.end() && level->second == variantLevel) return session.document.shownMesh(id);
    return shownMesh(session, session.view, id);
}

Frame buildFrame(const Session& session, const ViewSettings& look, HeatService& heats)
{
    if (isLab(session.steps)) return labFrame(session, look);
    Frame frame = frameOf(
        session.document.scene(), [&](MeshId id) { return shownMesh(session, look, id); },
        shownPose(session, session.playback ? session.playback->pose() : ScenePose()));
    if (!look.showMeshes && !frame.bones.empty()) frame.objects.clear();
    if (!look.showBones && !session.steps.isOfCharacter() && !frame.objects.empty()) frame.bones.clear();
    frame.camera = look.camera;
    frame.options = look.options;
    const Operation* query = look.colourBy.isEmpty() ? nullptr : findOperation(look.colourBy.toStdString());
    if (query && !session.steps.isOpen()) {
        for (DrawObject& o : frame.objects) o.heat = heats.heat(*query, o.mesh, baseOf(session, o));
        if (session.view.views() > 1) shareRange(session, look, *query, heats, frame);
    }
    if (!session.steps.isOpen())
        for (DrawObject& o : frame.objects) o.mesh = heats.normals.shown(o.mesh, look.normalWeight);
    for (DrawTerrain& t : frame.terrains) t.overlay = session.view.groundOverlay;
    markSelection(session, look, frame);
    frame.marks.insert(frame.marks.end(), session.view.flashes.begin(), session.view.flashes.end());
    if (session.steps.isOpen())
        markStep(session, frame);
    else
        addSketch(session.view.sketch, frame);
    return frame;
}

std::optional<Mark> hoverMark(const Pick& pick, PickKind kind)
{
    Mark m;
    m.node = pick.node;
    m.color = glm::vec4(1);
    m.width = 1.5f;
    if (kind == PickKind::Vertex && pick.vertex != none) {
        m.kind = ElementKind::Vertex;
        m.width = 7;
        m.indices = {pick.vertex};
    } else if (kind == PickKind::Edge && pick.edge.x != none) {
        m.kind = ElementKind::Edge;
        m.indices = {pick.edge.x, pick.edge.y};
    } else if (kind == PickKind::Face && pick.face != none) {
        m.kind = ElementKind::Face;
        m.color.a = 0.3f;
        m.indices = {pick.face};
    } else {
        return std::nullopt;
    }
    return m;
}

}  // namespace mw
