#include "core/io/project.h"

#include <cmath>

#include "core/math/hash.h"

namespace mw {

namespace {

using nlohmann::json;

// JSON has no infinities; such numbers are rare and become words.
json exact(double d)
{
    if (std::isfinite(d)) return d;
    return std::isnan(d) ? "nan" : d > 0 ? "inf" : "-inf";
}

template <class Vector>
json exactly(const Vector& v, int n)
{
    json out = json::array();
    for (int i = 0; i < n; ++i) out.push_back(exact(v[i]));
    return out;
}

json valuesOf(const ParameterValues& values)
{
    json out = json::object();
    for (const auto& [name, value] : values) {
        if (const auto* point = std::get_if<glm::dvec3>(&value))
            out[name] = exactly(*point, 3);
        else if (const auto* number = std::get_if<double>(&value))
            out[name] = std::isfinite(*number) ? json(*number) : json{{"number", exact(*number)}};
        else if (const auto* whole = std::get_if<int64_t>(&value))
            out[name] = *whole;
        else if (const auto* flag = std::get_if<bool>(&value))
            out[name] = *flag;
        else
            out[name] = std::get<std::string>(value);
    }
    return out;
}

json attributeOf(GltfBuilder& builder, const Attribute& a)
{
    constexpr const char* types[] = {"f32", "f64", "i32"};
    json out{{"name", a.name}, {"domain", int(a.domain)}, {"components", a.components}, {"type", types[a.values.index()]}, {"stored", int(a.stored)}};
    std::visit(
        [&](const auto& v) {
            if (!v.empty()) out["view"] = builder.addArray(v.span());
        },
        a.values);
    return out;
}

json meshOf(GltfBuilder& builder, MeshId id, const MeshObject& o)
{
    json out{{"id", id.value}, {"name", o.name}};
    for (const MaterialId m : o.materials) out["materials"].push_back(m.value);
    const Mesh& mesh = o.base;
    const auto array = [&](const char* key, const auto& values) {
        if (!values.empty()) out[key] = builder.addArray(values.span());
    };
    array("positions", mesh.positions());
    if (mesh.isTriangles() && mesh.faceCount() > 0)
        out["triangles"] = true;
    else
        array("faceStart", mesh.faceStart());
    array("cornerVertex", mesh.cornerVertex());
    array("lines", mesh.lines());
    for (const Attribute& a : mesh.attributes()) out["attributes"].push_back(attributeOf(builder, a));
    if (!mesh.groupNames().empty()) out["groups"] = mesh.groupNames();
    for (const Modifier& m : o.stack)
        out["stack"].push_back({{"id", m.id.value}, {"operation", m.operation}, {"enabled", m.enabled}, {"values", valuesOf(m.values)}});
    return out;
}

json textureOf(const Material::Texture& t)
{
    return {{"image", t.image.value}, {"set", t.set}, {"repeat", t.repeat}};
}

json materialOf(MaterialId id, const Material& m)
{
    return {{"id", id.value},
            {"name", m.name},
            {"baseColor", exactly(m.baseColor, 4)},
            {"emissive", exactly(m.emissive, 3)},
            {"metallic", exact(m.metallic)},
            {"roughness", exact(m.roughness)},
            {"normalScale", exact(m.normalScale)},
            {"occlusionStrength", exact(m.occlusionStrength)},
            {"alphaCutoff", exact(m.alphaCutoff)},
            {"alpha", int(m.alpha)},
            {"doubleSided", m.doubleSided},
            {"baseColorTexture", textureOf(m.baseColorTexture)},
            {"metallicRoughnessTexture", textureOf(m.metallicRoughnessTexture)},
            {"normalTexture", textureOf(m.normalTexture)},
            {"occlusionTexture", textureOf(m.occlusionTexture)},
            {"emissiveTexture", textureOf(m.emissiveTexture)},
            {"extras", m.extras}};
}

json nodeOf(NodeId id, const Node& n)
{
    const glm::dquat& q = n.local.rotation;
    json out{{"id", id.value},
             {"name", n.name},
             {"translation", exactly(n.local.translation, 3)},
             {"rotation", exactly(glm::dvec4(q.x, q.y, q.z, q.w), 4)},
             {"scale", exactly(n.local.scale, 3)},
             {"visible", n.visible},
             {"mesh", n.mesh.value}};
    for (const NodeId c : n.children) out["children"].push_back(c.value);
    if (!n.extras.empty()) out["extras"] = n.extras;
    if (n.skin) out["skin"] = n.skin.value;
    if (n.terrain) out["terrain"] = n.terrain.value;
    if (n.joint != Node::Joint::No) out["joint"] = int(n.joint);
    for (const double w : n.morphWeights) out["morphWeights"].push_back(exact(w));
    return out;
}

json skinOf(GltfBuilder& builder, SkinId id, const Skin& s)
{
    json out{{"id", id.value}, {"name", s.name}, {"skeleton", s.skeleton.value}, {"joints", json::array()}};
    for (const NodeId j : s.joints) out["joints"].push_back(j.value);
    if (!s.inverseBind.empty()) out["inverseBind"] = builder.addArray(std::span(s.inverseBind));
    return out;
}

// Arrays that channels share are written once.
using NumberViews = std::map<const void*, size_t>;

json clipOf(GltfBuilder& builder, NumberViews& known, ClipId id, const Clip& c)
{
    json out{{"id", id.value}, {"name", c.name}, {"frameTime", exact(c.frameTime)}, {"channels", json::array()}};
    const auto array = [&](json& to, const char* key, const Shared<double>& numbers) {
        if (numbers.empty()) return;
        const auto [view, fresh] = known.try_emplace(numbers.id(), 0);
        if (fresh) view->second = builder.addArray(numbers.span());
        to[key] = view->second;
    };
    for (const auto& channel : c.channels) {
        json entry{{"node", channel->node.value},
                   {"path", int(channel->path)},
                   {"interpolation", int(channel->interpolation)},
                   {"components", channel->components}};
        array(entry, "times", channel->times);
        array(entry, "values", channel->values);
        out["channels"].push_back(std::move(entry));
    }
    return out;
}

json terrainOf(GltfBuilder& builder, TerrainId id, const TerrainObject& o)
{
    const Terrain& t = o.terrain;
    json out{{"id", id.value},
             {"name", t.name},
             {"width", t.map.width()},
             {"height", t.map.height()},
             {"extent", exact(t.extent)},
             {"maximumHeight", exact(t.maximumHeight)},
             {"waterLevel", exact(t.waterLevel)},
             {"detail",
              {{"patches", t.detail.patches},
               {"nearLevel", exact(t.detail.nearLevel)},
               {"farLevel", exact(t.detail.farLevel)},
               {"nearDistance", exact(t.detail.nearDistance)},
               {"farDistance", exact(t.detail.farDistance)},
               {"corrected", t.detail.corrected}}},
             {"layers",
              {{"sandTo", exact(t.layers.sandTo)},
               {"grassTo", exact(t.layers.grassTo)},
               {"snowFrom", exact(t.layers.snowFrom)},
               {"rockSlope", exact(t.layers.rockSlope)}}},
             {"sourceOperation", o.sourceOperation},
             {"sourceValues", valuesOf(o.sourceValues)}};
    if (!t.map.empty()) out["heights"] = builder.addArray(std::span<const float>(t.map.rows()));
    return out;
}

// Of everything a plain viewer sees: the JSON without our extension and its views, and the bytes before ours.
std::string coreHash(const json& root, size_t views, std::span<const uint8_t> bytes)
{
    json core = root;
    core.erase("buffers");
    if (const auto v = core.find("bufferViews"); v != core.end() && v->is_array() && v->size() > views)
        v->erase(v->begin() + std::ptrdiff_t(views), v->end());
    if (core.contains("bufferViews") && core["bufferViews"].empty()) core.erase("bufferViews");
    if (const auto e = core.find("extensions"); e != core.end()) {
        if (e->is_object()) e->erase(projectExtension);
        if (e->empty()) core.erase(e);
    }
    if (const auto used = core.find("extensionsUsed"); used != core.end()) {
        if (used->is_array()) std::erase(used->get_ref<json::array_t&>(), json(projectExtension));
        if (used->empty()) core.erase(used);
    }
    Hasher h;
    h.text(textOf(core));
    h.bytes(bytes.data(), bytes.size());
    std::string hex;
    for (int shift = 60; shift >= 0; shift -= 4) hex += "0123456789abcdef"[h.value() >> shift & 15];
    return hex;
}

}  // namespace

void addProject(GltfBuilder& builder, const Scene& scene, const std::map<const void*, size_t>& imageViews)
{
    const size_t coreViews = builder.views(), coreBytes = builder.bin.size();
    json project{{"version", projectVersion},
                 {"core", {{"hash", coreHash(builder.root, coreViews, builder.bin)}, {"views", coreViews}, {"bytes", coreBytes}}}};
    for (const NodeId r : scene.roots()) project["roots"].push_back(r.value);
    for (const NodeId n : scene.nodes()) project["nodes"].push_back(nodeOf(n, scene.node(n)));
    for (const MeshId m : scene.meshes()) project["meshes"].push_back(meshOf(builder, m, *scene.find(m)));
    for (const MaterialId m : scene.materials()) project["materials"].push_back(materialOf(m, *scene.find(m)));
    for (const ImageId i : scene.images()) {
        const Image& image = *scene.find(i);
        json entry{{"id", i.value}, {"name", image.name}, {"mimeType", image.mimeType}};
        if (const auto known = imageViews.find(image.bytes.get()); known != imageViews.end())
            entry["view"] = known->second;
        else if (image.bytes && !image.bytes->empty())
            entry["view"] = builder.addView(*image.bytes);
        project["images"].push_back(std::move(entry));
    }
    for (const SkinId k : scene.skins()) project["skins"].push_back(skinOf(builder, k, *scene.find(k)));
    NumberViews numberViews;
    for (const ClipId c : scene.clips()) project["clips"].push_back(clipOf(builder, numberViews, c, *scene.find(c)));
    for (const TerrainId t : scene.terrains()) project["terrains"].push_back(terrainOf(builder, t, *scene.find(t)));
    builder.root["extensions"][projectExtension] = std::move(project);
    builder.root["extensionsUsed"].push_back(projectExtension);
}

bool hasProject(const GltfDocument& document)
{
    const auto extensions = document.root().find("extensions");
    return extensions && extensions->has(projectExtension);
}

bool projectIsIntact(const GltfDocument& document)
{
    const JsonPlace core = document.root()["extensions"][projectExtension]["core"];
    const uint64_t bytes = core["bytes"].whole(), views = core["views"].whole();
    const auto buffer = document.firstBuffer();
    if (bytes > buffer.size() || views > document.views()) return false;
    return core["hash"].text() == coreHash(document.root().value(), views, buffer.subspan(0, bytes));
}

}  // namespace mw
