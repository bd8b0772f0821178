#include "ui/terrain_edits.h"

#include <QFileInfo>

#include "core/catalog/entries.h"
#include "core/io/height_picture.h"
#include "core/scene/terrain_values.h"
#include "ui/edit_commands.h"

namespace mw::edits {
namespace {

std::filesystem::path pathOf(const QString& file)
{
    return std::filesystem::path(file.toStdU16String());
}

std::function<void(const EditRun&)> framing(Session& session)
{
    return [&session](const EditRun& run) { session.view.frameNodes(run.made); };
}

const std::vector<Parameter>& describedTerrain()
{
    static const std::vector<Parameter> all = described<TerrainValues>();
    return all;
}

}  // namespace

NodeId activeTerrain(const Document& document)
{
    const Scene& scene = document.scene();
    const Node* active = scene.find(document.selection().active());
    if (active && active->terrain) return document.selection().active();
    for (const NodeId id : scene.nodes())
        if (scene.node(id).terrain && scene.node(id).visible) return id;
    return {};
}

const TerrainObject* terrainOf(const Document& document, NodeId node)
{
    const Node* n = document.scene().find(node);
    return n && n->terrain ? document.scene().find(n->terrain) : nullptr;
}

Scene withTerrain(const Document& document, NodeId node, Terrain terrain)
{
    Scene next = document.scene();
    TerrainObject object = *terrainOf(document, node);
    object.terrain = std::move(terrain);
    next.set(next.node(node).terrain, std::move(object));
    return next;
}

void previewTerrain(Document& document, NodeId node, Terrain terrain)
{
    if (terrainOf(document, node)) document.preview(withTerrain(document, node, std::move(terrain)));
}

void commitTerrain(Document& document, NodeId node, Terrain terrain, const QString&)
{
    const Node* n = document.history()[document.historyPosition()].scene->find(node);
    const TerrainObject* committed = n ? document.history()[document.historyPosition()].scene->find(n->terrain) : nullptr;
    if (!committed) return;
    ParameterValues changed;
    const ParameterValues before = terrainValues(committed->terrain);
    for (const auto& [name, value] : terrainValues(terrain))
        if (before.at(name) != value) changed.emplace(name, value);
    if (changed.empty()) return document.cancelPreview();
    runQuick(document, {"set-terrain", {{"node", nodeText(document.scene(), node)}, {"with", printedAll(describedTerrain(), changed)}}});
}

void newTerrain(Session& session)
{
    run(session, {"new-terrain", {{"with", std::string("size=1025,seed=7")}}}, framing(session));
}

void newTerrain(Session& session, const Operation& source, const ParameterValues& values)
{
    run(session, {"new-terrain", {{"op", source.id}, {"with", printed(source.parameters, values)}}}, framing(session));
}

void generate(Session& session, NodeId node, const Operation& source, const ParameterValues& values)
{
    run(session,
        {"generate-terrain", {{"node", nodeText(session.document.scene(), node)}, {"op", source.id}, {"with", printed(source.parameters, values)}}});
}

void importPicture(Session& session, const QString& file, bool asNew, std::function<void(const QString&)> done)
{
    const NodeId node = asNew ? NodeId{} : activeTerrain(session.document);
    const std::string name = node ? nodeText(session.document.scene(), node) : std::string();
    run(
        session, {"terrain-picture", {{"file", pathOf(file).string()}, {"node", name}}},
        [&session, done](const EditRun& run) {
            if (!run.made.empty()) session.view.frameNodes(run.made);
            done({});
        },
        done);
}

void exportPicture(Session& session, NodeId node, const QString& file, std::function<void(const QString&)> done)
{
    const TerrainObject* object = terrainOf(session.document, node);
    if (!object) return;
    session.jobs.start(
        "Export " + QFileInfo(file).fileName(),
        [map = object->terrain.map, file, done](Progress& progress) -> std::function<void()> {
            writeHeightMap(map, pathOf(file), &progress);
            return [done] { done({}); };
        },
        done);
}

void terrainToMesh(Session& session, NodeId node, size_t triangles)
{
    if (!terrainOf(session.document, node)) return;
    run(session, {"terrain-mesh", {{"node", nodeText(session.document.scene(), node)}, {"triangles", int64_t(triangles)}}});
}

std::vector<const Operation*> heightSources()
{
    std::vector<const Operation*> out;
    for (const Operation& op : catalog())
        if (op.accepts == Kind::Nothing && op.yields == Kind::HeightMap) out.push_back(&op);
    return out;
}

}  // namespace mw::edits
