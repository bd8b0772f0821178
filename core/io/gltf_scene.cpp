// The scene layer of a glTF: images, materials, the node tree, which nodes are posed by what; and the way from a file to a Scene.
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <set>

#include "core/io/file.h"
#include "core/io/gltf.h"
#include "core/io/gltf_document.h"
#include "core/io/gltf_mesh.h"
#include "core/io/gltf_motion.h"
#include "core/io/picture.h"
#include "core/io/project.h"

namespace mw {

namespace {

class SceneReader {
public:
    SceneReader(GltfDocument& document, Progress* progress) : document_(document), top_(document.root()), progress_(progress) {}
    Scene read();

private:
    void listLost();
    void checkExtensions();
    ImageId image(size_t i);
    MaterialId material(size_t i);
    MeshId mesh(size_t i);
    Material::Texture texture(const JsonPlace& owner, const char* key);
    void readFactors(const JsonPlace& place, Material& m);
    Transform transform(const JsonPlace& place);
    std::vector<size_t> roots();
    void checkTree();
    void addTree();
    Node node(const JsonPlace& place);
    void readWeights(const JsonPlace& place, Node& n);
    void addMotion();
    void bindNode(size_t i, std::vector<std::optional<Skin>>& skins, std::map<size_t, SkinId>& kept);
    void warn(const char* code, std::string text) { document_.warnings().push_back({code, std::move(text), {}}); }
    void warnOnce(const char* code, std::string text)
    {
        if (told_.insert(code).second) warn(code, std::move(text));
    }

    GltfDocument& document_;
    JsonPlace top_;
    Progress* progress_;
    template <class Id, class T>
    Id keep(std::map<Id, T>& in, T value)
    {
        const Id id{next_++};
        in.emplace(id, std::move(value));
        return id;
    }
    Scene::Parts parts_;
    uint32_t next_ = 1;
    std::vector<std::optional<ImageId>> images_;
    std::vector<std::optional<MaterialId>> materials_;
    std::vector<std::optional<MeshId>> meshes_;
    std::vector<std::vector<size_t>> children_;
    std::vector<bool> hasParent_;
    // What nodes ask of a mesh, found out once: many nodes may show one.
    struct Facts {
        size_t morphTargets = 0, slots = 0;  // slots: joints it may name, none when it names none
    };
    std::map<MeshId, Facts> facts_;
    GltfNodes nodes_;
    std::set<std::string> told_;
};

Scene SceneReader::read()
{
    checkExtensions();
    images_.resize(top_.sizeOf("images"));
    materials_.resize(top_.sizeOf("materials"));
    meshes_.resize(top_.sizeOf("meshes"));
    document_.charge(top_.sizeOf("nodes") * 512 + meshes_.size() * 512 + materials_.size() * 512, "/nodes");
    checkTree();
    addTree();
    addMotion();
    listLost();
    return Scene::restored(std::move(parts_));
}

// What a glTF may have and a scene cannot hold yet is told, not dropped in silence.
void SceneReader::listLost()
{
    const auto lost = [&](const char* key, const char* code, const char* what) {
        if (const size_t n = top_.sizeOf(key)) warn(code, std::to_string(n) + " " + what);
    };
    lost("cameras", "cameras", "cameras were left out");
    const size_t unused = size_t(std::count(meshes_.begin(), meshes_.end(), std::nullopt));
    if (unused) warn("unused-meshes", std::to_string(unused) + " meshes that the scene does not show were left out");
    if (top_.sizeOf("scenes") > 1) warn("scenes", "only one of " + std::to_string(top_.sizeOf("scenes")) + " scenes was read");
}

void SceneReader::checkExtensions()
{
    static const std::set<std::string> known{"KHR_mesh_quantization", "KHR_materials_emissive_strength", "MESHWRIGHT_project"};
    static const std::set<std::string> needed{"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};
    if (const auto required = top_.find("extensionsRequired"))
        for (size_t i = 0; i < required->size(); ++i)
            if (needed.contains((*required)[i].text()))
                (*required)[i].fail("its meshes are compressed by " + (*required)[i].text() +
                                    ", which is not supported; export it without compression");
    if (const auto used = top_.find("extensionsUsed"))
        for (size_t i = 0; i < used->size() && i < 100; ++i)
            if (const std::string& name = (*used)[i].text(); !known.contains(name))
                warn("extension", "what extension " + name.substr(0, 60) + " says was left out");
}

ImageId SceneReader::image(size_t i)
{
    if (images_[i]) return *images_[i];
    images_[i] = ImageId{};
    const JsonPlace place = top_["images"][i];
    Image image;
    image.name = place.text("name");
    try {
        if (const auto view = place.index("bufferView", document_.views(), "buffer view")) {
            const auto bytes = document_.viewBytes(*view);
            document_.charge(bytes.size(), place.pointer());
            image.bytes = std::make_shared<const std::vector<uint8_t>>(bytes.begin(), bytes.end());
        } else {
            image.bytes = document_.resource(place["uri"]);
        }
        image.mimeType = pictureType(*image.bytes);
    } catch (const Error& e) {  // a mesh without its picture is of use all the same
        warn("missing-image", std::string(e.what()) + "; the mesh is shown without it");
        return {};
    }
    if (image.mimeType.empty()) {
        warn("unknown-image", place.pointer() + ": is neither PNG nor JPEG and was left out; convert the picture");
        return {};
    }
    images_[i] = keep(parts_.images, std::move(image));
    return *images_[i];
}

Material::Texture SceneReader::texture(const JsonPlace& owner, const char* key)
{
    Material::Texture t;
    const auto info = owner.find(key);
    if (!info) return t;
    const JsonPlace place = top_["textures"][(*info)["index"].index(top_.sizeOf("textures"), "texture")];
    if (const auto source = place.index("source", images_.size(), "image"))
        t.image = image(*source);
    else
        warnOnce("unknown-image", place.pointer() + ": has no PNG or JPEG picture and was left out; convert the picture");
    t.set = int(std::min<uint64_t>(info->whole("texCoord", 0), 31));
    if (const auto sampler = place.index("sampler", top_.sizeOf("samplers"), "sampler")) {
        constexpr uint64_t clamp = 33071;
        const JsonPlace s = top_["samplers"][*sampler];
        t.repeat = !(s.whole("wrapS", 0) == clamp && s.whole("wrapT", 0) == clamp);
    }
    return t;
}

void SceneReader::readFactors(const JsonPlace& place, Material& m)
{
    m.baseColor = glm::dvec4(1);
    m.metallic = m.roughness = 1;
    if (const auto pbr = place.find("pbrMetallicRoughness")) {
        pbr->numbers<4>("baseColorFactor", m.baseColor);
        m.metallic = pbr->number("metallicFactor", 1);
        m.roughness = pbr->number("roughnessFactor", 1);
        m.baseColorTexture = texture(*pbr, "baseColorTexture");
        m.metallicRoughnessTexture = texture(*pbr, "metallicRoughnessTexture");
    }
    m.normalTexture = texture(place, "normalTexture");
    m.occlusionTexture = texture(place, "occlusionTexture");
    m.emissiveTexture = texture(place, "emissiveTexture");
    if (const auto t = place.find("normalTexture")) m.normalScale = t->number("scale", 1);
    if (const auto t = place.find("occlusionTexture")) m.occlusionStrength = t->number("strength", 1);
    place.numbers<3>("emissiveFactor", m.emissive);
    if (const auto extensions = place.find("extensions"))
        if (const auto strength = extensions->find("KHR_materials_emissive_strength")) m.emissive *= strength->number("emissiveStrength", 1);
}

MaterialId SceneReader::material(size_t i)
{
    if (materials_[i]) return *materials_[i];
    const JsonPlace place = top_["materials"][i];
    Material m;
    m.name = place.text("name");
    readFactors(place, m);
    m.alphaCutoff = place.number("alphaCutoff", 0.5);
    m.doubleSided = place.flag("doubleSided", false);
    const std::string mode = place.text("alphaMode");
    m.alpha = mode == "MASK" ? Material::Alpha::Mask : mode == "BLEND" ? Material::Alpha::Blend : Material::Alpha::Opaque;
    if (const auto extras = place.find("extras")) m.extras = extras->value().dump();
    materials_[i] = keep(parts_.materials, std::move(m));
    return *materials_[i];
}

MeshId SceneReader::mesh(size_t i)
{
    if (meshes_[i]) return *meshes_[i];
    const JsonPlace place = top_["meshes"][i];
    GltfMesh read = gltfMesh(document_, place, progress_);
    MeshObject object;
    object.name = place.text("name");
    object.base = std::move(read.mesh);
    for (const auto& m : read.materials) object.materials.push_back(m ? material(*m) : MaterialId{});
    Facts facts;
    for (const Attribute& a : object.base.attributes()) {
        facts.morphTargets += a.name.starts_with(names::morph);
        if (a.name == names::joints) facts.slots = SIZE_MAX;
    }
    meshes_[i] = keep(parts_.meshes, std::move(object));
    facts_[*meshes_[i]] = facts;
    if (progress_) progress_->at(float(i + 1) / float(meshes_.size()));
    return *meshes_[i];
}

Transform SceneReader::transform(const JsonPlace& place)
{
    Transform t;
    if (place.has("matrix")) {
        double values[16];
        place.numbers<16>("matrix", values);
        bool exact = true;
        t = transformOf(glm::make_mat4(values), &exact);
        if (!exact)
            warnOnce("sheared-matrix",
                     place.pointer() + ": its matrix shears, which translation, rotation and scale cannot say; the nearest was taken");
    }
    place.numbers<3>("translation", t.translation);
    place.numbers<3>("scale", t.scale);
    double q[4] = {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
    place.numbers<4>("rotation", q);
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const bool usable = length > 1e-12 && std::isfinite(length);
    if (!usable) warnOnce("bad-rotation", place.pointer() + ": its rotation is no quaternion; none was taken");
    // One that is unit within rounding stays as it is, to the last bit.
    const double by = std::abs(length - 1) < 1e-9 ? 1 : length;
    t.rotation = usable ? glm::dquat(q[3] / by, q[0] / by, q[1] / by, q[2] / by) : glm::dquat(1, 0, 0, 0);
    return t;
}

// Every index is in range, every node has one parent at most, and no node is its own ancestor.
void SceneReader::checkTree()
{
    const size_t count = top_.sizeOf("nodes");
    children_.resize(count);
    hasParent_.assign(count, false);
    for (size_t i = 0; i < count; ++i) {
        const auto list = top_["nodes"][i].find("children");
        for (size_t k = 0; list && k < list->size(); ++k) {
            const size_t child = (*list)[k].index(count, "node");
            if (hasParent_[child]) (*list)[k].fail("node " + std::to_string(child) + " has two parents; the file is damaged, export it again");
            hasParent_[child] = true;
            children_[i].push_back(child);
        }
    }
    // With one parent each, whatever is not below a root is in a cycle.
    std::vector<size_t> open;
    size_t reached = 0;
    for (size_t i = 0; i < count; ++i)
        if (!hasParent_[i]) open.push_back(i);
    while (!open.empty()) {
        const size_t n = open.back();
        open.pop_back();
        ++reached;
        open.insert(open.end(), children_[n].begin(), children_[n].end());
    }
    if (reached != count)
        throw Error("/nodes: " + std::to_string(count - reached) + " nodes are below themselves; the file is damaged, export it again");
}

std::vector<size_t> SceneReader::roots()
{
    std::vector<size_t> found;
    const size_t scenes = top_.sizeOf("scenes");
    const auto chosen = top_.index("scene", scenes, "scene");
    if (chosen || scenes) {
        const JsonPlace s = top_["scenes"][chosen.value_or(0)];
        const auto list = s.find("nodes");
        std::set<size_t> seen;
        for (size_t i = 0; list && i < list->size(); ++i) {
            const size_t n = (*list)[i].index(children_.size(), "node");
            if (hasParent_[n]) (*list)[i].fail("node " + std::to_string(n) + " is no root; the file is damaged, export it again");
            if (!seen.insert(n).second) (*list)[i].fail("node " + std::to_string(n) + " is named twice; the file is damaged, export it again");
            found.push_back(n);
        }
        return found;
    }
    for (size_t i = 0; i < children_.size(); ++i)
        if (!hasParent_[i]) found.push_back(i);
    return found;
}

Node SceneReader::node(const JsonPlace& place)
{
    Node n;
    n.name = place.text("name");
    n.local = transform(place);
    if (const auto m = place.index("mesh", meshes_.size(), "mesh")) n.mesh = mesh(*m);
    readWeights(place, n);
    place.index("skin", top_.sizeOf("skins"), "skin");
    place.index("camera", top_.sizeOf("cameras"), "camera");
    if (const auto extras = place.find("extras")) n.extras = extras->value().dump();
    return n;
}

// Those of the node, else those of its mesh, one a morph target; all 0 are none.
void SceneReader::readWeights(const JsonPlace& place, Node& n)
{
    if (!n.mesh) return;
    const auto own = place.find("weights"), ofMesh = top_["meshes"][place["mesh"].whole()].find("weights");
    const auto& list = own ? own : ofMesh;
    if (!list) return;
    const size_t targets = facts_[n.mesh].morphTargets;
    if (list->size() != targets)
        warnOnce("morph-weights", list->pointer() + ": " + std::to_string(list->size()) + " weights for " + std::to_string(targets) +
                                      " morph targets; missing ones are 0");
    document_.charge(targets * sizeof(double), place.pointer());
    n.morphWeights.resize(targets, 0);
    for (size_t i = 0; i < std::min(targets, list->size()); ++i) n.morphWeights[i] = (*list)[i].number();
    if (std::all_of(n.morphWeights.begin(), n.morphWeights.end(), [](double w) { return w == 0; })) n.morphWeights.clear();
}

void SceneReader::addTree()
{
    nodes_.ids.resize(children_.size());
    nodes_.morphTargets.resize(children_.size(), 0);
    struct Open {
        size_t node;
        NodeId parent;
    };
    std::vector<Open> open;
    const std::vector<size_t> first = roots();
    for (auto r = first.rbegin(); r != first.rend(); ++r) open.push_back({*r, {}});
    while (!open.empty()) {
        const Open o = open.back();
        open.pop_back();
        const NodeId id = keep(parts_.nodes, node(top_["nodes"][o.node]));
        parts_.nodes[id].parent = o.parent;
        nodes_.ids[o.node] = id;
        if (parts_.nodes[id].mesh) nodes_.morphTargets[o.node] = facts_[parts_.nodes[id].mesh].morphTargets;
        (o.parent ? parts_.nodes[o.parent].children : parts_.roots).push_back(id);
        for (auto c = children_[o.node].rbegin(); c != children_[o.node].rend(); ++c) open.push_back({*c, id});
    }
    // Files that are only a library of meshes: each gets a node.
    for (size_t i = 0; children_.empty() && i < meshes_.size(); ++i) {
        Node n;
        n.mesh = mesh(i);
        n.name = parts_.meshes[n.mesh].name;
        parts_.roots.push_back(keep(parts_.nodes, std::move(n)));
    }
}

// Skins that pose no mesh say which nodes are joints; they are no part of the scene.
void SceneReader::addMotion()
{
    std::vector<std::optional<Skin>> skins = gltfSkins(document_, nodes_);
    for (const auto& skin : skins)
        for (size_t j = 0; skin && j < skin->joints.size(); ++j) parts_.nodes[skin->joints[j]].joint = Node::Joint::Joint;
    std::map<size_t, SkinId> kept;
    for (size_t i = 0; i < nodes_.ids.size(); ++i)
        if (nodes_.ids[i]) bindNode(i, skins, kept);
    for (Clip& clip : gltfClips(document_, nodes_)) keep(parts_.clips, std::move(clip));
}

// Gives a node its skin when its mesh can be posed by it.
void SceneReader::bindNode(size_t i, std::vector<std::optional<Skin>>& skins, std::map<size_t, SkinId>& kept)
{
    const JsonPlace place = top_["nodes"][i];
    const auto index = place.index("skin", skins.size(), "skin");
    if (!index || !skins[*index]) return;
    Node& n = parts_.nodes[nodes_.ids[i]];
    if (!n.mesh || !facts_[n.mesh].slots) {
        warn("bad-skin", place.pointer() + ": it has a skin, but no mesh with joints and weights; the skin was left out");
        return;
    }
    if (const size_t slots = skins[*index]->joints.size(); slots < facts_[n.mesh].slots) {
        facts_[n.mesh].slots = slots;
        size_t left = 0;
        Mesh& mesh = parts_.meshes[n.mesh].base;
        mesh = withinSlots(mesh, slots, left);
        if (left)
            warn("bad-joints", place.pointer() + ": " + std::to_string(left) +
                                   " vertices of its mesh name joints that its skin does not have; those weights were left out");
    }
    const auto [known, fresh] = kept.try_emplace(*index);
    if (fresh) known->second = keep(parts_.skins, *skins[*index]);
    n.skin = known->second;
}

void cutShort(std::vector<Warning>& warnings)
{
    constexpr size_t most = 200;
    if (warnings.size() <= most) return;
    const size_t more = warnings.size() - most;
    warnings.resize(most);
    warnings.push_back({"more-warnings", "and " + std::to_string(more) + " further warnings", {}});
}

// The project if there is one that may be opened.
std::optional<Scene> projectIn(GltfDocument& document, GltfReadOptions::Project wanted)
{
    if (wanted == GltfReadOptions::Project::Never || !hasProject(document)) return std::nullopt;
    try {
        if (wanted == GltfReadOptions::Project::WhenIntact && !projectIsIntact(document)) {
            document.warnings().push_back(
                {"project-core-changed",
                 "another program changed the plain part of this project; that part was read, without the modifiers that were saved",
                 {}});
            return std::nullopt;
        }
        return readProject(document);
    } catch (const Error& e) {
        document.warnings().push_back(
            {"project-damaged", std::string(e.what()) + "; what was saved for going on editing cannot be used, the plain part was read", {}});
        return std::nullopt;
    }
}

}  // namespace

Imported readGltf(std::span<const uint8_t> content, const std::filesystem::path& folder, const GltfReadOptions& options, Progress* progress)
{
    GltfDocument document(content, folder);
    Imported in;
    in.format = document.binary() ? "glTF 2.0 (binary)" : "glTF 2.0";
    in.units = "metres";
    in.placementFromFile = true;
    if (auto project = projectIn(document, options.project)) {
        in.scene = std::move(*project);
        in.project = true;
    } else {
        in.scene = SceneReader(document, progress).read();
    }
    in.warnings = std::move(document.warnings());
    cutShort(in.warnings);
    if (progress) progress->at(1);
    return in;
}

Imported readGltf(const std::filesystem::path& file, const GltfReadOptions& options, Progress* progress)
{
    const FileBytes bytes = readBytes(file);
    try {
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        return readGltf({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, folder, options, progress);
    } catch (const Error& e) {
        throw Error(file.string(), e.what());
    } catch (const nlohmann::json::exception& e) {
        throw Error(file.string(), std::string(e.what()) + "; the file is damaged");
    }
}

Imported readGltf(const std::filesystem::path& file, Progress* progress)
{
    return readGltf(file, {}, progress);
}

}  // namespace mw
