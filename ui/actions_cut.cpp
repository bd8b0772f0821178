// Cutting a mesh open from the window: along the selected edges, or to a disk. Each is a modifier and one history entry.
#include "core/mesh/select.h"
#include "ui/actions.h"
#include "ui/repair_edits.h"
#include "ui/shortcuts.h"
#include "ui/stack_edits.h"

namespace mw {
namespace {

const char* const alongTip = "Open the mesh along the selected edges, as a modifier; a single edge inside a surface opens nothing";
const char* const diskTip = "Open the mesh along as few edges as needed so that each piece can be laid flat, as a modifier";

QString whyNoCut(const Session& s, bool along)
{
    const MeshId mesh = edits::activeMesh(s.document);
    if (!mesh) return "Select a mesh first";
    const Selection& selection = s.document.selection();
    if (along && (selection.elementsOf != selection.active() || selection.elements.kind != ElementKind::Edge || selection.elements.indices.empty()))
        return "Select edges first: Select > Pick edges, then click the edges to cut along";
    return {};
}

/// Behind the level in view, to which the selection belongs.
size_t levelInView(const Session& s, MeshId mesh)
{
    const size_t all = s.document.scene().find(mesh)->stack.size();
    const auto level = s.view.shownLevel.find(mesh);
    return level == s.view.shownLevel.end() ? all : std::min(all, level->second);
}

ParameterValues cutValues(const Session& s, bool along)
{
    if (!along) return {};
    return {{"method", std::string("edges")}, {"edges", elementText(s.document.selection().elements)}};
}

void addCut(Session& s, bool along)
{
    if (!whyNoCut(s, along).isEmpty()) return;
    const NodeId node = s.document.selection().active();
    const MeshId mesh = edits::activeMesh(s.document);
    const size_t level = levelInView(s, mesh);
    const std::vector<NodeId> nodes = s.document.selection().nodes;
    const ParameterValues values = cutValues(s, along);
    s.document.select({nodes, {}, {}});  // vertices along the cut get other numbers
    edits::insertModifiers(s.document, node, level, {Modifier{{}, "cut", values}});
    s.view.shownLevel.erase(mesh);
    s.view.touch();
}

}  // namespace

void Actions::makeCut()
{
    const auto add = [this](const char* text, const char* tip, bool along) {
        auto* a = make(text, "", "", tip, [this, along] { addCut(s_, along); });
        edits::setCall(a, [this, along]() -> EditCall {
            const Document& d = s_.document;
            const std::string with = printed(operation("cut").parameters, cutValues(s_, along));
            const int64_t at = int64_t(levelInView(s_, edits::activeMesh(d)) + 1);
            return {"modify", {{"node", nodeText(d.scene(), d.selection().active())}, {"op", std::string("cut")}, {"with", with}, {"at", at}}};
        });
        return a;
    };
    cutSelection = add("Cut along selection", alongTip, true);
    cutDisk = add("Cut open to a disk", diskTip, false);
}

void Actions::refreshCut()
{
    for (const auto& [action, tip, along] : {std::tuple(cutSelection, alongTip, true), std::tuple(cutDisk, diskTip, false)}) {
        const QString whyNot = whyNoCut(s_, along);
        action->setEnabled(whyNot.isEmpty());
        action->setProperty("whyNot", whyNot.isEmpty() ? QVariant() : QVariant(whyNot));
        setTip(action, whyNot.isEmpty() ? QString(tip) : whyNot);
    }
}

}  // namespace mw
