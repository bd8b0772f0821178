// Edits of materials: slots of a mesh, which faces they cover, and the values of what is in them.
#include <algorithm>

#include "core/mesh/select.h"
#include "core/parameterize/project_uv.h"
#include "core/scene/edit_entries.h"
#include "core/scene/materials.h"

namespace mw {
namespace {

constexpr double most = 1e6;
constexpr int64_t mostSlots = 4096;

template <class V>
void describeNode(V& v, std::string& node)
{
    v.object("node", node, {.title = "Node", .help = "The one whose mesh it is."});
}

template <class V>
void describePlace(V& v, std::string& node, int64_t& slot)
{
    describeNode(v, node);
    v.integer("slot", slot, {.title = "Slot", .help = "Material slot of its mesh, from 0.", .min = 0, .max = double(mostSlots - 1)});
}

std::string nameOf(const Scene& scene, const std::string& node, const char* what)
{
    return scene.node(nodeOf(scene, node)).name + ": " + what;
}

MaterialId& slotAt(MeshObject& object, int64_t slot)
{
    if (slot < 0 || slot >= int64_t(object.materials.size()))
        throw Error("there are " + std::to_string(object.materials.size()) + " material slots; there is no slot " + std::to_string(slot));
    return object.materials[size_t(slot)];
}

struct Values {
    std::string node;
    int64_t slot = 0;
    glm::dvec3 color{0.8}, emissive{0};
    double opacity = 1, metallic = 0, roughness = 0.6, cutoff = 0.5, normalScale = 1, occlusion = 1;
    Material::Alpha alpha = Material::Alpha::Opaque;
    bool doubleSided = false;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
        v.point("color", color, {.title = "Base colour", .help = "Red, green and blue of the surface, linear.", .min = 0, .max = 1});
        v.number("metallic", metallic, {.title = "Metallic", .help = "0 for plastic and stone, 1 for bare metal.", .min = 0, .max = 1});
        v.number("roughness", roughness, {.title = "Roughness", .help = "0 is a mirror, 1 is chalk.", .min = 0, .max = 1});
        v.point("emissive", emissive, {.title = "Emissive", .help = "Light it gives off, linear; above 1 glows.", .min = 0, .max = most});
        v.choice("alpha", alpha, {"opaque", "mask", "blend"},
                 {.title = "Alpha mode", .help = "Opaque; cut out where alpha is below the cutoff; or blended with what is behind."});
        v.number("opacity", opacity, {.title = "Alpha", .help = "1 covers, 0 is clear; counts unless opaque.", .min = 0, .max = 1});
        v.number("cutoff", cutoff, {.title = "Cutoff", .help = "Below it nothing is drawn.", .min = 0, .max = 1, .when = "alpha=mask"});
        v.number(
            "normal-scale", normalScale,
            {.title = "Normal scale", .help = "How strongly the normal texture bends the light.", .min = -10, .max = 10, .softMin = 0, .softMax = 2});
        v.number("occlusion", occlusion, {.title = "Occlusion", .help = "How much the occlusion texture darkens.", .min = 0, .max = 1});
        v.flag("double-sided", doubleSided, {.title = "Both sides", .help = "Draw the back of faces, too."});
    }
};

bool sameValues(const Material& a, const Material& b)
{
    return a.baseColor == b.baseColor && a.metallic == b.metallic && a.roughness == b.roughness && a.emissive == b.emissive && a.alpha == b.alpha &&
           a.alphaCutoff == b.alphaCutoff && a.normalScale == b.normalScale && a.occlusionStrength == b.occlusionStrength &&
           a.doubleSided == b.doubleSided;
}

void setValues(Scene& scene, const Values& p, EditRun&)
{
    const MaterialId id = materialAt(scene, nodeOf(scene, p.node), p.slot);
    Material m = *scene.find(id);
    m.baseColor = glm::dvec4(p.color, p.opacity);
    m.metallic = p.metallic;
    m.roughness = p.roughness;
    m.emissive = p.emissive;
    m.alpha = p.alpha;
    m.alphaCutoff = p.cutoff;
    m.normalScale = p.normalScale;
    m.occlusionStrength = p.occlusion;
    m.doubleSided = p.doubleSided;
    if (!sameValues(m, *scene.find(id))) scene.set(id, std::move(m));
}

std::string valuesName(const Scene& scene, const Values& p)
{
    return scene.find(materialAt(scene, nodeOf(scene, p.node), p.slot))->name + ": values";
}

/// Slot of each face, 0 where the mesh says nothing.
Array<int32_t> faceSlots(const Mesh& mesh)
{
    Array<int32_t> slots(mesh.faceCount(), 0);
    const Attribute* a = mesh.find(names::material, Domain::Face);
    for (size_t f = 0; a && f < std::min(slots.size(), a->size()); ++f) slots[f] = int32_t(a->at(f, 0));
    return slots;
}

Mesh withSlots(const Mesh& mesh, Array<int32_t> slots)
{
    return mesh.with(integerAttribute(std::string(names::material), Domain::Face, 1, std::move(slots)));
}

/// `faces` as in 0-99;105.
void cover(MeshObject& object, const std::string& faces, int64_t slot)
{
    Array<int32_t> slots = faceSlots(object.base);
    for (const uint32_t f : parsedElements(ElementKind::Face, faces, slots.size()).indices) slots[f] = int32_t(slot);
    object.base = withSlots(object.base, std::move(slots));
}

struct NewMaterial {
    std::string node, name = "Material", faces;
    int64_t like = -1;
    glm::dvec3 color{0.8};
    template <class V>
    void describe(V& v)
    {
        describeNode(v, node);
        v.integer("like", like,
                  {.title = "Like", .help = "Slot whose material is copied; -1 for a plain one.", .min = -1, .max = double(mostSlots - 1)});
        v.point("color", color, {.title = "Base colour", .help = "Of a plain one; linear red, green, blue.", .min = 0, .max = 1, .when = "like=-1"});
        v.text("name", name, {.title = "Name", .help = "Of the new material; a number is added where one has it already."});
        v.text("faces", faces, {.title = "Faces", .help = "Faces of the base mesh that get it, as 0-99;105; empty for none."});
    }
};

void newMaterial(Scene& scene, const NewMaterial& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    MeshObject object = meshOf(scene, node);
    if (int64_t(object.materials.size()) >= mostSlots) throw Error("the mesh has " + std::to_string(mostSlots) + " material slots; no more fit");
    Material m;
    m.baseColor = glm::dvec4(p.color, 1);
    if (p.like >= 0) m = *scene.find(materialAt(scene, node, p.like));
    m.name = freshMaterialName(scene, p.name.empty() ? "Material" : p.name);
    if (object.materials.empty() && !p.faces.empty()) object.materials.push_back({});  // the other faces stay without
    object.materials.push_back(scene.add(std::move(m)));
    if (!p.faces.empty()) cover(object, p.faces, int64_t(object.materials.size()) - 1);
    scene.set(scene.node(node).mesh, std::move(object));
}

std::string newName(const Scene& scene, const NewMaterial& p)
{
    return nameOf(scene, p.node, p.like < 0 ? "new material" : "duplicate material");
}

struct UseMaterial {
    std::string node, material;
    int64_t slot = 0;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
        v.text("material", material, {.title = "Material", .help = "Name of one the scene has, or #number."});
    }
};

void useMaterial(Scene& scene, const UseMaterial& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    MeshObject object = meshOf(scene, node);
    const MaterialId id = materialOf(scene, p.material);
    if (p.slot == int64_t(object.materials.size()))
        object.materials.push_back(id);
    else
        slotAt(object, p.slot) = id;
    scene.set(scene.node(node).mesh, std::move(object));
    dropUnusedPayloads(scene);
}

std::string useName(const Scene& scene, const UseMaterial& p)
{
    return nameOf(scene, p.node, "use material ") + scene.find(materialOf(scene, p.material))->name;
}

struct Slot {
    std::string node;
    int64_t slot = 0;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
    }
};

void ownMaterial(Scene& scene, const Slot& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    const MaterialId shared = materialAt(scene, node, p.slot);
    if (users(scene, shared) < 2) throw Error("\"" + scene.find(shared)->name + "\" has one user: it is its own already");
    Material copy = *scene.find(shared);
    copy.name = freshMaterialName(scene, copy.name);
    MeshObject object = meshOf(scene, node);
    object.materials[size_t(p.slot)] = scene.add(std::move(copy));
    scene.set(scene.node(node).mesh, std::move(object));
}

std::string ownName(const Scene& scene, const Slot& p)
{
    return nameOf(scene, p.node, "own copy of material");
}

void removeSlot(Scene& scene, const Slot& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    MeshObject object = meshOf(scene, node);
    slotAt(object, p.slot);
    object.materials.erase(object.materials.begin() + ptrdiff_t(p.slot));
    Array<int32_t> slots = faceSlots(object.base);
    const auto removed = int32_t(p.slot);
    for (int32_t& s : slots) s = s == removed ? 0 : s > removed ? s - 1 : s;
    object.base = withSlots(object.base, std::move(slots));
    scene.set(scene.node(node).mesh, std::move(object));
    dropUnusedPayloads(scene);
}

std::string removeName(const Scene& scene, const Slot& p)
{
    return nameOf(scene, p.node, "remove material slot");
}

struct RenameMaterial {
    std::string node, name;
    int64_t slot = 0;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
        v.text("name", name, {.title = "Name", .help = "The material's new name."});
    }
};

void renameMaterial(Scene& scene, const RenameMaterial& p, EditRun&)
{
    if (p.name.find_first_not_of(" \t\n") == std::string::npos) throw Error("a material wants a name");
    const MaterialId id = materialAt(scene, nodeOf(scene, p.node), p.slot);
    Material m = *scene.find(id);
    m.name = p.name;
    scene.set(id, std::move(m));
}

std::string renameMaterialName(const Scene& scene, const RenameMaterial& p)
{
    return scene.find(materialAt(scene, nodeOf(scene, p.node), p.slot))->name + ": rename to " + p.name;
}

struct AssignMaterial {
    std::string node, faces;
    int64_t slot = 0;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
        v.text("faces", faces, {.title = "Faces", .help = "Faces of the base mesh, as 0-99;105; empty for all."});
    }
};

void assignMaterial(Scene& scene, const AssignMaterial& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    materialAt(scene, node, p.slot);
    MeshObject object = meshOf(scene, node);
    if (p.faces.empty())
        object.base = withSlots(object.base, Array<int32_t>(object.base.faceCount(), int32_t(p.slot)));
    else
        cover(object, p.faces, p.slot);
    scene.set(scene.node(node).mesh, std::move(object));
}

std::string assignName(const Scene& scene, const AssignMaterial& p)
{
    return nameOf(scene, p.node, "assign material ") + scene.find(materialAt(scene, nodeOf(scene, p.node), p.slot))->name;
}

struct ClearTexture {
    std::string node;
    int64_t slot = 0;
    TextureKind kind = TextureKind::BaseColor;
    template <class V>
    void describe(V& v)
    {
        describePlace(v, node, slot);
        v.choice("kind", kind, textureKinds(), {.title = "Kind", .help = "What the picture says."});
    }
};

void clearTexture(Scene& scene, const ClearTexture& p, EditRun&)
{
    const MaterialId id = materialAt(scene, nodeOf(scene, p.node), p.slot);
    Material m = *scene.find(id);
    textureOf(m, p.kind) = {};
    scene.set(id, std::move(m));
    dropUnusedPayloads(scene);
}

std::string clearName(const Scene& scene, const ClearTexture& p)
{
    return scene.find(materialAt(scene, nodeOf(scene, p.node), p.slot))->name + ": clear texture";
}

struct ProjectUv {
    std::string node;
    UvProjection from = UvProjection::Box;
    template <class V>
    void describe(V& v)
    {
        describeNode(v, node);
        v.choice("from", from, {"box", "x", "y", "z"}, {.title = "From", .help = "The six sides of its bounding box, or along one axis."});
    }
};

void projectUv(Scene& scene, const ProjectUv& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    MeshObject object = meshOf(scene, node);
    if (object.base.faceCount() == 0) throw Error("\"" + scene.node(node).name + "\" has no faces to lay out");
    object.base = object.base.with(projectedCoordinates(object.base, p.from));
    scene.set(scene.node(node).mesh, std::move(object));
}

std::string projectName(const Scene& scene, const ProjectUv& p)
{
    return nameOf(scene, p.node, "project texture coordinates");
}

}  // namespace

std::vector<Edit> materialEdits()
{
    return {editEntry<Values>("material", "Material", "Sets all values of a material; those not given get their defaults.", setValues, valuesName),
            editEntry<NewMaterial>("new-material", "New material", "Adds a slot to a mesh with a material of its own.", newMaterial, newName),
            editEntry<UseMaterial>("use-material", "Use material", "Puts a material of the scene into a slot; the slot after the last one is made.",
                                   useMaterial, useName),
            editEntry<Slot>("own-material", "Make own copy", "Gives a slot a copy of a material that others use, too.", ownMaterial, ownName),
            editEntry<Slot>("remove-slot", "Remove material slot", "Takes a slot away; its faces go to the first one.", removeSlot, removeName),
            editEntry<RenameMaterial>("rename-material", "Rename material", "Gives a material another name.", renameMaterial, renameMaterialName),
            editEntry<AssignMaterial>("assign-material", "Assign material", "Covers faces with the material of a slot.", assignMaterial, assignName),
            editEntry<ProjectUv>("project-uv", "Project texture coordinates", "Gives the mesh texture coordinates by projection.", projectUv,
                                 projectName),
            editEntry<ClearTexture>("clear-texture", "Clear texture", "Takes a picture off a material.", clearTexture, clearName)};
}

}  // namespace mw
