// Edits of nodes: names, places, what is shown.
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/scene/edit_entries.h"

namespace mw {
namespace {

struct Rename {
    std::string node, name;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which one."});
        v.text("name", name, {.title = "Name", .help = "Its new name."});
    }
};

void rename(Scene& scene, const Rename& p, EditRun&)
{
    if (p.name.find_first_not_of(" \t\n") == std::string::npos) throw Error("a node wants a name");
    const NodeId id = nodeOf(scene, p.node);
    Node n = scene.node(id);
    n.name = p.name;
    scene.set(id, std::move(n));
}

std::string renameName(const Scene& scene, const Rename& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": rename to " + p.name;
}

struct Show {
    std::string nodes;
    bool visible = true;
    template <class V>
    void describe(V& v)
    {
        v.object("nodes", nodes, {.title = "Nodes", .help = "Which ones, joined by +."});
        v.flag("visible", visible, {.title = "Visible", .help = "Shown, with what is below them, or not."});
    }
};

void show(Scene& scene, const Show& p, EditRun&)
{
    for (const NodeId id : nodesOf(scene, p.nodes)) {
        Node n = scene.node(id);
        n.visible = p.visible;
        scene.set(id, std::move(n));
    }
}

std::string showName(const Scene& scene, const Show& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + (p.visible ? ": show" : ": hide");
}

/// The rotation is given by its Euler angles, about X, then Y, then Z.
struct Place {
    std::string node;
    glm::dvec3 position{0}, rotation{0}, scale{1};
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Which one."});
        v.point("position", position, {.title = "Position", .help = "Where the node is in its parent.", .unit = "m"});
        v.point("rotation", rotation, {.title = "Rotation", .help = "Turns about X, then Y, then Z.", .unit = "°"});
        v.point("scale", scale, {.title = "Scale", .help = "Factors along the node's own axes."});
    }
};

void place(Scene& scene, const Place& p, EditRun&)
{
    const NodeId id = nodeOf(scene, p.node);
    Node n = scene.node(id);
    n.local = {p.position, glm::dquat(glm::radians(p.rotation)), p.scale};
    scene.set(id, std::move(n));
}

std::string placeName(const Scene& scene, const Place& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": transform";
}

}  // namespace

std::vector<Edit> nodeEdits()
{
    return {editEntry<Rename>("rename", "Rename", "Gives a node another name.", rename, renameName),
            editEntry<Show>("show", "Show or hide", "Shows nodes, or hides them.", show, showName),
            editEntry<Place>("transform", "Transform", "Puts a node at a place of its parent, turned and scaled.", place, placeName)};
}

}  // namespace mw
