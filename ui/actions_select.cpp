// What is selected, what is picked, what is shown.
#include <QActionGroup>
#include <QWidget>

#include "ui/actions.h"
#include "ui/selection_commands.h"
#include "ui/stack_edits.h"

namespace mw {
namespace {

std::vector<NodeId> allNodes(const Session& s)
{
    return s.document.scene().nodes();
}

}  // namespace

void Actions::makeSelect()
{
    Session& s = s_;
    selectAll = make(
        "All", "", "A", "Select everything of the kind that is picked", [&s] { selecting::all(s); }, true);
    selectNone = make("None", "", "Ctrl+Shift+A", "Select nothing", [&s] { s.document.select({}); });
    invert = make("Invert", "", "Ctrl+I", "Select what is not selected", [&s] { selecting::invert(s); });
    hide = make(
        "Hide", "eye-off", "H", "Hide the selected nodes", [&s] { edits::setVisible(s.document, s.document.selection().nodes, false); }, true);
    hideOthers = make(
        "Hide others", "", "Shift+H", "Hide what is not selected",
        [&s] {
            std::vector<NodeId> others;
            for (NodeId n : allNodes(s))
                if (!s.document.selection().has(n) && s.document.scene().node(n).children.empty()) others.push_back(n);
            edits::setVisible(s.document, others, false);
        },
        true);
    showAll = make("Show all", "eye", "Ctrl+H", "Show every node", [&s] { edits::setVisible(s.document, allNodes(s), true); });
    auto* group = new QActionGroup(window_);
    const struct {
        const char *text, *icon, *tip;
        PickKind kind;
    } kinds[] = {{"Pick objects", "object", "Clicks pick whole objects", PickKind::Object},
                 {"Pick vertices", "vertex", "Clicks pick vertices", PickKind::Vertex},
                 {"Pick edges", "edge", "Clicks pick edges", PickKind::Edge},
                 {"Pick faces", "face", "Clicks pick faces", PickKind::Face},
                 {"Pick joints", "bone", "Clicks pick the joints of skeletons, hidden ones too", PickKind::Joint}};
    for (const auto& k : kinds) {
        auto* a = make(k.text, k.icon, QString("Ctrl+%1").arg(pickKinds.size() + 1), k.tip, [&s, kind = k.kind] {
            s.view.pickKind = kind;
            s.view.touch();
        });
        a->setCheckable(true);
        group->addAction(a);
        pickKinds << a;
    }
    makeSelectElements();
    nextPickKind = make("Next kind to pick", "", "", "Objects, vertices, edges, faces, joints, and again", [&s] {
        s.view.pickKind = PickKind((int(s.view.pickKind) + 1) % 5);
        s.view.touch();
    });
}

}  // namespace mw
