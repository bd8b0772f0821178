// Edits of terrains: new ones, other maps, settings, strokes of the brush.
#include <algorithm>
#include <charconv>

#include "core/scene/edit_entries.h"
#include "core/scene/stroke_text.h"
#include "core/scene/terrain_values.h"
#include "core/terrain/brush.h"

namespace mw {
namespace {

TerrainObject terrainOf(const Scene& scene, NodeId node)
{
    const TerrainObject* object = scene.find(scene.node(node).terrain);
    if (!object) throw Error("\"" + scene.node(node).name + "\" shows no terrain; name a node that does");
    return *object;
}

struct Source {
    std::string op = "diamond-square", with;
    template <class V>
    void describe(V& v)
    {
        v.text("op", op, {.title = "Source", .help = "An operation that makes a height map from nothing."});
        v.text("with", with, {.title = "Values", .help = "Of the source, as after --op ID: in quotes when there are several."});
    }
    // The map, and how it was made.
    void put(TerrainObject& object, Progress* progress) const
    {
        const Operation& source = operationOf(op, Kind::Nothing, Kind::HeightMap);
        object.sourceValues = unlikeDefaults(source.parameters, parsed(source.parameters, with));
        object.sourceOperation = source.id;
        object.terrain.map = std::get<HeightMap>(apply(source, {}, object.sourceValues, progress));
    }
};

struct NewTerrain {
    Source source;
    std::string name = "Terrain";
    double height = 180, water = 28.8;
    template <class V>
    void describe(V& v)
    {
        source.describe(v);
        v.text("name", name, {.title = "Name", .help = "Of the new node."});
        v.number("height", height, {.title = "Maximum height", .help = "Height of white in the map.", .unit = "m", .min = 0.001, .max = 1e6});
        v.number("water", water, {.title = "Water level", .help = "What lies lower is under water.", .unit = "m", .min = -1e6, .max = 1e6});
    }
};

void newTerrain(Scene& scene, const NewTerrain& p, EditRun& run)
{
    TerrainObject object;
    p.source.put(object, run.progress);
    Node node;
    node.name = object.terrain.name = freeName(scene, p.name);
    object.terrain.maximumHeight = p.height;
    object.terrain.waterLevel = p.water;
    node.terrain = scene.add(std::move(object));
    run.made = {scene.add(std::move(node))};
}

std::string newName(const Scene& scene, const NewTerrain& p)
{
    return freeName(scene, p.name) + ": add";
}

struct Generate {
    std::string node;
    Source source;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which terrain."});
        source.describe(v);
    }
};

void generate(Scene& scene, const Generate& p, EditRun& run)
{
    const NodeId id = nodeOf(scene, p.node);
    TerrainObject object = terrainOf(scene, id);
    p.source.put(object, run.progress);
    scene.set(scene.node(id).terrain, std::move(object));
}

std::string generateName(const Scene& scene, const Generate& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": " + operation(p.source.op).title;
}

struct Settings {
    std::string node, with;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which terrain."});
        v.text("with", with,
               {.title = "Values",
                .help = "extent, maximumHeight, waterLevel, patches, nearLevel, farLevel, nearDistance, farDistance, edges, sandTo, grassTo, "
                        "snowFrom, rockSlope; others stay."});
    }
};

// Those of a terrain with some changed.
ParameterValues changedValues(const Terrain& terrain, const std::string& with)
{
    ParameterValues values = parsed(described<TerrainValues>(), with);
    values.merge(terrainValues(terrain));
    return values;
}

void setTerrain(Scene& scene, const Settings& p, EditRun&)
{
    const NodeId id = nodeOf(scene, p.node);
    TerrainObject object = terrainOf(scene, id);
    filled<TerrainValues>(changedValues(object.terrain, p.with)).put(object.terrain);
    scene.set(scene.node(id).terrain, std::move(object));
}

std::string settingsName(const Scene& scene, const Settings& p)
{
    const NodeId id = nodeOf(scene, p.node);
    const Terrain terrain = terrainOf(scene, id).terrain;
    // Against itself as default, so that a value is always told.
    std::vector<Parameter> parameters = described<TerrainValues>();
    const ParameterValues before = terrainValues(terrain);
    for (Parameter& q : parameters) q.initial = before.at(q.name);
    return scene.node(id).name + ": " + differenceText(parameters, before, changedValues(terrain, p.with));
}

struct Stroke {
    std::string node, points;
    Brush brush;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which terrain."});
        v.choice("kind", brush.kind, {"raise", "lower"}, {.title = "Kind", .help = "What the brush does."});
        v.number("radius", brush.radius, {.title = "Radius", .help = "Of the brush.", .unit = "m", .min = 0.001, .max = 1e7});
        v.number("strength", brush.strength, {.title = "Strength", .help = "At 1 a dab moves a fiftieth of the height.", .min = 0, .max = 1});
        v.number("spacing", brush.spacing, {.title = "Spacing", .help = "Between dabs, share of the radius.", .min = 0.01, .max = 100});
        v.choice("falloff", brush.falloff, {"smooth", "linear", "sphere", "constant"}, {.title = "Falloff", .help = "From the middle to the rim."});
        v.text("points", points, {.title = "Points", .help = "The way of the brush, places in the terrain's own x and z: 10/-20;12.5/-18."});
    }
};

void stroke(Scene& scene, const Stroke& p, EditRun&)
{
    const NodeId id = nodeOf(scene, p.node);
    TerrainObject object = terrainOf(scene, id);
    const std::vector<glm::dvec2> places = parsedStroke(p.points);
    if (dabsOf(places, p.brush) > 1e6) throw Error("the stroke is too long for so small a brush; make the radius larger");
    double carry = -1;
    object.terrain.map = stroked(object.terrain, p.brush, places, carry);
    object.sourceOperation.clear();  // painted: no source gives this map
    object.sourceValues.clear();
    scene.set(scene.node(id).terrain, std::move(object));
}

std::string strokeName(const Scene& scene, const Stroke& p)
{
    return scene.node(nodeOf(scene, p.node)).name + (p.brush.kind == Brush::Kind::Raise ? ": raise" : ": lower");
}

struct ToMesh {
    std::string node;
    int64_t triangles = 100'000;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which terrain; it is hidden afterwards."});
        v.integer("triangles", triangles, {.title = "Triangles", .help = "At most so many.", .min = 2, .max = 100'000'000});
    }
};

void toMesh(Scene& scene, const ToMesh& p, EditRun& run)
{
    const NodeId id = nodeOf(scene, p.node);
    const TerrainObject object = terrainOf(scene, id);
    if (object.terrain.map.empty()) throw Error("\"" + scene.node(id).name + "\" has no height map");
    Node ground = scene.node(id), beside;
    beside.name = freeName(scene, ground.name + " mesh");
    beside.local = ground.local;
    beside.mesh = scene.add(MeshObject{beside.name, terrainMesh(object.terrain, size_t(p.triangles), run.progress), {}, {}});
    run.made = {scene.add(std::move(beside), ground.parent)};
    ground.visible = false;  // both at one place would flicker
    scene.set(id, std::move(ground));
}

std::string toMeshName(const Scene& scene, const ToMesh& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": to mesh";
}

}  // namespace

std::vector<Edit> terrainEdits()
{
    return {
        editEntry<NewTerrain>("new-terrain", "New terrain", "Adds a terrain from a generator.", newTerrain, newName, true),
        editEntry<Generate>("generate-terrain", "Generate terrain", "Gives a terrain another map.", generate, generateName, true),
        editEntry<Settings>("set-terrain", "Change terrain", "Changes extent, heights or level of detail of a terrain.", setTerrain, settingsName),
        editEntry<Stroke>("stroke", "Paint", "One stroke of a brush on a terrain.", stroke, strokeName),
        editEntry<ToMesh>("terrain-mesh", "Terrain to mesh", "Puts a mesh that follows a terrain beside it.", toMesh, toMeshName, true)};
}

}  // namespace mw
