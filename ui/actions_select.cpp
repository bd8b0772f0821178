// What is selected, what is picked, what is shown.
#include <QActionGroup>
#include <QWidget>
#include <algorithm>
#include <set>

#include "ui/actions.h"
#include "ui/stack_edits.h"
#include "ui/viewport/frame_builder.h"

namespace mw {
namespace {

std::vector<NodeId> allNodes(const Session& s)
{
    return s.document.scene().nodes();
}

// The elements of the active mesh: all of the pick kind.
void selectAllElements(Session& s, bool invert)
{
    const PickKind kind = s.view.pickKind;
    const Selection old = s.document.selection();
    if (kind == PickKind::Object) {
        Selection next;
        for (NodeId n : allNodes(s))
            if (!invert || !old.has(n)) next.nodes.push_back(n);
        return s.document.select(next);
    }
    const Node* n = s.document.scene().find(old.active());
    if (!n || !n->mesh) return;
    const Mesh mesh = shownMesh(s, n->mesh);
    ElementSet set{kind == PickKind::Vertex ? ElementKind::Vertex : kind == PickKind::Edge ? ElementKind::Edge : ElementKind::Face, {}};
    const bool edges = set.kind == ElementKind::Edge;
    const size_t count = edges ? mesh.edges().size() / 2 : set.kind == ElementKind::Vertex ? mesh.vertexCount() : mesh.faceCount();
    std::set<std::pair<uint32_t, uint32_t>> had;
    if (invert && old.elements.kind == set.kind)
        for (size_t i = 0; i < old.elements.indices.size(); i += edges ? 2 : 1)
            had.insert({old.elements.indices[i], edges ? old.elements.indices[i + 1] : 0});
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t a = edges ? mesh.edges()[2 * i] : i, b = edges ? mesh.edges()[2 * i + 1] : 0;
        if (had.count({a, b})) continue;
        set.indices.push_back(a);
        if (edges) set.indices.push_back(b);
    }
    s.document.select({old.nodes, old.active(), std::move(set)});
}

}  // namespace

void Actions::makeSelect()
{
    Session& s = s_;
    selectAll = make(
        "All", "", "A", "Select everything of the kind that is picked", [&s] { selectAllElements(s, false); }, true);
    selectNone = make("None", "", "Ctrl+Shift+A", "Select nothing", [&s] { s.document.select({}); });
    invert = make("Invert", "", "Ctrl+I", "Select what is not selected", [&s] { selectAllElements(s, true); });
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
}

}  // namespace mw
