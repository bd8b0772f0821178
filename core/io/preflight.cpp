#include "core/io/preflight.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace mw {
namespace {

using Severity = PreflightItem::Severity;

/// What a format has room for.
struct Holds {
    const char* name;
    bool nodes, materials, textures, skins, clips, colors, texcoords, normals, polygons, points, meshes, terrain;
};

const Holds* holdsOf(const std::string& ending)
{
    static const std::pair<const char*, Holds> all[] = {
        {".glb", {"glTF", true, true, true, true, true, true, true, true, false, true, true, false}},
        {".gltf", {"glTF", true, true, true, true, true, true, true, true, false, true, true, false}},
        {".obj", {"OBJ", false, true, true, false, false, true, true, true, true, true, true, false}},
        {".ply", {"PLY", false, false, false, false, false, true, true, true, true, true, true, false}},
        {".off", {"OFF", false, false, false, false, false, true, true, true, true, true, true, false}},
        {".stl", {"STL", false, false, false, false, false, false, false, false, false, false, true, false}},
        {".bvh", {"BVH", true, false, false, false, true, false, false, false, false, false, false, false}},
        {".png", {"a picture", false, false, false, false, false, false, false, false, false, false, false, true}},
    };
    for (const auto& [e, holds] : all)
        if (ending == e) return &holds;
    return nullptr;
}

std::string counted(size_t n, const std::string& one, const std::string& many)
{
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

class Check {
public:
    Check(const Scene& scene, const Holds& holds, const WriteOptions& options, const std::function<Mesh(MeshId)>& shown)
        : scene_(scene), holds_(holds), options_(options), shown_(shown)
    {}

    std::vector<PreflightItem> run()
    {
        for (const NodeId root : scene_.roots()) visit(root, true);
        whole();
        std::stable_sort(items_.begin(), items_.end(), [](const auto& a, const auto& b) { return a.severity < b.severity; });
        return std::move(items_);
    }

private:
    void say(Severity s, std::string node, std::string text) { items_.push_back({s, std::move(node), std::move(text)}); }
    std::string name() const { return holds_.name; }

    void visit(NodeId id, bool visible)
    {
        const Node& n = scene_.node(id);
        visible = visible && n.visible;
        if (!visible) ++hidden_;
        if (n.joint == Node::Joint::Joint) ++joints_;
        if (visible && n.mesh) mesh(n);
        if (visible && n.terrain && !n.mesh) {
            ++terrains_;
            materials_ = true;  // its layers, as colours of its mesh
        }
        for (const NodeId child : n.children) visit(child, visible);
    }

    void mesh(const Node& n)
    {
        ++meshes_;
        if (!seen_.insert(n.mesh).second) return;
        const MeshObject& object = *scene_.find(n.mesh);
        if (!holds_.meshes) return;
        const Mesh m = shown_(n.mesh);
        const auto& p = m.positions();
        const auto finite = [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
        const size_t bad = p.size() - size_t(std::count_if(p.begin(), p.end(), finite));
        if (bad) say(Severity::Error, n.name, counted(bad, "vertex has", "vertices have") + " no finite place; delete them or undo what made them");
        if (m.vertexCount() == 0) say(Severity::Warning, n.name, "is empty: nothing of it is written");
        size_t polygons = 0;
        for (size_t f = 0; f < m.faceCount(); ++f) polygons += m.face(f).size() > 3;
        if (polygons && !holds_.polygons) say(Severity::Note, n.name, counted(polygons, "polygon is", "polygons are") + " written as triangles");
        if (m.faceCount() == 0 && m.vertexCount() && !holds_.points)
            say(Severity::Warning, n.name, "has no faces: " + name() + " has no loose points");
        if (const size_t lines = m.lines().size() / 2; lines && (name() == "STL" || name() == "OFF"))
            say(Severity::Warning, n.name, counted(lines, "loose line is", "loose lines are") + " left out: " + name() + " has none");
        attributes(n, m);
        size_t on = 0;
        for (const Modifier& modifier : object.stack) on += modifier.enabled;
        if (on) say(Severity::Note, n.name, counted(on, "modifier is", "modifiers are") + " applied");
        if (!object.materials.empty()) materials_ = true;
    }

    void attributes(const Node& n, const Mesh& m)
    {
        std::string lost;
        const auto lose = [&](bool holds, const char* words) {
            if (!holds) lost += (lost.empty() ? "" : ", ") + std::string(words);
        };
        bool color = false, texcoord = false, normal = false;
        for (const Attribute& a : m.attributes()) {
            color |= a.name.starts_with("color");
            texcoord |= a.name.starts_with("texcoord");
            normal |= a.name == "normal";
        }
        const bool facets = name() == "STL" && options_.binary;  // one colour a facet
        if (color) lose(holds_.colors || facets, "colours");
        if (texcoord) lose(holds_.texcoords, "texture coordinates");
        if (normal) lose(holds_.normals, "normals");
        if (!lost.empty()) say(Severity::Warning, n.name, lost + " left out: " + name() + " has no place for them");
    }

    void whole()
    {
        if (holds_.terrain && terrains_ == 0) say(Severity::Error, {}, "There is no visible terrain to write as a height map; choose a mesh format");
        if (holds_.terrain && terrains_ > 1) say(Severity::Warning, {}, "Only the first of " + std::to_string(terrains_) + " terrains is written");
        if (holds_.meshes && meshes_ == 0 && terrains_ == 0 && !(holds_.skins && joints_))
            say(Severity::Error, {}, "There is nothing visible to write; show a node or add one");
        if (!holds_.meshes && !holds_.terrain && joints_ == 0)
            say(Severity::Error, {}, "There is no skeleton to write; " + name() + " holds nothing else");
        if (!holds_.meshes && meshes_) say(Severity::Warning, {}, counted(meshes_, "mesh is", "meshes are") + " left out: " + name() + " holds none");
        if (terrains_ && !holds_.terrain && holds_.meshes)
            say(Severity::Note, {},
                counted(terrains_, "terrain is", "terrains are") + " written as meshes of at most " + std::to_string(options_.terrainTriangles) +
                    " triangles");
        if (materials_ && !holds_.materials) say(Severity::Warning, {}, "Materials are left out: " + name() + " has none");
        if (!scene_.images().empty() && holds_.meshes && !holds_.textures)
            say(Severity::Warning, {}, counted(scene_.images().size(), "picture is", "pictures are") + " left out: " + name() + " has no textures");
        if (!scene_.skins().empty() && holds_.meshes && !holds_.skins)
            say(Severity::Warning, {},
                counted(scene_.skins().size(), "skin is", "skins are") + " left out: " + name() + " has no skeletons; meshes are written at rest");
        if (!scene_.clips().empty() && !holds_.clips)
            say(Severity::Warning, {}, counted(scene_.clips().size(), "clip is", "clips are") + " left out: " + name() + " has no motion");
        if (meshes_ > 1 && holds_.meshes && !holds_.nodes)
            say(Severity::Warning, {}, std::to_string(meshes_) + " nodes become one mesh: " + name() + " has no hierarchy");
        if (hidden_)
            say(Severity::Note, {},
                holds_.skins ? counted(hidden_, "hidden node is", "hidden nodes are") + " written without what they show"
                             : counted(hidden_, "hidden node is", "hidden nodes are") + " left out");
    }

    const Scene& scene_;
    const Holds& holds_;
    const WriteOptions& options_;
    const std::function<Mesh(MeshId)>& shown_;
    std::vector<PreflightItem> items_;
    std::set<MeshId> seen_;
    size_t meshes_ = 0, terrains_ = 0, joints_ = 0, hidden_ = 0;
    bool materials_ = false;
};

}  // namespace

std::vector<PreflightItem> preflight(const Scene& scene, const std::string& ending, const WriteOptions& options,
                                     const std::function<Mesh(MeshId)>& shown)
{
    const Holds* holds = holdsOf(ending);
    if (!holds) return {{Severity::Error, {}, "The ending \"" + ending + "\" says no format that can be written; choose one of the list"}};
    return Check(scene, *holds, options, shown).run();
}

Scene onlyNodes(const Scene& scene, const std::vector<NodeId>& nodes)
{
    std::set<NodeId> wanted, kept;
    const auto below = [&](auto&& self, NodeId id) -> void {
        wanted.insert(id);
        for (const NodeId child : scene.node(id).children) self(self, child);
    };
    for (const NodeId id : nodes)
        if (scene.find(id)) below(below, id);
    for (const NodeId id : std::set(wanted))
        if (const Skin* skin = scene.find(scene.node(id).skin))
            for (const NodeId joint : skin->joints) wanted.insert(joint);
    for (NodeId id : wanted)
        for (; id; id = scene.node(id).parent) kept.insert(id);
    Scene part = scene;
    for (const NodeId id : scene.nodes()) {
        if (!part.find(id)) continue;  // went with its parent
        if (!kept.count(id)) {
            part.remove(id);
        } else if (!wanted.count(id)) {
            Node n = part.node(id);  // it is there for the place of what is below it
            n.mesh = {};
            n.skin = {};
            n.terrain = {};
            part.set(id, std::move(n));
        }
    }
    return part;
}

ExportedAmount amountOf(const Scene& scene, const std::function<Mesh(MeshId)>& shown)
{
    ExportedAmount amount;
    amount.clips = scene.clips().size();
    const auto visit = [&](auto&& self, NodeId id) -> void {
        const Node& n = scene.node(id);
        if (!n.visible) return;
        if (n.mesh) ++amount.meshes, amount.faces += shown(n.mesh).faceCount();
        if (n.terrain && !n.mesh) ++amount.terrains;
        for (const NodeId child : n.children) self(self, child);
    };
    for (const NodeId root : scene.roots()) visit(visit, root);
    return amount;
}

}  // namespace mw
