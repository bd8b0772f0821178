#include "ui/edit_commands.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QVariant>
#include <algorithm>

#include "core/mesh/select.h"
#include "core/scene/command_line.h"
#include "ui/evaluation_service.h"

namespace mw::edits {
namespace {

void say(Session& session, const QString& text)
{
    if (session.trouble) session.trouble(text);
}

QString sentence(const std::string& reason)
{
    QString text = QString::fromStdString(reason);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text.endsWith('.') ? text : text + '.';
}

struct Result {
    Scene scene;
    EditRun run;
};

/// A heavy edit on its way.
struct HeavyEdit {
    Session& session;
    EditCall call;
    std::function<void(const EditRun&)> then;
    std::function<void(const QString&)> failed;
    int tries = 3;

    void refuse(const QString& text) const { failed ? failed(text) : say(session, text); }
};

void run(HeavyEdit edit);

void start(HeavyEdit edit)
{
    Document& d = edit.session.document;
    d.cancelPreview();
    const auto before = d.history()[d.historyPosition()].scene;
    const QString name = QString::fromStdString(editName(*before, edit.call));
    const auto evaluator = edit.session.evaluations ? edit.session.evaluations->evaluator() : nullptr;
    const auto work = [before, edit, name, evaluator](Progress& progress) -> std::function<void()> {
        auto result = std::make_shared<Result>();
        result->run.progress = &progress;
        result->run.evaluator = evaluator.get();
        result->scene = edited(*before, edit.call, result->run);
        for (const MeshId id : result->scene.meshes())
            if (!before->find(id) || before->find(id) != result->scene.find(id)) warm(result->scene.find(id)->base);
        return [before, edit, name, result] {
            if (commitEdited(edit.session.document, edit.call, *before, std::move(result->scene), result->run)) {
                if (edit.then) edit.then(result->run);
            } else if (edit.tries > 1) {
                HeavyEdit again = edit;
                --again.tries;
                run(std::move(again));
            } else {
                edit.refuse(name + ": not done, since the scene is being changed all the time. Run it again.");
            }
        };
    };
    edit.session.jobs.start(name, work, [edit](const QString& text) { edit.refuse(text); });
}

// The scene may no longer have what the edit names.
void run(HeavyEdit edit)
{
    try {
        start(edit);
    } catch (const Error& e) {
        edit.refuse(sentence(e.what()));
    }
}

// Also quick edits of elements, when the mesh is a large one.
bool isHeavy(const Document& d, const EditCall& call)
{
    const Edit* e = findEdit(call.id);
    if (!e || e->heavy) return e;
    const auto node = call.values.find("node");
    if (node == call.values.end() || !(call.values.contains("faces") || call.values.contains("elements"))) return false;
    try {
        const MeshObject* object = d.scene().find(d.scene().node(nodeOf(d.scene(), std::get<std::string>(node->second))).mesh);
        return object && object->base.faceCount() > 200'000;
    } catch (const Error&) {
        return false;
    }
}

std::vector<NodeId> withMesh(const Document& d)
{
    std::vector<NodeId> out;
    for (const NodeId n : d.selection().nodes)
        if (d.scene().find(n) && d.scene().node(n).mesh) out.push_back(n);
    return out;
}

bool hasElements(const Document& d, ElementKind kind)
{
    return d.selection().elements.kind == kind && !d.selection().elements.indices.empty() && d.scene().find(d.selection().elementsOf);
}

// Faces, edges or vertices are selected: Delete means them.
bool deletesElements(const Document& d)
{
    return hasElements(d, ElementKind::Face) || hasElements(d, ElementKind::Edge) || hasElements(d, ElementKind::Vertex);
}

QString whyNotElements(const Document& d, NodeId node)
{
    const Node* n = d.scene().find(node);
    const MeshObject* object = n ? d.scene().find(n->mesh) : nullptr;
    if (!object) return "Select a mesh first.";
    if (!object->stack.empty()) return "The mesh has modifiers: apply its stack first.";
    return {};
}

QString whyNotJoin(const Document& d)
{
    const std::vector<NodeId> meshes = withMesh(d);
    if (meshes.size() < 2) return "Select two or more meshes to join.";
    for (const NodeId n : meshes)
        if (d.scene().node(n).skin) return QString::fromStdString("\"" + d.scene().node(n).name + "\" is bound to a skeleton and cannot be joined.");
    return {};
}

}  // namespace

void run(Session& session, const EditCall& call, std::function<void(const EditRun&)> then, std::function<void(const QString&)> failed)
{
    if (isHeavy(session.document, call)) return run(HeavyEdit{session, call, std::move(then), std::move(failed)});
    try {
        Document& d = session.document;
        const auto before = d.history()[d.historyPosition()].scene;
        EditRun result;
        Scene next = edited(*before, call, result);
        commitEdited(d, call, *before, std::move(next), result);
        if (then) then(result);
    } catch (const Error& e) {
        session.document.cancelPreview();
        failed ? failed(sentence(e.what())) : say(session, sentence(e.what()));
    }
}

bool runQuick(Document& document, const EditCall& call)
{
    try {
        commitEdit(document, call);
        return true;
    } catch (const Error&) {
        document.cancelPreview();
        return false;
    }
}

QString whyNot(const Document& d, SelectionEdit edit)
{
    const bool any = !d.selection().nodes.empty();
    switch (edit) {
        case SelectionEdit::Delete:
            if (deletesElements(d)) return whyNotElements(d, d.selection().elementsOf);
            return any ? QString() : "Select nodes, or elements of a mesh, first.";
        case SelectionEdit::Join:
            return whyNotJoin(d);
        case SelectionEdit::SeparateFaces:
            if (!hasElements(d, ElementKind::Face)) return "Select faces first.";
            return whyNotElements(d, d.selection().elementsOf);
        case SelectionEdit::SeparateParts:
            return whyNotElements(d, d.selection().active());
        case SelectionEdit::SeparateMaterials: {
            const QString why = whyNotElements(d, d.selection().active());
            if (!why.isEmpty()) return why;
            const MeshObject* object = d.scene().find(d.scene().node(d.selection().active()).mesh);
            return object->base.find(names::material, Domain::Face) ? QString() : "The mesh has one material only.";
        }
        case SelectionEdit::OwnCopy:
            for (const NodeId n : withMesh(d))
                if (d.scene().users(d.scene().node(n).mesh) > 1) return {};
            return "No selected node shares its mesh.";
        default:
            return any ? QString() : "Select nodes first.";
    }
}

EditCall callOf(const Document& d, SelectionEdit edit, bool linked)
{
    const Selection& selection = d.selection();
    const std::string nodes = nodeText(d.scene(), selection.nodes);
    const auto active = [&] { return nodeText(d.scene(), selection.active()); };
    switch (edit) {
        case SelectionEdit::Duplicate:
            return {"duplicate", {{"nodes", nodes}, {"linked", linked}}};
        case SelectionEdit::Join:
            return {"join", {{"nodes", nodeText(d.scene(), withMesh(d))}}};
        case SelectionEdit::SeparateFaces:
            return {"separate", {{"node", nodeText(d.scene(), selection.elementsOf)}, {"faces", elementText(selection.elements)}}};
        case SelectionEdit::SeparateParts:
            return {"separate", {{"node", active()}, {"by", std::string("components")}}};
        case SelectionEdit::SeparateMaterials:
            return {"separate", {{"node", active()}, {"by", std::string("materials")}}};
        case SelectionEdit::Group:
            return {"group", {{"nodes", nodes}}};
        case SelectionEdit::OwnCopy:
            return {"own-copy", {{"nodes", nodes}}};
        case SelectionEdit::Delete:
            break;
    }
    if (!deletesElements(d)) return {"delete", {{"nodes", nodes}}};
    const ElementKind kind = selection.elements.kind;
    const std::string word = kind == ElementKind::Face ? "faces" : kind == ElementKind::Edge ? "edges" : "vertices";
    return {"delete-elements", {{"node", nodeText(d.scene(), selection.elementsOf)}, {"kind", word}, {"elements", elementText(selection.elements)}}};
}

void run(Session& session, SelectionEdit edit, bool linked)
{
    if (const QString why = whyNot(session.document, edit); !why.isEmpty()) return say(session, why);
    run(session, callOf(session.document, edit, linked));
}

namespace {

constexpr const char* callProperty = "editCall";
using MakeCall = std::function<EditCall()>;

void copy(Session& session, const std::function<std::string()>& line)
{
    try {
        const QString text = QString::fromStdString(line());
        QGuiApplication::clipboard()->setText(text);
        if (session.notice) session.notice("Copied: " + (text.size() > 160 ? text.left(159) + QChar(0x2026) : text));
    } catch (const Error& e) {
        say(session, sentence(e.what()));
    }
}

}  // namespace

void setCall(QAction* action, std::function<EditCall()> call)
{
    action->setProperty(callProperty, QVariant::fromValue(MakeCall(std::move(call))));
}

QString commandOf(const Session& session, const QAction* action)
{
    const auto call = action->property(callProperty).value<MakeCall>();
    if (!call || !action->isEnabled()) return {};
    try {
        return QString::fromStdString(callCommand(session.document, call()));
    } catch (const Error&) {
        return {};
    }
}

void copyCommand(Session& session, size_t position, Copied what)
{
    copy(session, [&] { return what == Copied::Entry ? entryCommand(session.document, position) : commandLine(session.document, position); });
}

void copyModifier(Session& session, MeshId mesh, size_t index)
{
    copy(session, [&]() -> std::string {
        const Scene& scene = session.document.scene();
        const Modifier& m = scene.find(mesh)->stack.at(index);
        for (const NodeId n : scene.nodes())
            if (scene.node(n).mesh == mesh)
                return callCommand(
                    session.document,
                    {"modify", {{"node", nodeText(scene, n)}, {"op", m.operation}, {"with", printed(operation(m.operation).parameters, m.values)}}});
        throw Error("no node shows this mesh");
    });
}

}  // namespace mw::edits
