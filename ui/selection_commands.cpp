#include "ui/selection_commands.h"

#include <QPointer>

#include "core/mesh/same_mesh.h"
#include "ui/viewport/frame_builder.h"

namespace mw::selecting {
namespace {

constexpr size_t smallMesh = 30'000;  // faces: done in a few milliseconds

std::vector<NodeId> allNodes(const Session& s)
{
    return s.document.scene().nodes();
}

void take(Session& s, NodeId node, ElementSet found)
{
    if (!s.document.scene().find(node)) return;
    const PickKind kind = found.kind == ElementKind::Vertex ? PickKind::Vertex : found.kind == ElementKind::Edge ? PickKind::Edge : PickKind::Face;
    std::vector<NodeId> nodes = s.document.selection().nodes;
    std::erase(nodes, node);
    nodes.push_back(node);
    s.document.select({std::move(nodes), node, std::move(found)});
    if (s.view.pickKind == kind) return;
    s.view.pickKind = kind;
    s.view.touch();
}

}  // namespace

std::optional<Mesh> activeMesh(const Session& s)
{
    const Node* n = s.document.scene().find(s.document.selection().active());
    if (!n || !n->mesh) return {};
    return shownMesh(s, n->mesh);
}

ElementKind elementKind(PickKind k)
{
    return k == PickKind::Vertex ? ElementKind::Vertex : k == PickKind::Edge ? ElementKind::Edge : ElementKind::Face;
}

void run(Session& s, const QString& name, Find find)
{
    const std::optional<Mesh> mesh = activeMesh(s);
    if (!mesh) return;
    const NodeId node = s.document.selection().active();
    ElementSet had{elementKind(s.view.pickKind), {}};
    if (s.document.selection().elementsOf == node) had = s.document.selection().elements;
    if (mesh->faceCount() <= smallMesh) {
        Progress progress;
        return take(s, node, find(*mesh, had, progress));
    }
    QPointer<ViewState> alive(&s.view);
    s.jobs.start(name, [&s, alive, node, mesh = *mesh, had = std::move(had), find = std::move(find)](Progress& p) -> std::function<void()> {
        auto found = std::make_shared<ElementSet>(find(mesh, had, p));
        return [&s, alive, node, mesh, found] {
            if (!alive) return;
            const Node* n = s.document.scene().find(node);  // it may show another mesh by now
            if (n && n->mesh && sameMesh(shownMesh(s, n->mesh), mesh)) take(s, node, std::move(*found));
        };
    });
}

void all(Session& s)
{
    if (s.view.pickKind == PickKind::Object || s.view.pickKind == PickKind::Joint) return s.document.select({allNodes(s), {}, {}});
    const ElementKind kind = elementKind(s.view.pickKind);
    // Indices in a row take no time; edges have to be gathered.
    if (const auto mesh = activeMesh(s); mesh && kind != ElementKind::Edge) return take(s, s.document.selection().active(), allElements(*mesh, kind));
    run(s, "Select all edges", [](const Mesh& m, const ElementSet&, Progress&) { return allElements(m, ElementKind::Edge); });
}

void invert(Session& s)
{
    const Selection& old = s.document.selection();
    if (s.view.pickKind == PickKind::Object || s.view.pickKind == PickKind::Joint) {
        Selection next;
        for (NodeId n : allNodes(s))
            if (!old.has(n)) next.nodes.push_back(n);
        return s.document.select(next);
    }
    const ElementKind kind = elementKind(s.view.pickKind);
    const ElementSet had = old.elementsOf == old.active() && old.elements.kind == kind ? old.elements : ElementSet{kind, {}};
    if (const auto mesh = activeMesh(s); mesh && kind != ElementKind::Edge) return take(s, old.active(), inverted(*mesh, had));
    run(s, "Invert selection", [had](const Mesh& m, const ElementSet&, Progress&) { return inverted(m, had); });
}

void selectLoop(Session& s, NodeId node, uint32_t a, uint32_t b, bool add)
{
    const Node* n = s.document.scene().find(node);
    if (!n || !n->mesh) return;
    const ElementSet edge{ElementKind::Edge, {std::min(a, b), std::max(a, b)}};
    const Selection& old = s.document.selection();
    const bool keep = add && old.elementsOf == node && old.elements.kind == ElementKind::Edge;
    s.document.select({{node}, node, keep ? united(old.elements, edge) : edge});
    run(s, "Edge loop", [edge](const Mesh& m, const ElementSet& had, Progress&) { return united(had, edgeLoop(m, edge)); });
}

}  // namespace mw::selecting
