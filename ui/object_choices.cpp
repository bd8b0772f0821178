#include "ui/object_choices.h"

#include <QFileDialog>
#include <QPointer>
#include <algorithm>
#include <set>

#include "core/io/io.h"
#include "ui/edit_commands.h"

namespace mw {

std::vector<std::string> otherMeshNames(const Scene& scene, MeshId except)
{
    std::vector<std::string> names;
    for (const NodeId id : scene.nodes()) {
        const Node& n = scene.node(id);
        if (!n.mesh || n.mesh == except || n.name.empty() || std::count(names.begin(), names.end(), n.name)) continue;
        names.push_back(n.name);
    }
    return names;
}

ObjectChoices objectChoices(Session& session, MeshId mesh, QWidget* parent)
{
    ObjectChoices choices;
    choices.names = [&session, mesh] { return otherMeshNames(session.document.scene(), mesh); };
    choices.file = [&session, parent = QPointer(parent)](std::function<void(const std::string&)> then) {
        QString endings;
        for (const char* e : {"glb", "gltf", "obj", "off", "ply", "stl", "fbx", "dae"})
            endings += QString(endings.isEmpty() ? "*.%1" : " *.%1").arg(e);
        const QString file = QFileDialog::getOpenFileName(parent, "Choose the other mesh", {}, "Meshes (" + endings + ")");
        if (file.isEmpty()) return;
        std::set<NodeId> before;
        for (const NodeId id : session.document.scene().nodes()) before.insert(id);
        edits::run(session, {"import", {{"file", file.toStdString()}, {"hidden", true}}}, [&session, before, then](const EditRun&) {
            const Scene& scene = session.document.scene();
            for (const NodeId id : scene.nodes())
                if (!before.contains(id) && scene.node(id).mesh) return then(scene.node(id).name);
            if (session.trouble) session.trouble("There is no mesh in that file.");
        });
    };
    return choices;
}

ParameterValues onlyOthers(const Scene& scene, MeshId mesh, const Operation& op)
{
    ParameterValues values;
    const std::vector<std::string> names = otherMeshNames(scene, mesh);
    for (const Parameter& p : op.parameters)
        if (p.type == ParameterType::Object && names.size() == 1) values[p.name] = names.front();
    return values;
}

bool wantsOther(const Operation& op, const ParameterValues& values)
{
    return std::any_of(op.parameters.begin(), op.parameters.end(),
                       [&](const Parameter& p) { return p.type == ParameterType::Object && std::get<std::string>(valueOf(p, values)).empty(); });
}

}  // namespace mw
