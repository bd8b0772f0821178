// The scene layer of writing: nodes and what they show, materials, pictures, and the files.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "core/io/file.h"
#include "core/io/gltf.h"
#include "core/io/gltf_builder.h"
#include "core/io/gltf_container.h"
#include "core/io/gltf_write_mesh.h"
#include "core/io/gltf_write_motion.h"
#include "core/io/picture.h"
#include "core/io/project.h"
#include "core/scene/evaluation.h"

namespace mw {

namespace {

using nlohmann::json;

double between(double x, double low, double high)
{
    return std::isnan(x) ? high : std::clamp(x, low, high);
}

// One a morph target.
std::vector<double> weightsOf(const Node& n, size_t targets)
{
    std::vector<double> out(targets, 0);
    for (size_t i = 0; i < std::min(targets, n.morphWeights.size()); ++i)
        if (std::isfinite(n.morphWeights[i])) out[i] = n.morphWeights[i];
    return out;
}

class SceneWriter {
public:
    /// `scene` as viewers show it, `original` as the project keeps it.
    SceneWriter(const Scene& scene, const Scene& original, const WriteOptions& options, std::vector<Warning>& warnings, Progress* progress)
        : scene_(scene), original_(original), options_(options), warnings_(warnings), progress_(progress)
    {}
    GltfBuilder write();

private:
    /// A mesh of the file. Nodes whose skins differ in their number of joints do not share one.
    struct MeshEntry {
        std::optional<size_t> index;
        bool skinned = false;
        std::vector<double> weights;  // of its morph targets
    };
    void addTree();
    void findSkinned();
    void addNodes();
    void addRoots();
    void addMotion();
    void showSkinned(NodeId id);
    void putMesh(json& out, NodeId id, const MeshEntry& entry);
    void putTransform(json& out, const Transform& t);
    void putExtras(json& out, const std::string& extras);
    const MeshEntry& mesh(const Node& n);
    Mesh evaluated(const MeshObject& object);
    std::optional<size_t> material(MaterialId id);
    GltfSlot slot(MaterialId id);
    json materialJson(const Material& m);
    /// The texture as {"index", "texCoord"}; null when there is none that can be written.
    json texture(const Material::Texture& t);
    std::optional<size_t> image(ImageId id);
    size_t sampler(bool repeat);
    void warn(const char* code, std::string text) { warnings_.push_back({code, std::move(text), {}}); }

    const Scene &scene_, &original_;
    const WriteOptions& options_;
    std::vector<Warning>& warnings_;
    Progress* progress_;
    GltfBuilder builder_;
    Evaluator evaluator_{0};
    GltfPlaces places_;
    std::set<NodeId> lifted_;                  // skinned ones that are or become roots
    std::vector<NodeId> skinned_;              // shown, waiting for their place
    std::vector<size_t> roots_;                // further ones of the file
    std::vector<std::vector<NodeId>> joined_;  // roots that get a common parent
    std::set<NodeId> hiding_;                  // they or something above them
    std::set<NodeId> moved_;                   // a clip drives their transform
    std::map<SkinId, size_t> skins_;
    std::map<std::pair<MeshId, size_t>, MeshEntry> meshes_;
    std::map<MaterialId, size_t> materials_;
    std::map<ImageId, std::optional<size_t>> images_;
    std::map<std::pair<ImageId, bool>, size_t> textures_;
    std::map<bool, size_t> samplers_;
    std::map<const void*, size_t> imageViews_;
    std::vector<std::shared_ptr<const std::vector<uint8_t>>> pictures_;
    size_t hidden_ = 0, done_ = 0, work_ = 1;
};

GltfBuilder SceneWriter::write()
{
    builder_.root["asset"] = {{"version", "2.0"}, {"generator", "Meshwright"}};
    work_ = std::max<size_t>(scene_.meshes().size(), 1);
    addTree();
    if (hidden_ && !options_.project)
        warn("hidden-nodes", std::to_string(hidden_) + " hidden objects were written without their meshes; show them to export them");
    if (options_.project) addProject(builder_, original_, imageViews_);
    if (!builder_.bin.empty()) builder_.root["buffers"].push_back({{"byteLength", builder_.bin.size()}});
    return std::move(builder_);
}

void SceneWriter::addTree()
{
    joined_ = rootsToJoin(scene_);
    for (const ClipId c : scene_.clips())
        for (const auto& channel : scene_.find(c)->channels)
            if (channel->path != Channel::Path::Weights) moved_.insert(channel->node);
    findSkinned();
    addNodes();
    for (const NodeId id : skinned_) showSkinned(id);
    addRoots();
    addMotion();
}

// A skinned mesh stands by its joints alone, and glTF wants it at a root that has no transform. A node that is there for nothing else goes
// to the root itself.
void SceneWriter::findSkinned()
{
    std::set<NodeId> joints;
    for (const SkinId id : scene_.skins()) joints.insert(scene_.find(id)->joints.begin(), scene_.find(id)->joints.end());
    for (const NodeId id : scene_.nodes()) {
        const Node& n = scene_.node(id);
        if (!n.visible || hiding_.contains(n.parent)) hiding_.insert(id);
        if (!scene_.find(n.mesh) || !scene_.find(n.skin) || hiding_.contains(id)) continue;
        skinned_.push_back(id);
        const auto holds = [&](const std::vector<NodeId>& group) { return std::find(group.begin(), group.end(), id) != group.end(); };
        const bool isThere = !n.parent && n.local == Transform{} && std::none_of(joined_.begin(), joined_.end(), holds);
        if (!moved_.contains(id) && (isThere || (n.children.empty() && !joints.contains(id)))) lifted_.insert(id);
    }
}

// Depth first without recursion: a tree may be deeper than the stack.
void SceneWriter::addNodes()
{
    const std::vector<NodeId> order = scene_.nodes();
    for (size_t i = 0; i < order.size(); ++i) places_.nodes[order[i]] = i;
    for (const NodeId id : order) {
        const Node& n = scene_.node(id);
        json out = json::object();
        if (!n.name.empty()) out["name"] = n.name;
        if (!lifted_.contains(id)) putTransform(out, n.local);
        putExtras(out, n.extras);
        for (const NodeId c : n.children)
            if (!lifted_.contains(c)) out["children"].push_back(places_.nodes[c]);
        if (n.mesh && hiding_.contains(id))
            ++hidden_;
        else if (n.mesh && !scene_.find(n.skin))
            putMesh(out, id, mesh(n));
        if (n.parent && lifted_.contains(id)) roots_.push_back(places_.nodes[id]);
        builder_.append("nodes", std::move(out));
    }
}

void SceneWriter::addRoots()
{
    json& scene = builder_.root["scenes"][0] = json::object();
    builder_.root["scene"] = 0;
    std::set<NodeId> below;
    for (const auto& group : joined_) {
        json parent{{"name", "joints"}};
        for (const NodeId r : group) parent["children"].push_back(places_.nodes[r]);
        below.insert(group.begin(), group.end());
        roots_.push_back(builder_.append("nodes", std::move(parent)));
    }
    for (const NodeId r : scene_.roots())
        if (!below.contains(r)) scene["nodes"].push_back(places_.nodes[r]);
    for (const size_t r : roots_) scene["nodes"].push_back(r);
}

// A node that has to keep its place leaves its mesh to a new root.
void SceneWriter::showSkinned(NodeId id)
{
    const Node& n = scene_.node(id);
    const MeshEntry& entry = mesh(n);
    if (!entry.index) return;
    size_t node = places_.nodes[id];
    if (!lifted_.contains(id)) {
        node = builder_.append("nodes", n.name.empty() ? json::object() : json{{"name", n.name}});
        roots_.push_back(node);
    }
    putMesh(builder_.root["nodes"][node], id, entry);
    places_.meshes[id].node = node;
    if (!entry.skinned) return;
    const auto [known, fresh] = skins_.try_emplace(n.skin, 0);
    if (fresh) known->second = addSkin(builder_, scene_, *scene_.find(n.skin), places_);
    builder_.root["nodes"][node]["skin"] = known->second;
}

// The skins of hidden meshes are written, too: they say which nodes are joints.
void SceneWriter::addMotion()
{
    std::set<NodeId> joints;
    for (const SkinId id : scene_.skins()) {
        const Skin& skin = *scene_.find(id);
        if (skin.joints.empty()) continue;
        if (!skins_.contains(id)) skins_[id] = addSkin(builder_, scene_, skin, places_);
        joints.insert(skin.joints.begin(), skin.joints.end());
    }
    addSkeletons(builder_, scene_, places_, joints);
    addAnimations(builder_, scene_, places_, warnings_);
}

void SceneWriter::putMesh(json& out, NodeId id, const MeshEntry& entry)
{
    if (!entry.index) return;
    out["mesh"] = *entry.index;
    places_.meshes[id] = {places_.nodes[id], entry.weights.size()};
    const std::vector<double> weights = weightsOf(scene_.node(id), entry.weights.size());
    if (weights != entry.weights) out["weights"] = weights;
}

void SceneWriter::putTransform(json& out, const Transform& t)
{
    const auto finite = [](const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    if (t.translation != glm::dvec3(0) && finite(t.translation)) out["translation"] = {t.translation.x, t.translation.y, t.translation.z};
    if (t.scale != glm::dvec3(1) && finite(t.scale)) out["scale"] = {t.scale.x, t.scale.y, t.scale.z};
    const double length = std::sqrt(glm::dot(t.rotation, t.rotation));
    if (t.rotation == glm::dquat(1, 0, 0, 0) || !(length > 1e-12) || !std::isfinite(length)) return;
    const glm::dquat q = std::abs(length - 1) < 1e-9 ? t.rotation : t.rotation / length;
    out["rotation"] = {q.x, q.y, q.z, q.w};
}

// What was kept of a file; a reader of another format may have put any text there.
void SceneWriter::putExtras(json& out, const std::string& extras)
{
    if (extras.empty()) return;
    json parsed = json::parse(extras, nullptr, false);
    if (!parsed.is_discarded()) out["extras"] = std::move(parsed);
}

Mesh SceneWriter::evaluated(const MeshObject& object)
{
    const Evaluation e = (options_.evaluator ? *options_.evaluator : evaluator_).evaluate(object, progress_, {}, &scene_);
    for (size_t i = 0; i < e.levels.size(); ++i)
        if (!e.levels[i].error.empty())
            warn("modifier-failed", "mesh \"" + object.name + "\", modifier " + object.stack[i].operation + ": " + e.levels[i].error +
                                        "; the mesh before it was written");
    return e.result();
}

const SceneWriter::MeshEntry& SceneWriter::mesh(const Node& n)
{
    const Skin* skin = scene_.find(n.skin);
    const size_t joints = skin ? skin->joints.size() : 0;
    const auto [known, fresh] = meshes_.try_emplace({n.mesh, joints});
    MeshEntry& entry = known->second;
    const MeshObject* object = scene_.find(n.mesh);
    if (!fresh || !object) return entry;
    const Mesh shown = evaluated(*object);
    std::vector<GltfSlot> slots;
    for (const MaterialId m : object->materials) slots.push_back(slot(m));
    json out = gltfMeshOf(builder_, shown, {slots, joints, object->name, !options_.project}, warnings_, progress_);
    if (!out.is_null()) {
        entry.skinned = out["primitives"][0]["attributes"].contains("JOINTS_0");
        if (out.contains("extras")) entry.weights = weightsOf(n, out["extras"]["targetNames"].size());
        if (std::any_of(entry.weights.begin(), entry.weights.end(), [](double w) { return w != 0; })) out["weights"] = entry.weights;
        entry.index = builder_.append("meshes", std::move(out));
    }
    if (!shown.groupNames().empty() && !options_.project)
        warn("lost-groups",
             "mesh \"" + object->name + "\": glTF cannot hold its " + std::to_string(shown.groupNames().size()) + " groups; a project keeps them");
    if (progress_) progress_->at(float(++done_) / float(work_));
    return entry;
}

GltfSlot SceneWriter::slot(MaterialId id)
{
    GltfSlot s;
    const auto index = material(id);
    if (!index) return s;
    s.material = int(*index);
    // What was written counts: a picture that could not be needs no coordinates.
    const json& m = builder_.root["materials"][*index];
    const auto use = [&](const json& owner, const char* key) {
        if (const auto t = owner.find(key); t != owner.end()) s.texcoords = std::max(s.texcoords, t->value("texCoord", 0) + 1);
    };
    if (const auto pbr = m.find("pbrMetallicRoughness"); pbr != m.end()) {
        use(*pbr, "baseColorTexture");
        use(*pbr, "metallicRoughnessTexture");
    }
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) use(m, key);
    if (const auto t = m.find("normalTexture"); t != m.end()) s.tangentSet = t->value("texCoord", 0);
    return s;
}

std::optional<size_t> SceneWriter::material(MaterialId id)
{
    const Material* m = scene_.find(id);
    if (!m) return std::nullopt;
    if (const auto known = materials_.find(id); known != materials_.end()) return known->second;
    return materials_[id] = builder_.append("materials", materialJson(*m));
}

json SceneWriter::materialJson(const Material& m)
{
    json pbr = json::object(), out = json::object();
    const auto put = [](json& to, const char* key, json value) {
        if (!value.is_null()) to[key] = std::move(value);
    };
    const glm::dvec4& c = m.baseColor;
    pbr["baseColorFactor"] = {between(c.r, 0, 1), between(c.g, 0, 1), between(c.b, 0, 1), between(c.a, 0, 1)};
    pbr["metallicFactor"] = between(m.metallic, 0, 1);
    pbr["roughnessFactor"] = between(m.roughness, 0, 1);
    put(pbr, "baseColorTexture", texture(m.baseColorTexture));
    put(pbr, "metallicRoughnessTexture", texture(m.metallicRoughnessTexture));
    put(out, "normalTexture", texture(m.normalTexture));
    put(out, "occlusionTexture", texture(m.occlusionTexture));
    put(out, "emissiveTexture", texture(m.emissiveTexture));
    if (out.contains("normalTexture") && m.normalScale != 1 && std::isfinite(m.normalScale)) out["normalTexture"]["scale"] = m.normalScale;
    if (out.contains("occlusionTexture") && m.occlusionStrength != 1) out["occlusionTexture"]["strength"] = between(m.occlusionStrength, 0, 1);
    out["pbrMetallicRoughness"] = std::move(pbr);
    if (!m.name.empty()) out["name"] = m.name;
    const double brightest = std::max({m.emissive.r, m.emissive.g, m.emissive.b});
    const double strength = std::isfinite(brightest) ? std::max(brightest, 1.0) : 1;
    if (brightest > 0)
        out["emissiveFactor"] = {between(m.emissive.r / strength, 0, 1), between(m.emissive.g / strength, 0, 1),
                                 between(m.emissive.b / strength, 0, 1)};
    if (strength > 1) {
        out["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
        json& used = builder_.root["extensionsUsed"];
        if (used.empty()) used.push_back("KHR_materials_emissive_strength");
    }
    if (m.alpha != Material::Alpha::Opaque) out["alphaMode"] = m.alpha == Material::Alpha::Mask ? "MASK" : "BLEND";
    if (m.alpha == Material::Alpha::Mask) out["alphaCutoff"] = between(m.alphaCutoff, 0, 1e6);
    if (m.doubleSided) out["doubleSided"] = true;
    putExtras(out, m.extras);
    return out;
}

json SceneWriter::texture(const Material::Texture& t)
{
    const auto picture = image(t.image);
    if (!picture) return nullptr;
    const auto [known, fresh] = textures_.try_emplace({t.image, t.repeat}, 0);
    if (fresh) known->second = builder_.append("textures", {{"source", *picture}, {"sampler", sampler(t.repeat)}});
    json out{{"index", known->second}};
    if (t.set > 0) out["texCoord"] = std::min(t.set, 31);
    return out;
}

size_t SceneWriter::sampler(bool repeat)
{
    constexpr int linear = 9729, mipmaps = 9987, repeating = 10497, clamping = 33071;
    const auto [known, fresh] = samplers_.try_emplace(repeat, 0);
    const int wrap = repeat ? repeating : clamping;
    if (fresh) known->second = builder_.append("samplers", {{"magFilter", linear}, {"minFilter", mipmaps}, {"wrapS", wrap}, {"wrapT", wrap}});
    return known->second;
}

std::optional<size_t> SceneWriter::image(ImageId id)
{
    const Image* i = scene_.find(id);
    if (!i) return std::nullopt;
    if (const auto known = images_.find(id); known != images_.end()) return known->second;
    std::optional<size_t>& index = images_[id];
    const auto bytes = portablePicture(i->bytes);
    if (!bytes) {
        warn("bad-image", "picture \"" + i->name + "\" is damaged, or neither PNG nor JPEG, and was left out; convert it");
        return index;
    }
    pictures_.push_back(bytes);  // so that its address stays its own
    const auto [view, fresh] = imageViews_.try_emplace(bytes.get(), 0);
    if (fresh) view->second = builder_.addView(*bytes);
    json out{{"bufferView", view->second}, {"mimeType", pictureType(*bytes)}};
    if (!i->name.empty()) out["name"] = i->name;
    index = builder_.append("images", std::move(out));
    return index;
}

GltfBuilder builtFrom(const Scene& scene, const WriteOptions& options, std::vector<Warning>& warnings, Progress* progress)
{
    const Scene shown = withTerrainMeshes(scene, options.terrainTriangles, progress);
    return SceneWriter(shown, scene, options, warnings, progress).write();
}

// Letters that a URI may have as they are; all others as %XX.
std::string percentEncoded(const std::string& name)
{
    std::string out;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) || c == '-' || c == '.' || c == '_' || c == '~')
            out += c;
        else
            (out += '%') += {"0123456789ABCDEF"[u >> 4], "0123456789ABCDEF"[u & 15]};
    }
    return out;
}

}  // namespace

std::vector<uint8_t> glbOf(const Scene& scene, const WriteOptions& options, std::vector<Warning>* warnings, Progress* progress)
{
    std::vector<Warning> ignored;
    const GltfBuilder b = builtFrom(scene, options, warnings ? *warnings : ignored, progress);
    return glbContent(textOf(b.root), b.bin);
}

std::vector<Warning> writeGltf(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress)
{
    std::vector<Warning> warnings;
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".glb") {
        const std::vector<uint8_t> glb = glbOf(scene, options, &warnings, progress);
        OutputFile out(file);
        out.write(glb.data(), glb.size());
        out.commit();
        return warnings;
    }
    GltfBuilder b = builtFrom(scene, options, warnings, progress);
    std::filesystem::path binFile = file;
    binFile.replace_extension(".bin");
    if (!b.bin.empty()) b.root["buffers"][0]["uri"] = percentEncoded(binFile.filename().string());
    const std::string text = textOf(b.root, 1);
    OutputFile json(file);
    json.write(text);
    json.close();  // both are on the disk before either takes its name
    if (!b.bin.empty()) {
        OutputFile bin(binFile);
        bin.write(b.bin.data(), b.bin.size());
        bin.commit();
    }
    json.commit();
    return warnings;
}

}  // namespace mw
