#include "core/io/gltf_write_mesh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <set>

#include "core/io/gltf_split.h"
#include "core/io/gltf_write_skinning.h"

namespace mw {

namespace {

using nlohmann::json;

constexpr int vertexTarget = 34962, indexTarget = 34963;
constexpr int byteType = 5121, shortType = 5123, intType = 5125, floatType = 5126;
constexpr int pointMode = 0, lineMode = 1, triangleMode = 4;
constexpr const char* vectorType[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

float finite(float x)
{
    return std::isfinite(x) ? x : 0.f;
}

std::string numbered(std::string_view name, int set)
{
    return std::string(name) + (set ? std::to_string(set) : "");
}

class MeshWriter {
public:
    MeshWriter(GltfBuilder& builder, const Mesh& mesh, const GltfMeshUse& use, std::vector<Warning>& warnings)
        : builder_(builder), mesh_(mesh), slots_(use.slots), joints_(use.joints), name_(use.name), tellLost_(use.tellLost), warnings_(warnings)
    {}
    json write(Progress* progress);

private:
    void findSources();
    void addSource(const std::string& semantic, const Attribute& a, int components);
    void addTexcoords();
    void addColors();
    void addTargets();
    void addCustom();
    void addSkin();
    void putSkin(const GltfSplit& s, json& attributes);
    void tellLost();
    bool handled(const Attribute& a) const { return handled_.contains({a.name, a.domain}); }
    const Attribute* either(std::string_view name) const
    {
        const Attribute* a = mesh_.find(name, Domain::Corner);
        return a ? a : mesh_.find(name, Domain::Vertex);
    }

    std::map<int32_t, Array<uint32_t>> trianglesBySlot() const;
    json primitive(const GltfSplit& s, const GltfSlot& slot, int mode);
    void addLoose(json& primitives);
    size_t positions(const GltfSplit& s, json& attributes);
    Array<float> normals(const GltfSplit& s) const;
    Array<float> tangents(const GltfSplit& s, std::span<const float> normals, const GltfSlot& slot) const;
    Array<float> texcoords(const GltfSplit& s, int set) const;
    Array<float> values(const GltfSplit& s, const GltfSource& from) const;
    size_t addColor(const GltfSplit& s, const GltfSource& from);
    size_t addFloats(std::span<const float> values, int components, bool bounds = false);
    size_t addIndices(const GltfSplit& s);
    json targets(const GltfSplit& s, bool withNormals);
    size_t element(const GltfSplit& s, const GltfSource& from, size_t point) const
    {
        return from.domain == Domain::Vertex ? s.vertex[point] : s.corner[point];
    }
    bool usable(const GltfSplit& s, const GltfSource& from) const
    {
        return from.domain == Domain::Vertex || (!s.corner.empty() && s.corner[0] != none);
    }
    const GltfSource* source(const std::string& semantic) const
    {
        const auto i = std::find_if(sources_.begin(), sources_.end(), [&](const GltfSource& s) { return s.semantic == semantic; });
        return i == sources_.end() ? nullptr : &*i;
    }

    GltfBuilder& builder_;
    const Mesh& mesh_;
    const std::vector<GltfSlot>& slots_;
    const size_t joints_;
    const std::string& name_;
    const bool tellLost_;
    std::vector<Warning>& warnings_;
    GltfSkinning skinning_;
    std::vector<GltfSource> sources_;
    std::vector<std::string> targetNames_;
    std::set<std::pair<std::string, Domain>> handled_;
    int texcoordSets_ = 0, colorSets_ = 0;
};

void MeshWriter::addSource(const std::string& semantic, const Attribute& a, int components)
{
    handled_.insert({a.name, a.domain});
    GltfSource s{semantic, a.domain, components, a.floats(), {}, a.stored};
    if (s.values.empty() || a.components != components) {
        s.owned.resize(a.size() * size_t(components));
        for (size_t i = 0; i < a.size(); ++i)
            for (int k = 0; k < components; ++k) s.owned[i * size_t(components) + size_t(k)] = k < a.components ? float(a.at(i, k)) : 0.f;
        s.values = s.owned;
    }
    sources_.push_back(std::move(s));
}

void MeshWriter::addTexcoords()
{
    for (int set = 0; set < 32; ++set)
        if (const Attribute* a = either(numbered(names::texcoord, set))) {
            addSource("TEXCOORD_" + std::to_string(set), *a, 2);
            texcoordSets_ = set + 1;
        }
}

void MeshWriter::addColors()
{
    for (int set = 0; set < 32; ++set)
        if (const Attribute* a = either(numbered(names::color, set)); a && (a->components == 3 || a->components == 4))
            addSource("COLOR_" + std::to_string(colorSets_++), *a, a->components);
}

void MeshWriter::addTargets()
{
    for (const Attribute& a : mesh_.attributes()) {
        if (!a.name.starts_with(names::morph) || a.domain != Domain::Vertex || a.components != 3) continue;
        const std::string name = a.name.substr(names::morph.size());
        addSource(a.name, a, 3);
        targetNames_.push_back(name);
        if (const Attribute* n = either("morph-normal:" + name); n && n->components == 3) addSource(n->name, *n, 3);
        if (const Attribute* c = either("morph-color:" + name), *own = either(std::string(names::color));
            c && own && c->components == own->components)
            addSource(c->name, *c, c->components);
    }
}

// Whatever else lies on vertices or corners: glTF lets programs name attributes of their own with an underscore.
void MeshWriter::addCustom()
{
    std::set<std::string> taken;
    for (const Attribute& a : mesh_.attributes()) {
        const bool known = a.name == names::joints || a.name == names::weights || a.name == names::crease || a.name.starts_with("morph");
        if (handled(a) || known || a.domain == Domain::Face || a.components > 4) continue;
        std::string semantic = a.name.starts_with("_") ? "" : "_";
        for (const char c : a.name) semantic += std::isalnum(static_cast<unsigned char>(c)) ? char(std::toupper(static_cast<unsigned char>(c))) : '_';
        if (semantic == "_" || !taken.insert(semantic).second) continue;
        addSource(semantic, a, a.components);
    }
}

void MeshWriter::tellLost()
{
    handled_.insert({std::string(names::material), Domain::Face});
    std::string lost;
    for (const Attribute& a : mesh_.attributes())
        if (!handled(a)) lost += (lost.empty() ? "" : ", ") + a.name;
    if (lost.empty() || !tellLost_) return;
    warnings_.push_back(
        {"lost-attributes", "mesh \"" + name_ + "\": glTF cannot hold, or not without a skin: " + lost + "; a project keeps them", {}});
}

void MeshWriter::findSources()
{
    if (const Attribute* a = either(names::normal); a && a->components == 3) addSource("NORMAL", *a, 3);
    if (const Attribute* a = either(names::tangent); a && a->components == 4) addSource("TANGENT", *a, 4);
    addTexcoords();
    addColors();
    addTargets();
    addCustom();
    addSkin();
    tellLost();
}

void MeshWriter::addSkin()
{
    if (!joints_) return;
    skinning_ = gltfSkinning(mesh_, joints_);
    if (!skinning_.sets) return;
    handled_.insert({{std::string(names::joints), Domain::Vertex}, {std::string(names::weights), Domain::Vertex}});
    if (skinning_.unbound)
        warnings_.push_back({"unbound-vertices",
                             "mesh \"" + name_ + "\": " + std::to_string(skinning_.unbound) +
                                 " vertices hang on no joint, which glTF cannot say; they were written as moving with the first joint",
                             {}});
}

void MeshWriter::putSkin(const GltfSplit& s, json& attributes)
{
    const size_t n = 4 * skinning_.sets;
    for (size_t set = 0; set < skinning_.sets; ++set) {
        std::vector<float> weights;
        std::vector<uint16_t> joints;
        for (const uint32_t v : s.vertex)
            for (size_t k = n * v + 4 * set; k < n * v + 4 * set + 4; ++k) {
                weights.push_back(skinning_.weights[k]);
                joints.push_back(skinning_.joints[k]);
            }
        const auto add = [&](std::span<const uint8_t> bytes, int component) {
            const size_t view = builder_.addView(bytes, vertexTarget);
            return builder_.append("accessors", {{"bufferView", view}, {"componentType", component}, {"count", s.vertex.size()}, {"type", "VEC4"}});
        };
        const std::vector<uint8_t> narrow(joints.begin(), joints.end());
        const std::string number = std::to_string(set);
        attributes["JOINTS_" + number] =
            joints_ <= 256 ? add(narrow, byteType) : add({reinterpret_cast<const uint8_t*>(joints.data()), 2 * joints.size()}, shortType);
        attributes["WEIGHTS_" + number] = addFloats(weights, 4);
    }
}

// Triangles of the triangulation by slot; -1 for faces whose slot does not exist.
std::map<int32_t, Array<uint32_t>> MeshWriter::trianglesBySlot() const
{
    const Mesh::Triangulation& t = mesh_.triangulation();
    const size_t count = t.faces.size();
    std::map<int32_t, Array<uint32_t>> by;
    const Attribute* material = slots_.empty() ? nullptr : mesh_.find(names::material, Domain::Face);
    const std::span<const int32_t> slot = material && material->components == 1 ? material->integers() : std::span<const int32_t>();
    for (size_t i = 0; i < count; ++i) {
        const int32_t s = slot.empty() ? (slots_.empty() ? -1 : 0) : slot[t.faces[i]];
        by[s >= 0 && size_t(s) < slots_.size() ? s : -1].push_back(uint32_t(i));
    }
    return by;
}

json MeshWriter::write(Progress* progress)
{
    findSources();
    GltfSplitter splitter(mesh_, sources_);
    const Mesh::Triangulation& t = mesh_.triangulation();
    json primitives = json::array();
    for (const auto& [slot, triangles] : trianglesBySlot()) {
        if (progress) progress->at(progress->fraction);
        Array<uint32_t> vertices, corners;
        for (const uint32_t f : triangles)
            for (size_t k = 3 * size_t(f); k < 3 * size_t(f) + 3; ++k) {
                vertices.push_back(t.vertices[k]);
                corners.push_back(t.corners[k]);
            }
        primitives.push_back(primitive(splitter.split(vertices, corners), slot < 0 ? GltfSlot{} : slots_[size_t(slot)], triangleMode));
    }
    addLoose(primitives);
    if (primitives.empty()) return nullptr;
    json out{{"primitives", std::move(primitives)}};
    if (!name_.empty()) out["name"] = name_;
    if (!targetNames_.empty()) out["extras"]["targetNames"] = targetNames_;
    return out;
}

// Lines, and vertices that nothing uses.
void MeshWriter::addLoose(json& primitives)
{
    const GltfSlot slot = primitives.empty() && !slots_.empty() ? slots_[0] : GltfSlot{};
    GltfSplitter splitter(mesh_, {});
    std::vector<bool> used(mesh_.vertexCount(), false);
    for (const uint32_t v : mesh_.triangulation().vertices) used[v] = true;
    for (const uint32_t v : mesh_.lines()) used[v] = true;
    if (!mesh_.lines().empty()) primitives.push_back(primitive(splitter.split(mesh_.lines(), {}), slot, lineMode));
    Array<uint32_t> loose;
    for (size_t v = 0; v < used.size(); ++v)
        if (!used[v]) loose.push_back(uint32_t(v));
    if (!loose.empty()) primitives.push_back(primitive(splitter.split(loose, {}), slot, pointMode));
}

json MeshWriter::primitive(const GltfSplit& s, const GltfSlot& slot, int mode)
{
    json attributes = json::object();
    positions(s, attributes);
    const GltfSource* normalSource = source("NORMAL");
    const bool shaded = mode == triangleMode || (normalSource && usable(s, *normalSource));
    if (shaded) {
        const Array<float> n = normals(s);
        attributes["NORMAL"] = addFloats(n, 3);
        const GltfSource* t = source("TANGENT");
        if (mode == triangleMode && ((t && usable(s, *t)) || slot.tangentSet >= 0)) attributes["TANGENT"] = addFloats(tangents(s, n, slot), 4);
    }
    int sets = slot.texcoords;
    for (int set = 0; set < texcoordSets_; ++set)
        if (const GltfSource* a = source("TEXCOORD_" + std::to_string(set)); a && usable(s, *a)) sets = std::max(sets, set + 1);
    for (int set = 0; set < sets; ++set) attributes["TEXCOORD_" + std::to_string(set)] = addFloats(texcoords(s, set), 2);
    int colors = 0;  // those that points of this kind do not have leave no gap
    for (const GltfSource& a : sources_) {
        if (!usable(s, a)) continue;
        if (a.semantic.starts_with("COLOR_")) attributes["COLOR_" + std::to_string(colors++)] = addColor(s, a);
        if (a.semantic.starts_with("_")) attributes[a.semantic] = addFloats(values(s, a), a.components);
    }
    putSkin(s, attributes);
    json out{{"attributes", std::move(attributes)}};
    if (!targetNames_.empty()) out["targets"] = targets(s, mode == triangleMode);
    if (mode != pointMode) out["indices"] = addIndices(s);
    if (mode != triangleMode) out["mode"] = mode;
    if (slot.material >= 0) out["material"] = slot.material;
    return out;
}

json MeshWriter::targets(const GltfSplit& s, bool withNormals)
{
    // Only if every target has them: programs expect the same of all.
    const auto allHave = [&](const char* prefix) {
        return std::all_of(targetNames_.begin(), targetNames_.end(), [&](const std::string& n) {
            const GltfSource* from = source(prefix + n);
            return from && usable(s, *from);
        });
    };
    withNormals = withNormals && allHave("morph-normal:");
    const bool withColors = allHave("morph-color:") && source("COLOR_0") && usable(s, *source("COLOR_0"));
    json all = json::array();
    for (const std::string& name : targetNames_) {
        json target{{"POSITION", addFloats(values(s, *source(std::string(names::morph) + name)), 3, true)}};
        if (withNormals) target["NORMAL"] = addFloats(values(s, *source("morph-normal:" + name)), 3);
        if (const GltfSource* color = withColors ? source("morph-color:" + name) : nullptr)
            target["COLOR_0"] = addFloats(values(s, *color), color->components);
        all.push_back(std::move(target));
    }
    return all;
}

size_t MeshWriter::positions(const GltfSplit& s, json& attributes)
{
    Array<float> out(3 * s.vertex.size());
    for (size_t i = 0; i < s.vertex.size(); ++i)
        for (int k = 0; k < 3; ++k) out[3 * i + size_t(k)] = finite(mesh_.positions()[s.vertex[i]][k]);
    return attributes["POSITION"] = addFloats(out, 3, true);
}

// Always of unit length: where there is none, that of the surface, and where there is no surface, up.
Array<float> MeshWriter::normals(const GltfSplit& s) const
{
    const GltfSource* from = source("NORMAL");
    Array<float> out(3 * s.vertex.size());
    for (size_t i = 0; i < s.vertex.size(); ++i) {
        glm::dvec3 n(0);
        if (from && usable(s, *from))
            for (int k = 0; k < 3; ++k) n[k] = double(from->values[3 * element(s, *from, i) + size_t(k)]);
        double length = glm::length(n);
        if (!(length > 1e-12) || !std::isfinite(length)) {
            n = glm::dvec3(mesh_.vertexNormals()[s.vertex[i]]);
            length = glm::length(n);
        }
        if (!(length > 1e-12) || !std::isfinite(length)) {
            n = {0, 1, 0};
            length = 1;
        }
        for (int k = 0; k < 3; ++k) out[3 * i + size_t(k)] = float(n[k] / length);
    }
    return out;
}

// Unit, at right angles to the normal, w = 1 or -1. A mesh without tangents gets those along u of the set that the normal map uses.
Array<float> MeshWriter::tangents(const GltfSplit& s, std::span<const float> normals, const GltfSlot& slot) const
{
    const size_t n = s.vertex.size();
    std::vector<glm::dvec3> along(n, glm::dvec3(0)), across(n, glm::dvec3(0));
    const GltfSource* from = source("TANGENT");
    std::vector<double> sign(n, 1);
    if (from && usable(s, *from)) {
        for (size_t i = 0; i < n; ++i) {
            for (int k = 0; k < 3; ++k) along[i][k] = double(finite(from->values[4 * element(s, *from, i) + size_t(k)]));
            sign[i] = from->values[4 * element(s, *from, i) + 3] < 0 ? -1 : 1;
        }
    } else {
        const Array<float> uv = texcoords(s, slot.tangentSet);
        for (size_t i = 0; i + 2 < s.sequence.size(); i += 3) {
            const uint32_t* p = s.sequence.data() + i;
            const auto at = [&](int k) { return glm::dvec3(mesh_.positions()[s.vertex[p[k]]]); };
            const auto st = [&](int k) { return glm::dvec2(double(uv[2 * p[k]]), double(uv[2 * p[k] + 1])); };
            const glm::dvec3 e1 = at(1) - at(0), e2 = at(2) - at(0);
            const glm::dvec2 d1 = st(1) - st(0), d2 = st(2) - st(0);
            const double turn = d1.x * d2.y - d2.x * d1.y < 0 ? -1 : 1;
            for (int k = 0; k < 3; ++k) {
                along[p[k]] += (e1 * d2.y - e2 * d1.y) * turn;
                across[p[k]] += (e2 * d1.x - e1 * d2.x) * turn;
            }
        }
    }
    Array<float> out(4 * n);
    for (size_t i = 0; i < n; ++i) {
        const glm::dvec3 up{normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
        glm::dvec3 t = along[i] - up * glm::dot(up, along[i]);
        if (!(glm::length(t) > 1e-12 * glm::length(along[i])) || !std::isfinite(glm::length(t)))
            t = glm::cross(up, std::abs(up.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        t = glm::normalize(t);
        // The bitangent points up in the picture, and v of the file grows downwards.
        const double w = from && usable(s, *from) ? sign[i] : glm::dot(glm::cross(up, t), across[i]) > 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) out[4 * i + size_t(k)] = float(t[k]);
        out[4 * i + 3] = float(w);
    }
    return out;
}

Array<float> MeshWriter::texcoords(const GltfSplit& s, int set) const
{
    const GltfSource* from = source("TEXCOORD_" + std::to_string(set));
    if (!from || !usable(s, *from)) return Array<float>(2 * s.vertex.size(), 0.f);
    Array<float> out = values(s, *from);
    for (size_t i = 1; i < out.size(); i += 2) out[i] = 1 - out[i];  // v down
    return out;
}

Array<float> MeshWriter::values(const GltfSplit& s, const GltfSource& from) const
{
    const size_t n = size_t(from.components);
    Array<float> out(n * s.vertex.size());
    for (size_t i = 0; i < s.vertex.size(); ++i)
        for (size_t k = 0; k < n; ++k) out[i * n + k] = finite(from.values[element(s, from, i) * n + k]);
    return out;
}

// 8 bits where the file had 8 bits and they still say it exactly, else floats; always from 0 to 1.
size_t MeshWriter::addColor(const GltfSplit& s, const GltfSource& from)
{
    Array<float> colors = values(s, from);
    bool bytes = from.stored == Scalar::UInt8;
    for (float& c : colors) {
        c = std::clamp(c, 0.f, 1.f);
        bytes = bytes && std::abs(c * 255 - std::round(c * 255)) < 0.01f;
    }
    if (!bytes) return addFloats(colors, from.components);
    const size_t n = size_t(from.components), count = colors.size() / n;
    std::vector<uint8_t> packed(4 * count, 0);  // elements start at multiples of 4
    for (size_t i = 0; i < colors.size(); ++i) packed[i / n * 4 + i % n] = uint8_t(std::lround(colors[i] * 255));
    const size_t view = builder_.addView(packed, vertexTarget, 4);
    return builder_.append("accessors",
                           {{"bufferView", view}, {"componentType", byteType}, {"normalized", true}, {"count", count}, {"type", vectorType[n]}});
}

size_t MeshWriter::addFloats(std::span<const float> values, int components, bool bounds)
{
    const size_t n = size_t(components), count = values.size() / n;
    const size_t view = builder_.addView({reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()}, vertexTarget);
    json accessor{{"bufferView", view}, {"componentType", floatType}, {"count", count}, {"type", vectorType[n]}};
    for (size_t k = 0; bounds && k < n; ++k) {
        float low = values[k], high = values[k];
        for (size_t i = k; i < values.size(); i += n) {
            low = std::min(low, values[i]);
            high = std::max(high, values[i]);
        }
        accessor["min"].push_back(low);
        accessor["max"].push_back(high);
    }
    return builder_.append("accessors", std::move(accessor));
}

size_t MeshWriter::addIndices(const GltfSplit& s)
{
    const bool small = s.vertex.size() <= 65535;  // 65535 itself would restart the primitive
    size_t view;
    if (small) {
        const std::vector<uint16_t> narrow(s.sequence.begin(), s.sequence.end());
        view = builder_.addView({reinterpret_cast<const uint8_t*>(narrow.data()), narrow.size() * 2}, indexTarget);
    } else {
        view = builder_.addView({reinterpret_cast<const uint8_t*>(s.sequence.data()), s.sequence.size() * 4}, indexTarget);
    }
    return builder_.append(
        "accessors", {{"bufferView", view}, {"componentType", small ? shortType : intType}, {"count", s.sequence.size()}, {"type", vectorType[1]}});
}

}  // namespace

json gltfMeshOf(GltfBuilder& builder, const Mesh& mesh, const GltfMeshUse& use, std::vector<Warning>& warnings, Progress* progress)
{
    return MeshWriter(builder, mesh, use, warnings).write(progress);
}

}  // namespace mw
