// Edits of base meshes: joined, taken apart, elements deleted. What a stack makes of a mesh has other elements, so it is applied first.
#include <algorithm>
#include <map>

#include "core/mesh/select.h"
#include "core/mesh/submesh.h"
#include "core/mesh/union_find.h"
#include "core/scene/edit_entries.h"
#include "core/scene/join_meshes.h"

namespace mw {
namespace {

constexpr size_t mostParts = 1000;

struct Join {
    std::string nodes;
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = "Which ones, joined by +. The last one takes in the others."});
    }
};

// As it is seen: after its modifiers.
Mesh seen(const Scene& scene, const MeshObject& object, EditRun& run)
{
    if (object.stack.empty()) return object.base;
    Evaluator own;
    const Evaluation e = (run.evaluator ? run.evaluator : &own)->evaluate(object, run.progress, {}, &scene);
    for (size_t i = 0; i < e.levels.size(); ++i)
        if (!e.levels[i].error.empty()) throw Error("\"" + object.name + "\", modifier " + std::to_string(i + 1) + ": " + e.levels[i].error);
    return e.result();
}

// Its children go to its parent and stay where they are.
void removeAlone(Scene& scene, NodeId id)
{
    const Node n = scene.node(id);
    for (const NodeId child : n.children) {
        scene.reparent(child, n.parent);
        Node c = scene.node(child);
        if (!(n.local == Transform{})) c.local = transformOf(n.local.matrix() * c.local.matrix());
        scene.set(child, std::move(c));
    }
    scene.remove(id);
}

void join(Scene& scene, const Join& p, EditRun& run)
{
    const std::vector<NodeId> nodes = nodesOf(scene, p.nodes);
    if (nodes.size() < 2) throw Error("two or more meshes are wanted to join");
    const NodeId active = nodes.back();
    const glm::dmat4 world = scene.worldFromLocal(active);
    const double size = glm::determinant(glm::dmat3(world));
    if (!(std::abs(size) > 0)) throw Error("\"" + scene.node(active).name + "\" has a scale of 0: nothing can be put into its space");
    std::vector<MeshPart> parts;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const NodeId id = nodes[(i + nodes.size() - 1) % nodes.size()];  // the active one first, so that its elements keep their numbers
        const MeshObject object = meshOf(scene, id);
        requireStill(scene, id, "joining");
        parts.push_back({scene.node(id).name, object.materials, id == active ? glm::dmat4(1) : glm::inverse(world) * scene.worldFromLocal(id),
                         seen(scene, object, run)});
    }
    JoinedMeshes joined = joinedMeshes(std::move(parts), false);
    MeshObject object = meshOf(scene, active);
    object.base = std::move(joined.mesh);
    object.materials = std::move(joined.materials);
    object.stack.clear();
    Node n = scene.node(active);
    n.mesh = scene.add(std::move(object));
    scene.set(active, std::move(n));
    for (const NodeId id : nodes)
        if (id != active) removeAlone(scene, id);
    run.made = {active};
}

std::string joinName(const Scene& scene, const Join& p)
{
    const auto nodes = nodesOf(scene, p.nodes);
    return scene.node(nodes.back()).name + ": join " + grouped(int64_t(nodes.size())) + " meshes";
}

// Of a base mesh that the elements are those of.
MeshObject plainMesh(const Scene& scene, NodeId id)
{
    MeshObject object = meshOf(scene, id);
    if (!object.stack.empty()) throw Error("\"" + scene.node(id).name + "\" has modifiers; apply its stack first");
    return object;
}

struct Separate {
    std::string node, faces;
    enum class By { Faces, Components, Materials } by = By::Faces;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which one; it must have no modifiers."});
        v.choice("by", by, {"faces", "components", "materials"}, {.title = "By", .help = "The faces named, connected parts, or materials."});
        v.text("faces", faces, {.title = "Faces", .help = "Numbers from 0: 0-99;105.", .when = "by=faces"});
    }
};

// For each face the number of its part; parts are numbered in order of their first face.
std::vector<uint32_t> partsOf(const Mesh& mesh, Separate::By by)
{
    std::vector<uint32_t> key(mesh.faceCount());
    if (by == Separate::By::Materials) {
        const Attribute* slots = mesh.find(names::material, Domain::Face);
        for (size_t f = 0; f < key.size(); ++f) key[f] = slots ? uint32_t(std::max(0.0, slots->at(f, 0))) : 0;
    } else {
        UnionFind sets(mesh.vertexCount());
        for (size_t f = 0; f < mesh.faceCount(); ++f)
            for (const uint32_t v : mesh.face(f)) sets.join(mesh.face(f)[0], v);
        for (size_t f = 0; f < key.size(); ++f) key[f] = mesh.face(f).empty() ? 0 : sets.root(mesh.face(f)[0]);
    }
    std::map<uint32_t, uint32_t> number;
    for (uint32_t& k : key) k = number.try_emplace(k, uint32_t(number.size())).first->second;
    return key;
}

// Slots that no face uses are left out.
MeshObject tidySlots(MeshObject object)
{
    const Attribute* slots = object.base.find(names::material, Domain::Face);
    if (!slots || object.materials.size() < 2) return object;
    std::map<int32_t, int32_t> number;
    Array<int32_t> values(object.base.faceCount());
    for (size_t f = 0; f < values.size(); ++f) number[int32_t(slots->at(f, 0))] = 0;
    std::vector<MaterialId> used;
    for (auto& [slot, at] : number) {
        at = int32_t(used.size());
        used.push_back(slot >= 0 && size_t(slot) < object.materials.size() ? object.materials[size_t(slot)] : MaterialId{});
    }
    for (size_t f = 0; f < values.size(); ++f) values[f] = number[int32_t(slots->at(f, 0))];
    object.materials = std::move(used);
    object.base = object.base.with(integerAttribute(std::string(names::material), Domain::Face, 1, std::move(values)));
    return object;
}

// A node like `like` beside it that shows a mesh of its own.
NodeId addBeside(Scene& scene, NodeId like, MeshObject object, Mesh mesh)
{
    Node n = scene.node(like);
    const NodeId parent = n.parent;
    n.name = object.name = freeName(scene, n.name);
    object.base = std::move(mesh);
    n.mesh = scene.add(tidySlots(std::move(object)));
    return scene.add(std::move(n), parent);
}

void keepOnly(Scene& scene, NodeId id, MeshObject object, Mesh mesh)
{
    object.base = std::move(mesh);
    Node n = scene.node(id);
    if (scene.users(n.mesh) == 1) return scene.set(n.mesh, tidySlots(std::move(object)));
    object.name = n.name;
    n.mesh = scene.add(tidySlots(std::move(object)));
    scene.set(id, std::move(n));
}

// Halved again and again, so that a thousand parts of a large mesh take ten passes over it. Loose lines and vertices stay with the first part.
void halve(Mesh mesh, const std::vector<uint32_t>& part, uint32_t from, uint32_t to, std::vector<Mesh>& out, Progress* progress)
{
    if (progress) progress->at(float(out.size()) / mostParts);
    if (to - from == 1) return out.push_back(std::move(mesh));
    const uint32_t middle = from + (to - from) / 2;
    std::vector<bool> upper(part.size());
    std::vector<uint32_t> low, high;
    for (size_t f = 0; f < part.size(); ++f) {
        upper[f] = part[f] >= middle;
        (upper[f] ? high : low).push_back(part[f]);
    }
    SplitMesh split = splitFaces(mesh, upper);
    mesh = {};
    halve(std::move(split.others), low, from, middle, out, progress);
    halve(std::move(split.named), high, middle, to, out, progress);
}

void separateParts(Scene& scene, NodeId id, const MeshObject& object, Separate::By by, EditRun& run)
{
    const std::vector<uint32_t> part = partsOf(object.base, by);
    const size_t parts = part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + size_t(1);
    if (parts < 2) throw Error(by == Separate::By::Materials ? "it has one material only" : "it is in one piece");
    if (parts > mostParts)
        throw Error("it has " + grouped(int64_t(parts)) + " parts, at most " + grouped(int64_t(mostParts)) +
                    " can be separated; weld it, or select what you want and separate the selection");
    std::vector<Mesh> meshes;
    halve(object.base, part, 0, uint32_t(parts), meshes, run.progress);
    run.made = {id};
    for (size_t i = 1; i < parts; ++i) run.made.push_back(addBeside(scene, id, object, std::move(meshes[i])));
    keepOnly(scene, id, object, std::move(meshes[0]));
}

void separate(Scene& scene, const Separate& p, EditRun& run)
{
    const NodeId id = nodeOf(scene, p.node);
    const MeshObject object = plainMesh(scene, id);
    if (p.by != Separate::By::Faces) return separateParts(scene, id, object, p.by, run);
    const ElementSet set = parsedElements(ElementKind::Face, p.faces, object.base.faceCount());
    if (set.indices.empty()) throw Error("no faces are named; select some");
    if (set.indices.size() == object.base.faceCount()) throw Error("these are all its faces: nothing would be left");
    std::vector<bool> named(object.base.faceCount(), false);
    for (const uint32_t f : set.indices) named[f] = true;
    SplitMesh split = splitFaces(object.base, named);
    run.made = {addBeside(scene, id, object, std::move(split.named))};
    keepOnly(scene, id, object, std::move(split.others));
}

std::string separateName(const Scene& scene, const Separate& p)
{
    const NodeId id = nodeOf(scene, p.node);
    const std::string name = scene.node(id).name + ": separate ";
    if (p.by != Separate::By::Faces) return name + (p.by == Separate::By::Components ? "by components" : "by material");
    const size_t n = parsedElements(ElementKind::Face, p.faces, meshOf(scene, id).base.faceCount()).indices.size();
    return name + grouped(int64_t(n)) + (n == 1 ? " face" : " faces");
}

struct DeleteElements {
    std::string node, elements;
    enum class Kind { Vertices, Edges, Faces } kind = Kind::Faces;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which one; it must have no modifiers."});
        v.choice("kind", kind, {"vertices", "edges", "faces"}, {.title = "Kind", .help = "Of the elements."});
        v.text("elements", elements, {.title = "Elements", .help = "Numbers from 0: 0-99;105; edges by their vertices: 3~7;3~9."});
    }
};

ElementSet elementsOf(const Mesh& mesh, const DeleteElements& p)
{
    const bool faces = p.kind == DeleteElements::Kind::Faces;
    const ElementKind kind = faces ? ElementKind::Face : p.kind == DeleteElements::Kind::Edges ? ElementKind::Edge : ElementKind::Vertex;
    return parsedElements(kind, p.elements, faces ? mesh.faceCount() : mesh.vertexCount());
}

void deleteElements(Scene& scene, const DeleteElements& p, EditRun&)
{
    const NodeId id = nodeOf(scene, p.node);
    MeshObject object = plainMesh(scene, id);
    const ElementSet set = elementsOf(object.base, p);
    if (set.indices.empty()) throw Error("no elements are named; select some");
    object.base = withoutElements(object.base, set);
    scene.set(scene.node(id).mesh, std::move(object));
}

std::string deleteName(const Scene& scene, const DeleteElements& p)
{
    const NodeId id = nodeOf(scene, p.node);
    const ElementSet set = elementsOf(meshOf(scene, id).base, p);
    const size_t n = set.kind == ElementKind::Edge ? set.indices.size() / 2 : set.indices.size();
    const char* words[][2] = {{"vertex", "vertices"}, {"edge", "edges"}, {"face", "faces"}};
    return scene.node(id).name + ": delete " + grouped(int64_t(n)) + " " + words[size_t(p.kind)][n != 1];
}

}  // namespace

std::vector<Edit> meshEdits()
{
    return {editEntry<Join>("join", "Join", "Makes several meshes one, in the space of the last named, after their modifiers.", join, joinName, true),
            editEntry<Separate>("separate", "Separate", "Takes a mesh apart into several nodes.", separate, separateName, true),
            editEntry<DeleteElements>("delete-elements", "Delete elements", "Removes faces, edges or vertices of a base mesh.", deleteElements,
                                      deleteName)};
}

}  // namespace mw
