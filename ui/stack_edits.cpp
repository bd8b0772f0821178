#include "ui/stack_edits.h"

#include <algorithm>
#include <functional>

#include "core/scene/edit.h"

namespace mw::edits {
namespace {

Scene changed(const Document& d, MeshId id, const std::function<void(MeshObject&, Scene&)>& edit)
{
    Scene next = d.scene();
    MeshObject object = *next.find(id);
    edit(object, next);
    next.set(id, std::move(object));
    return next;
}

QString wordsOf(const Document& d, MeshId id, size_t index)
{
    return titleOf(d.scene().find(id)->stack.at(index));
}

}  // namespace

MeshId activeMesh(const Document& d)
{
    const Node* n = d.scene().find(d.selection().active());
    return n ? n->mesh : MeshId{};
}

QString titleOf(const Modifier& m)
{
    const Operation* op = findOperation(m.operation);
    return QString::fromStdString(op ? op->title : m.operation);
}

void addModifier(Document& d, MeshId id, const Operation& op, ParameterValues values)
{
    d.commit("Add " + op.title, changed(d, id, [&](MeshObject& o, Scene& s) {
                 o.stack.push_back({s.newModifierId(), op.id, std::move(values), true});
             }));
}

void removeModifier(Document& d, MeshId id, size_t i)
{
    d.commit("Remove " + wordsOf(d, id, i).toStdString(),
             changed(d, id, [&](MeshObject& o, Scene&) { o.stack.erase(o.stack.begin() + ptrdiff_t(i)); }));
}

void moveModifier(Document& d, MeshId id, size_t from, size_t to)
{
    const size_t n = d.scene().find(id)->stack.size();
    if (from == to || from >= n || to >= n) return;
    d.commit("Move " + wordsOf(d, id, from).toStdString(), changed(d, id, [&](MeshObject& o, Scene&) {
                 Modifier m = o.stack[from];
                 o.stack.erase(o.stack.begin() + ptrdiff_t(from));
                 o.stack.insert(o.stack.begin() + ptrdiff_t(to), std::move(m));
             }));
}

void duplicateModifier(Document& d, MeshId id, size_t i)
{
    d.commit("Duplicate " + wordsOf(d, id, i).toStdString(), changed(d, id, [&](MeshObject& o, Scene& s) {
                 Modifier m = o.stack[i];
                 m.id = s.newModifierId();
                 o.stack.insert(o.stack.begin() + ptrdiff_t(i) + 1, std::move(m));
             }));
}

void enableModifier(Document& d, MeshId id, size_t i, bool on)
{
    if (d.scene().find(id)->stack.at(i).enabled == on) return;
    d.commit(wordsOf(d, id, i).toStdString() + (on ? ": on" : ": off"), changed(d, id, [&](MeshObject& o, Scene&) { o.stack[i].enabled = on; }));
}

void previewValues(Document& d, MeshId id, size_t i, const ParameterValues& values)
{
    d.preview(changed(d, id, [&](MeshObject& o, Scene&) { o.stack.at(i).values = values; }));
}

void commitValues(Document& d, MeshId id, size_t i, const ParameterValues& values, const QString& what)
{
    const MeshObject* committed = d.history()[d.historyPosition()].scene->find(id);
    if (committed && i < committed->stack.size() && committed->stack[i].values == values) return d.cancelPreview();
    d.commit((wordsOf(d, id, i) + ": " + what).toStdString(), changed(d, id, [&](MeshObject& o, Scene&) { o.stack.at(i).values = values; }));
}

bool applyStack(Document& d, MeshId id, size_t levels)
{
    const auto e = d.evaluation(id);
    if (!e || e->levels.size() < levels || levels == 0) return false;
    d.commit(levels == d.scene().find(id)->stack.size() ? "Apply stack" : "Apply to here", changed(d, id, [&](MeshObject& o, Scene&) {
                 o.base = e->at(levels);
                 o.stack.erase(o.stack.begin(), o.stack.begin() + ptrdiff_t(levels));
             }));
    return true;
}

void removeNodes(Document& d, const std::vector<NodeId>& nodes)
{
    Scene next = d.scene();
    std::string name = nodes.size() == 1 ? "Delete " + next.node(nodes[0]).name : "Delete " + std::to_string(nodes.size()) + " nodes";
    for (NodeId n : nodes)
        if (next.find(n)) next.remove(n);
    if (!nodes.empty()) d.commit(std::move(name), std::move(next));
}

void setVisible(Document& d, const std::vector<NodeId>& nodes, bool visible)
{
    if (!nodes.empty()) commitEdit(d, {"show", {{"nodes", nodeText(d.scene(), nodes)}, {"visible", visible}}});
}

void rename(Document& d, NodeId id, const QString& name)
{
    if (!name.trimmed().isEmpty()) commitEdit(d, {"rename", {{"node", nodeText(d.scene(), id)}, {"name", name.trimmed().toStdString()}}});
}

}  // namespace mw::edits
