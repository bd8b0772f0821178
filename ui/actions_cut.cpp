// Cutting a mesh open from the window: along the selected edges, or to a disk. Each is a modifier and one history entry.
#include "core/mesh/select.h"
#include "ui/actions.h"
#include "ui/cut_edits.h"
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

ParameterValues cutValues(const Session& s, bool along)
{
    if (!along) return {};
    return {{"method", std::string("edges")}, {"edges", elementText(s.document.selection().elements)}};
}

}  // namespace

void Actions::makeCut()
{
    const auto add = [this](const char* text, const char* tip, bool along) {
        auto* a = make(text, "", "", tip, [this, along] {
            if (whyNoCut(s_, along).isEmpty()) edits::addCut(s_, s_.document.selection().active(), cutValues(s_, along));
        });
        edits::setCall(a, [this, along]() -> EditCall {
            const Document& d = s_.document;
            const std::string with = printed(operation("cut").parameters, cutValues(s_, along));
            const int64_t at = int64_t(edits::levelInView(s_, edits::activeMesh(d)) + 1);
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
