// Edits of material slots. What a material looks like is changed elsewhere.
#include <algorithm>
#include <charconv>

#include "core/mesh/select.h"
#include "core/scene/edit_entries.h"

namespace mw {
namespace {

MaterialId materialOf(const Scene& scene, const std::string& text)
{
    if (text.starts_with('#')) {
        uint32_t value = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && scene.find(MaterialId{value})) return {value};
        throw Error("there is no material " + text);
    }
    MaterialId found;
    for (const MaterialId id : scene.materials()) {
        if (scene.find(id)->name != text) continue;
        if (found) throw Error("several materials are called \"" + text + "\"; name one by its number, #" + std::to_string(found.value));
        found = id;
    }
    if (!found) throw Error("there is no material \"" + text + "\"");
    return found;
}

// Faces named, or all, get a material; its slot is added when the mesh has none for it.
void assign(Scene& scene, NodeId node, MaterialId material, const std::string& faces)
{
    const MeshId id = scene.node(node).mesh;
    MeshObject object = meshOf(scene, node);
    const Mesh& mesh = object.base;
    if (faces.empty()) {
        object.materials = {material};
        object.base = mesh.without(names::material);
        return scene.set(id, std::move(object));
    }
    const ElementSet set = parsedElements(ElementKind::Face, faces, mesh.faceCount());
    if (object.materials.empty()) object.materials.push_back({});  // the others stay without
    auto slot = std::find(object.materials.begin(), object.materials.end(), material);
    if (slot == object.materials.end()) slot = object.materials.insert(slot, material);
    const Attribute* old = mesh.find(names::material, Domain::Face);
    Array<int32_t> values(mesh.faceCount(), 0);
    for (size_t f = 0; old && f < values.size(); ++f) values[f] = int32_t(old->at(f, 0));
    for (const uint32_t f : set.indices) values[f] = int32_t(slot - object.materials.begin());
    object.base = mesh.with(integerAttribute(std::string(names::material), Domain::Face, 1, std::move(values)));
    scene.set(id, std::move(object));
}

struct NewMaterial {
    std::string node, name = "Material", faces;
    glm::dvec3 color{0.8, 0.8, 0.8};
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Whose mesh gets it."});
        v.text("name", name, {.title = "Name", .help = "Of the material."});
        v.point("color", color, {.title = "Base colour", .help = "Linear red, green, blue.", .min = 0, .max = 1});
        v.text("faces", faces, {.title = "Faces", .help = "Which faces: 0-99;105; empty: all."});
    }
};

void newMaterial(Scene& scene, const NewMaterial& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    meshOf(scene, node);
    Material m;
    m.name = p.name;
    m.baseColor = glm::dvec4(p.color, 1);
    assign(scene, node, scene.add(std::move(m)), p.faces);
}

std::string newName(const Scene& scene, const NewMaterial& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": new material " + p.name;
}

struct AssignMaterial {
    std::string node, material, faces;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Whose mesh gets it."});
        v.object("material", material, {.title = "Material", .help = "Its name, or # and its number."});
        v.text("faces", faces, {.title = "Faces", .help = "Which faces: 0-99;105; empty: all."});
    }
};

void assignMaterial(Scene& scene, const AssignMaterial& p, EditRun&)
{
    assign(scene, nodeOf(scene, p.node), materialOf(scene, p.material), p.faces);
}

std::string assignName(const Scene& scene, const AssignMaterial& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": material " + scene.find(materialOf(scene, p.material))->name;
}

}  // namespace

std::vector<Edit> materialEdits()
{
    return {editEntry<NewMaterial>("new-material", "New material", "Makes a material and gives it to faces.", newMaterial, newName),
            editEntry<AssignMaterial>("assign-material", "Assign material", "Gives a material that is there to faces.", assignMaterial, assignName)};
}

}  // namespace mw
