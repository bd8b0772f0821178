#include "ui/terrain_edits.h"

#include <QFileInfo>

#include "core/io/height_picture.h"
#include "ui/evaluation_service.h"

namespace mw::edits {
namespace {

std::filesystem::path pathOf(const QString& file)
{
    return std::filesystem::path(file.toStdU16String());
}

void addTerrain(Session& session, TerrainObject object, const QString& what)
{
    Scene next = session.document.scene();
    Node node;
    node.name = object.terrain.name;
    node.terrain = next.add(std::move(object));
    const NodeId id = next.add(std::move(node));
    session.document.commit(what.toStdString(), std::move(next), {{id}, {}, {}});
    session.view.frameNodes({id});
}

std::string nameOf(const Document& document, NodeId node)
{
    const Node* n = document.scene().find(node);
    return n ? n->name : std::string("Terrain");
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

void commitTerrain(Document& document, NodeId node, Terrain terrain, const QString& what)
{
    if (terrainOf(document, node))
        document.commit(nameOf(document, node) + ": " + what.toStdString(), withTerrain(document, node, std::move(terrain)));
}

void newTerrain(Session& session)
{
    const Operation& source = operation("diamond-square");
    newTerrain(session, source, checked(source.parameters, {{"size", int64_t(1025)}, {"seed", int64_t(7)}}));
}

void newTerrain(Session& session, const Operation& source, const ParameterValues& values)
{
    session.jobs.start("New terrain", [&session, &source, values](Progress& progress) -> std::function<void()> {
        TerrainObject object;
        object.terrain.name = "Terrain";
        object.terrain.map = std::get<HeightMap>(apply(source, {}, values, &progress));
        object.terrain.maximumHeight = 180;
        object.terrain.waterLevel = 0.16 * object.terrain.maximumHeight;
        object.sourceOperation = source.id;
        object.sourceValues = values;
        return [&session, object] { addTerrain(session, object, "Add terrain"); };
    });
}

void generate(Session& session, NodeId node, const Operation& source, const ParameterValues& values)
{
    const QString name = QString::fromStdString(source.title);
    session.jobs.start("Generate " + name, [&session, node, &source, values](Progress& progress) -> std::function<void()> {
        const HeightMap map = std::get<HeightMap>(apply(source, {}, values, &progress));
        return [&session, node, &source, values, map] {
            const TerrainObject* old = terrainOf(session.document, node);
            if (!old) return;  // deleted meanwhile
            TerrainObject object = *old;
            object.terrain.map = map;
            object.sourceOperation = source.id;
            object.sourceValues = values;
            Scene next = session.document.scene();
            next.set(next.node(node).terrain, std::move(object));
            session.document.commit(nameOf(session.document, node) + ": " + source.title, std::move(next));
        };
    });
}

void importPicture(Session& session, const QString& file, bool asNew, std::function<void(const QString&)> done)
{
    session.jobs.start(
        "Import " + QFileInfo(file).fileName(),
        [&session, file, asNew, done](Progress& progress) -> std::function<void()> {
            const HeightMap map = readHeightMap(pathOf(file), nullptr, &progress);
            return [&session, file, asNew, map, done] {
                const NodeId node = asNew ? NodeId{} : activeTerrain(session.document);
                if (const TerrainObject* old = terrainOf(session.document, node)) {
                    TerrainObject object = *old;
                    object.terrain.map = map;
                    object.terrain.name = QFileInfo(file).fileName().toStdString();
                    object.sourceOperation.clear();
                    object.sourceValues.clear();
                    Scene next = session.document.scene();
                    next.set(next.node(node).terrain, std::move(object));
                    session.document.commit(nameOf(session.document, node) + ": height map " + QFileInfo(file).fileName().toStdString(),
                                            std::move(next));
                } else {
                    TerrainObject object;
                    object.terrain.name = QFileInfo(file).completeBaseName().toStdString();
                    object.terrain.map = map;
                    addTerrain(session, std::move(object), "Add terrain " + QFileInfo(file).fileName());
                }
                done({});
            };
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
    const TerrainObject* object = terrainOf(session.document, node);
    if (!object) return;
    session.jobs.start("Terrain to mesh", [&session, node, terrain = object->terrain, triangles](Progress& progress) -> std::function<void()> {
        const Mesh mesh = terrainMesh(terrain, triangles, &progress);
        warm(mesh);
        return [&session, node, mesh] {
            const Node* ground = session.document.scene().find(node);
            if (!ground) return;
            Scene next = session.document.scene();
            Node beside;
            beside.name = ground->name + " mesh";
            beside.local = ground->local;
            beside.mesh = next.add(MeshObject{beside.name, mesh, {}, {}});
            const NodeId id = next.add(std::move(beside), ground->parent);
            Node hidden = *ground;
            hidden.visible = false;  // both at one place would flicker
            next.set(node, hidden);
            session.document.commit(nameOf(session.document, node) + ": to mesh", std::move(next), {{id}, {}, {}});
        };
    });
}

std::vector<const Operation*> heightSources()
{
    std::vector<const Operation*> out;
    for (const Operation& op : catalog())
        if (op.accepts == Kind::Nothing && op.yields == Kind::HeightMap) out.push_back(&op);
    return out;
}

}  // namespace mw::edits
