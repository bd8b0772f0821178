// Edits of what there is in a scene: made, removed, copied, moved in the tree.
#include <algorithm>
#include <map>
#include <set>

#include "core/scene/edit_entries.h"

namespace mw {
namespace {

constexpr const char* whichNodes = "Which ones, joined by +.";

struct Add {
    std::string op = "icosphere", with, name;
    template <class V>
    void describe(V& v)
    {
        v.text("op", op, {.title = "Source", .help = "An operation that makes a mesh from nothing."});
        v.text("with", with, {.title = "Values", .help = "Of the source, as after --op ID: in quotes when there are several."});
        v.text("name", name, {.title = "Name", .help = "Of the new node; empty: the source's title."});
    }
};

void add(Scene& scene, const Add& p, EditRun& run)
{
    const Operation& op = operationOf(p.op, Kind::Nothing, Kind::Mesh);
    Mesh mesh = std::get<Mesh>(apply(op, {}, parsed(op.parameters, p.with), run.progress));
    Node node;
    node.name = freeName(scene, p.name.empty() ? op.title : p.name);
    node.mesh = scene.add(MeshObject{node.name, std::move(mesh), {}, {}});
    run.made = {scene.add(std::move(node))};
}

std::string addName(const Scene& scene, const Add& p)
{
    return freeName(scene, p.name.empty() ? operation(p.op).title : p.name) + ": add";
}

struct Nodes {
    std::string nodes;
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = whichNodes});
    }
};

std::set<NodeId> withChildren(const Scene& scene, const std::vector<NodeId>& nodes)
{
    std::set<NodeId> all;
    std::vector<NodeId> open = nodes;
    while (!open.empty()) {
        const NodeId n = open.back();
        open.pop_back();
        if (!all.insert(n).second) continue;
        open.insert(open.end(), scene.node(n).children.begin(), scene.node(n).children.end());
    }
    return all;
}

void remove(Scene& scene, const Nodes& p, EditRun&)
{
    const std::vector<NodeId> nodes = nodesOf(scene, p.nodes);
    const std::set<NodeId> going = withChildren(scene, nodes);
    for (const NodeId user : scene.nodes()) {
        const Skin* skin = scene.find(scene.node(user).skin);
        if (!skin || going.contains(user)) continue;
        for (const NodeId j : skin->joints)
            if (going.contains(j))
                throw Error("\"" + scene.node(j).name + "\" is a joint that moves \"" + scene.node(user).name +
                            "\"; delete both, or that mesh first");
    }
    for (const NodeId n : nodes) scene.remove(n);
}

std::string removeName(const Scene& scene, const Nodes& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + ": delete";
}

struct Duplicate {
    std::string nodes;
    bool linked = false;
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = whichNodes});
        v.flag("linked", linked, {.title = "Linked", .help = "The copies show the same meshes, so that an edit changes both."});
    }
};

// Those that stand below no other of them.
std::vector<NodeId> topmost(const Scene& scene, const std::vector<NodeId>& nodes)
{
    std::vector<NodeId> out;
    for (const NodeId n : nodes) {
        bool below = false;
        for (NodeId up = scene.node(n).parent; up; up = scene.node(up).parent)
            below = below || std::find(nodes.begin(), nodes.end(), up) != nodes.end();
        if (!below) out.push_back(n);
    }
    return out;
}

// Copies of a subtree; `copies` is told what became of each node.
NodeId copied(Scene& scene, NodeId from, NodeId parent, bool linked, std::map<NodeId, NodeId>& copies)
{
    Node n = scene.node(from);
    const std::vector<NodeId> children = n.children;
    n.name = freeName(scene, n.name);
    if (const MeshObject* object = linked ? nullptr : scene.find(n.mesh)) {
        MeshObject own = *object;
        for (Modifier& m : own.stack) m.id = scene.newModifierId();
        n.mesh = scene.add(std::move(own));
    }
    if (const TerrainObject* object = linked ? nullptr : scene.find(n.terrain)) n.terrain = scene.add(TerrainObject(*object));
    const NodeId copy = scene.add(std::move(n), parent);
    copies[from] = copy;
    for (const NodeId child : children) copied(scene, child, copy, linked, copies);
    return copy;
}

// A character copied with its skeleton is moved by the copied joints, and its clips drive them, too.
void followCopies(Scene& scene, const std::map<NodeId, NodeId>& copies)
{
    std::map<SkinId, SkinId> skins;
    const auto copyOf = [&](NodeId n) {
        const auto i = copies.find(n);
        return i == copies.end() ? n : i->second;
    };
    for (const auto& [from, to] : copies) {
        Node n = scene.node(to);
        const Skin* skin = scene.find(n.skin);
        if (!skin || std::none_of(skin->joints.begin(), skin->joints.end(), [&](NodeId j) { return copies.contains(j); })) continue;
        if (!skins.contains(n.skin)) {
            Skin own = *skin;
            for (NodeId& j : own.joints) j = copyOf(j);
            own.skeleton = copyOf(own.skeleton);
            skins[n.skin] = scene.add(std::move(own));
        }
        n.skin = skins[n.skin];
        scene.set(to, std::move(n));
    }
    for (const ClipId id : scene.clips()) {
        Clip clip = *scene.find(id);
        const size_t before = clip.channels.size();
        for (size_t i = 0; i < before; ++i) {
            if (!copies.contains(clip.channels[i]->node)) continue;
            Channel c = *clip.channels[i];
            c.node = copyOf(c.node);
            clip.channels.push_back(std::make_shared<const Channel>(std::move(c)));
        }
        if (clip.channels.size() > before) scene.set(id, std::move(clip));
    }
}

void duplicate(Scene& scene, const Duplicate& p, EditRun& run)
{
    std::map<NodeId, NodeId> copies;
    for (const NodeId n : topmost(scene, nodesOf(scene, p.nodes))) run.made.push_back(copied(scene, n, scene.node(n).parent, p.linked, copies));
    followCopies(scene, copies);
}

std::string duplicateName(const Scene& scene, const Duplicate& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + (p.linked ? ": duplicate linked" : ": duplicate");
}

struct Reparent {
    std::string nodes, to;
    bool keep = true;
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = whichNodes});
        v.object("to", to, {.title = "Parent", .help = "Below which node; empty: at the top."});
        v.flag("keep", keep, {.title = "Keep place", .help = "They stay where they are in the world; otherwise where they were in their parent."});
    }
};

bool invertible(const glm::dmat4& m)
{
    const double d = glm::determinant(glm::dmat3(m));
    return std::isfinite(d) && d != 0;
}

// Below another node, at the same place in the world as far as a translation, rotation and scale can say it.
void moveBelow(Scene& scene, NodeId id, NodeId parent, bool keepPlace)
{
    if (scene.node(id).parent == parent) return;
    const glm::dmat4 world = scene.worldFromLocal(id), above = parent ? scene.worldFromLocal(parent) : glm::dmat4(1);
    scene.reparent(id, parent);
    if (!keepPlace || !invertible(above)) return;
    const Transform local = transformOf(glm::inverse(above) * world);
    Node n = scene.node(id);
    if (above == glm::dmat4(1) && n.local.matrix() == world) return;
    n.local = local;
    scene.set(id, std::move(n));
}

void reparent(Scene& scene, const Reparent& p, EditRun&)
{
    const NodeId to = p.to.empty() ? NodeId{} : nodeOf(scene, p.to);
    for (const NodeId n : nodesOf(scene, p.nodes)) moveBelow(scene, n, to, p.keep);
}

std::string reparentName(const Scene& scene, const Reparent& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + (p.to.empty() ? ": to the top" : ": below " + scene.node(nodeOf(scene, p.to)).name);
}

struct Group {
    std::string nodes, name = "Group";
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = whichNodes});
        v.text("name", name, {.title = "Name", .help = "Of the new node above them."});
    }
};

void group(Scene& scene, const Group& p, EditRun& run)
{
    const std::vector<NodeId> nodes = topmost(scene, nodesOf(scene, p.nodes));
    NodeId parent = scene.node(nodes.front()).parent;
    for (const NodeId n : nodes)
        if (scene.node(n).parent != parent) parent = {};
    Node above;
    above.name = freeName(scene, p.name);
    const NodeId id = scene.add(std::move(above), parent);
    for (const NodeId n : nodes) moveBelow(scene, n, id, true);
    run.made = {id};
}

std::string groupName(const Scene& scene, const Group& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + ": group";
}

void ownCopy(Scene& scene, const Nodes& p, EditRun&)
{
    for (const NodeId id : nodesOf(scene, p.nodes)) {
        Node n = scene.node(id);
        if (!n.mesh || scene.users(n.mesh) < 2) continue;
        MeshObject own = *scene.find(n.mesh);
        own.name = n.name;
        for (Modifier& m : own.stack) m.id = scene.newModifierId();
        n.mesh = scene.add(std::move(own));
        scene.set(id, std::move(n));
    }
}

std::string ownCopyName(const Scene& scene, const Nodes& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + ": own copy";
}

}  // namespace

std::vector<Edit> sceneEdits()
{
    return {editEntry<Add>("add", "Add", "Adds a mesh that the program makes.", add, addName, true),
            editEntry<Nodes>("delete", "Delete", "Removes nodes with what is below them.", remove, removeName),
            editEntry<Duplicate>("duplicate", "Duplicate", "Copies nodes with what is below them.", duplicate, duplicateName),
            editEntry<Nodes>("own-copy", "Own copy", "Gives nodes meshes of their own that were shared.", ownCopy, ownCopyName),
            editEntry<Group>("group", "Group", "Puts nodes below a new empty one.", group, groupName),
            editEntry<Reparent>("reparent", "Move in the tree", "Puts nodes below another one.", reparent, reparentName)};
}

}  // namespace mw
