#include "ui/stack_edits.h"

#include <algorithm>
#include <functional>

#include "core/scene/animate_morph.h"
#include "ui/edit_commands.h"
#include "ui/evaluation_service.h"
#include "ui/object_choices.h"

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

// A node that shows a mesh, as edits name it.
std::string nodeWith(const Document& d, MeshId id)
{
    const NodeId active = d.selection().active();
    if (d.scene().find(active) && d.scene().node(active).mesh == id) return nodeText(d.scene(), active);
    for (const NodeId n : d.scene().nodes())
        if (d.scene().node(n).mesh == id) return nodeText(d.scene(), n);
    return {};
}

ParameterValues which(const Document& d, MeshId id, size_t index)
{
    return {{"node", nodeWith(d, id)}, {"modifier", int64_t(index + 1)}};
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
    if (values.empty()) values = onlyOthers(d.scene(), id, op);
    const std::string node = nodeWith(d, id);
    const EditCall modify{"modify", {{"node", node}, {"op", op.id}, {"with", printed(op.parameters, values)}}};
    // What gives a mesh something to turn into plays at once, unless a clip of the person's own does.
    if (op.id != "morph" || playsMorphs(d.scene(), nodeOf(d.scene(), node))) {
        runQuick(d, modify);
        return;
    }
    d.cancelPreview();
    commitEdits(d, editName(d.scene(), modify), {modify, {"animate-morph", {{"node", node}}}});
}

void removeModifier(Document& d, MeshId id, size_t i)
{
    runQuick(d, {"remove-modifier", which(d, id, i)});
}

void moveModifier(Document& d, MeshId id, size_t from, size_t to)
{
    const size_t n = d.scene().find(id)->stack.size();
    if (from == to || from >= n || to >= n) return;
    ParameterValues values = which(d, id, from);
    values["to"] = int64_t(to + 1);
    runQuick(d, {"move-modifier", values});
}

void duplicateModifier(Document& d, MeshId id, size_t i)
{
    runQuick(d, {"duplicate-modifier", which(d, id, i)});
}

void enableModifier(Document& d, MeshId id, size_t i, bool on)
{
    ParameterValues values = which(d, id, i);
    values["enabled"] = on;
    runQuick(d, {"enable-modifier", values});
}

void previewValues(Document& d, MeshId id, size_t i, const ParameterValues& values)
{
    d.preview(changed(d, id, [&](MeshObject& o, Scene&) { o.stack.at(i).values = values; }));
}

void commitValues(Document& d, MeshId id, size_t i, const ParameterValues& values, const QString&)
{
    const MeshObject* object = d.scene().find(id);
    const Operation* op = object && i < object->stack.size() ? findOperation(object->stack[i].operation) : nullptr;
    if (!op) return d.cancelPreview();
    ParameterValues call = which(d, id, i);
    call["with"] = printed(op->parameters, values);
    runQuick(d, {"set-modifier", call});
}

void applyStack(Session& session, MeshId id, size_t levels)
{
    Document& d = session.document;
    const MeshObject* object = d.scene().find(id);
    if (!object || levels == 0 || levels > object->stack.size()) return;
    const EditCall call{"apply-modifiers", {{"node", nodeWith(d, id)}, {"levels", int64_t(levels)}}};
    const auto e = d.evaluation(id);
    const EvaluationService* service = session.evaluations;
    const bool ready = e && e->levels.size() == object->stack.size() && service && service->idle() && !service->paused() &&
                       !service->state(id).cancelled && service->state(id).failure.isEmpty();
    if (!ready) return run(session, call);
    for (size_t i = 0; i < levels; ++i)
        if (!e->levels[i].error.empty()) return run(session, call);
    // The result is there already: at once, without a job.
    d.cancelPreview();
    const auto before = d.history()[d.historyPosition()].scene;
    commitEdited(d, call, *before,
                 changed(d, id,
                         [&](MeshObject& o, Scene&) {
                             o.base = e->at(levels);
                             o.stack.erase(o.stack.begin(), o.stack.begin() + ptrdiff_t(levels));
                         }),
                 {});
}

void removeNodes(Session& session, const std::vector<NodeId>& nodes)
{
    if (!nodes.empty()) run(session, {"delete", {{"nodes", nodeText(session.document.scene(), nodes)}}});
}

void setVisible(Document& d, const std::vector<NodeId>& nodes, bool visible)
{
    if (!nodes.empty()) runQuick(d, {"show", {{"nodes", nodeText(d.scene(), nodes)}, {"visible", visible}}});
}

void rename(Document& d, NodeId id, const QString& name)
{
    if (!name.trimmed().isEmpty()) runQuick(d, {"rename", {{"node", nodeText(d.scene(), id)}, {"name", name.trimmed().toStdString()}}});
}

}  // namespace mw::edits
