#include "core/io/gltf_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "core/io/gltf_points.h"

namespace mw {

namespace {

enum Mode { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

Scalar scalarOf(GltfComponent c)
{
    switch (c) {
        case GltfComponent::Int8:
            return Scalar::Int8;
        case GltfComponent::UInt8:
            return Scalar::UInt8;
        case GltfComponent::Int16:
            return Scalar::Int16;
        case GltfComponent::UInt16:
            return Scalar::UInt16;
        case GltfComponent::UInt32:
            return Scalar::UInt32;
        case GltfComponent::Float32:
            return Scalar::Float32;
    }
    return Scalar::Float32;
}

// "TEXCOORD_3" with prefix "TEXCOORD_" is 3; -1 when it is none.
int setOf(const std::string& semantic, std::string_view prefix)
{
    if (!semantic.starts_with(prefix) || semantic.size() == prefix.size() || semantic.size() > prefix.size() + 2) return -1;
    int set = 0;
    for (const char c : semantic.substr(prefix.size())) {
        if (c < '0' || c > '9') return -1;
        set = set * 10 + (c - '0');
    }
    return set < 32 ? set : -1;
}

class MeshReader {
public:
    MeshReader(GltfDocument& document, const JsonPlace& place) : document_(document), place_(place) { nameTargets(); }
    GltfMesh read(Progress* progress);

private:
    // A primitive being read: the elements of its accessors that it uses, and its points.
    struct Primitive {
        JsonPlace place;
        Mode mode = Triangles;
        const GltfAccessor* positions = nullptr;
        size_t count = 0, firstPoint = 0;  // of its accessors; of its own points
        Array<uint32_t> elements;          // used ones, ascending
        Array<uint32_t> sequence;          // points in the order of drawing
    };
    void nameTargets();
    void readPrimitive(const JsonPlace& place);
    void findElements(Primitive& p);
    void readPositions(const Primitive& p, const GltfAccessor& a);
    void readAttribute(const Primitive& p, const std::string& semantic, const JsonPlace& place);
    void readTargets(const Primitive& p);
    GltfStream* stream(const Primitive& p, const std::string& name, const GltfAccessor& a, int least, int most);
    void take(const Primitive& p, GltfStream& s, const GltfAccessor& a);
    void fillUp();
    void fillNormals(const Primitive& p);
    uint32_t slotOf(const Primitive& p);
    void emit(const Primitive& p);
    void emitTriangle(const Primitive& p, size_t a, size_t b, size_t c, uint32_t slot);
    void joinSkin();
    void warn(const char* code, const std::string& text)
    {
        if (told_.insert(code).second) document_.warnings().push_back({code, text, {}});
    }
    const GltfAccessor& accessorAt(const JsonPlace& place) const { return document_.accessor(place.index(document_.accessors(), "accessor")); }

    GltfDocument& document_;
    JsonPlace place_;
    GltfPoints out_;
    std::vector<std::string> targets_;
    std::vector<std::optional<uint32_t>> slots_;
    std::set<std::string> told_;
    std::map<const GltfAccessor*, std::vector<bool>> used_;  // elements of position accessors
};

// Names of morph targets lie in the extras of the mesh, by a custom all programs follow.
void MeshReader::nameTargets()
{
    size_t count = 0;
    const JsonPlace primitives = place_["primitives"];
    for (size_t i = 0; i < primitives.size(); ++i) count = std::max(count, primitives[i].sizeOf("targets"));
    const auto& mesh = place_.value();
    std::set<std::string> taken;
    for (size_t t = 0; t < count; ++t) {
        std::string name = "target" + std::to_string(t);
        if (const auto extras = mesh.find("extras"); extras != mesh.end() && extras->is_object())
            if (const auto list = extras->find("targetNames");
                list != extras->end() && list->is_array() && t < list->size() && (*list)[t].is_string())
                name = (*list)[t].get<std::string>();
        while (name.empty() || !taken.insert(name).second) name += "_" + std::to_string(t);
        targets_.push_back(name);
    }
    // All of them from the start: their order is that of the weights, whatever the primitives have.
    document_.charge(count * (sizeof(GltfStream) + 64), place_.pointer());
    for (const std::string& name : targets_) {
        GltfStream s;
        s.name = "morph:" + name;
        s.components = 3;
        s.ofVertex = true;
        out_.streams.push_back(std::move(s));
    }
}

GltfMesh MeshReader::read(Progress* progress)
{
    const JsonPlace primitives = place_["primitives"];
    for (size_t i = 0; i < primitives.size(); ++i) {
        readPrimitive(primitives[i]);
        if (progress) progress->at(progress->fraction);
    }
    joinSkin();
    size_t unused = 0;
    for (const auto& [accessor, used] : used_) unused += size_t(std::count(used.begin(), used.end(), false));
    if (unused)
        document_.warnings().push_back(
            {"unused-vertices", place_.pointer() + ": " + std::to_string(unused) + " vertices that no primitive uses were left out", {}});
    GltfMesh result{meshOf(std::move(out_), document_, place_.pointer()), std::move(slots_)};
    if (std::none_of(result.materials.begin(), result.materials.end(), [](const auto& m) { return m.has_value(); })) result.materials.clear();
    return result;
}

void MeshReader::readPrimitive(const JsonPlace& place)
{
    Primitive p{place, Triangles, nullptr, 0, out_.positions.size(), {}, {}};
    const uint64_t mode = place.whole("mode", Triangles);
    if (mode > TriangleFan) place["mode"].fail("there is no mode " + std::to_string(mode) + "; the file is damaged");
    p.mode = Mode(mode);
    const JsonPlace attributes = place["attributes"];
    if (!attributes.has("POSITION")) {
        warn("no-position", place.pointer() + ": a primitive without positions was left out");
        return;
    }
    if (const auto extensions = place.find("extensions"); extensions && extensions->has("KHR_draco_mesh_compression"))
        warn("draco", place.pointer() + ": the compressed copy of its data was not read");
    p.positions = &accessorAt(attributes["POSITION"]);
    p.count = p.positions->count;
    findElements(p);
    readPositions(p, *p.positions);
    for (const auto& item : attributes.value().items())
        if (item.key() != "POSITION") readAttribute(p, item.key(), attributes[item.key().c_str()]);
    readTargets(p);
    fillUp();
    fillNormals(p);
    emit(p);
}

// Only what indices name becomes points: files that share one large vertex buffer between many meshes cost no more than their faces.
void MeshReader::findElements(Primitive& p)
{
    const auto indices = p.place.find("indices");
    if (!indices) {
        document_.charge(p.count * 8, p.place.pointer());
        p.elements.resize(p.count);
        for (size_t i = 0; i < p.count; ++i) p.elements[i] = uint32_t(i);
        p.sequence = p.elements;
    } else {
        p.sequence = document_.indices(accessorAt(*indices));
        for (size_t i = 0; i < p.sequence.size(); ++i)
            if (p.sequence[i] >= p.count)
                indices->fail("entry " + std::to_string(i) + " is vertex " + std::to_string(p.sequence[i]) + " of " + std::to_string(p.count) +
                              "; the file is damaged, export it again");
        if (p.count > 16 * p.sequence.size() + 1024) {
            p.elements = p.sequence;
            std::sort(p.elements.begin(), p.elements.end());
            p.elements.erase(std::unique(p.elements.begin(), p.elements.end()), p.elements.end());
            for (uint32_t& s : p.sequence) s = uint32_t(std::lower_bound(p.elements.begin(), p.elements.end(), s) - p.elements.begin());
        } else {
            Array<uint32_t> rank(p.count, none);
            for (const uint32_t s : p.sequence) rank[s] = 0;
            for (size_t e = 0; e < p.count; ++e)
                if (rank[e] == 0) {
                    rank[e] = uint32_t(p.elements.size());
                    p.elements.push_back(uint32_t(e));
                }
            for (uint32_t& s : p.sequence) s = rank[s];
            std::vector<bool>& used = used_[p.positions];
            used.resize(p.count, false);
            for (const uint32_t e : p.elements) used[e] = true;
        }
    }
    if (p.firstPoint + p.elements.size() >= none) p.place.fail("more vertices than 32 bits can number; split the mesh");
    for (uint32_t& s : p.sequence) s += uint32_t(p.firstPoint);
}

void MeshReader::readPositions(const Primitive& p, const GltfAccessor& a)
{
    if (a.components != 3) p.place.fail("POSITION must be of type VEC3");
    const Array<float> values = document_.floats(a, p.elements);
    size_t mended = 0;
    out_.positions.resize(p.firstPoint + p.elements.size());
    for (size_t i = 0; i < p.elements.size(); ++i) {
        glm::vec3& to = out_.positions[p.firstPoint + i];
        bool odd = false;
        for (int k = 0; k < 3; ++k) {
            const float x = values[3 * i + size_t(k)];
            odd = odd || !std::isfinite(x);
            to[k] = std::isfinite(x) ? x + 0.f : 0.f;  // -0 becomes 0: equal places are equal bytes
        }
        mended += odd;
    }
    if (mended)
        document_.warnings().push_back(
            {"nan-position", a.pointer + ": " + std::to_string(mended) + " positions are no numbers; such coordinates were set to 0", {}});
}

// The stream of that name, begun if it is the first; null (and a warning) when the accessor does not fit it.
GltfStream* MeshReader::stream(const Primitive& p, const std::string& name, const GltfAccessor& a, int least, int most)
{
    const auto refuse = [&] {
        warn("bad-attribute", a.pointer + ": its type or count does not fit \"" + name + "\"; that attribute was left out");
        return nullptr;
    };
    if (a.count != p.count || a.components < least || a.components > most) return refuse();
    for (GltfStream& s : out_.streams)
        if (s.name == name) return s.components == a.components ? &s : refuse();
    GltfStream s;
    s.name = name;
    s.components = a.components;
    s.stored = scalarOf(a.component);
    out_.streams.push_back(std::move(s));
    return &out_.streams.back();
}

void MeshReader::take(const Primitive& p, GltfStream& s, const GltfAccessor& a)
{
    const size_t begin = p.firstPoint * size_t(s.components);
    if (s.integral) {
        const Array<int32_t> values = document_.integers(a, p.elements);
        s.integers.resize(begin, int32_t(s.fill));
        s.integers.insert(s.integers.end(), values.begin(), values.end());
        return;
    }
    const Array<float> values = document_.floats(a, p.elements);
    s.floats.resize(begin, s.fill);
    s.floats.reserve(begin + values.size());
    size_t odd = 0;
    for (const float x : values) {
        odd += !std::isfinite(x);
        s.floats.push_back(std::isfinite(x) ? x + 0.f : 0.f);
    }
    if (odd) warn("nan-attribute", a.pointer + ": " + std::to_string(odd) + " values are no numbers; they were set to 0");
}

void MeshReader::readAttribute(const Primitive& p, const std::string& semantic, const JsonPlace& place)
{
    const GltfAccessor& a = accessorAt(place);
    const auto numbered = [](std::string_view name, int set) { return std::string(name) + (set ? std::to_string(set) : ""); };
    if (semantic == "NORMAL") {
        if (auto* s = stream(p, std::string(names::normal), a, 3, 3)) take(p, *s, a);
    } else if (semantic == "TANGENT") {
        if (auto* s = stream(p, std::string(names::tangent), a, 4, 4)) take(p, *s, a);
    } else if (const int uv = setOf(semantic, "TEXCOORD_"); uv >= 0) {
        auto* s = stream(p, numbered(names::texcoord, uv), a, 2, 2);
        if (!s) return;
        take(p, *s, a);
        for (size_t i = 2 * p.firstPoint + 1; i < s->floats.size(); i += 2) s->floats[i] = 1 - s->floats[i];  // ours has v up
    } else if (const int set = setOf(semantic, "COLOR_"); set >= 0) {
        auto* s = stream(p, numbered(names::color, set), a, 3, 4);
        if (!s) return;
        s->fill = 1;
        take(p, *s, a);
    } else if (const bool joints = setOf(semantic, "JOINTS_") >= 0; joints || setOf(semantic, "WEIGHTS_") >= 0) {
        auto* s = stream(p, semantic, a, 4, 4);
        if (!s) return;
        s->ofVertex = true;
        s->integral = joints;
        take(p, *s, a);
    } else if (semantic.starts_with("_")) {
        auto* s = stream(p, semantic, a, 1, 4);
        if (!s) return;
        if (p.firstPoint == 0) s->integral = a.component != GltfComponent::Float32 && !a.normalized;
        take(p, *s, a);
    } else {
        warn("unknown-attribute", place.pointer() + ": \"" + semantic.substr(0, 40) + "\" is not known and was left out");
    }
}

void MeshReader::readTargets(const Primitive& p)
{
    const auto targets = p.place.find("targets");
    if (!targets) return;
    for (size_t t = 0; t < targets->size(); ++t) {
        const JsonPlace target = (*targets)[t];
        for (const auto& item : target.value().items()) {
            const bool position = item.key() == "POSITION", color = item.key() == "COLOR_0";
            if (!position && !color && item.key() != "NORMAL") {
                warn("morph-attribute", target.pointer() + ": \"" + item.key().substr(0, 40) + "\" of morph targets was left out");
                continue;
            }
            const GltfAccessor& a = accessorAt(target[item.key().c_str()]);
            auto* s = stream(p, (position ? "morph:" : color ? "morph-color:" : "morph-normal:") + targets_[t], a, 3, color ? 4 : 3);
            if (!s) continue;
            s->ofVertex = position;
            take(p, *s, a);
        }
        if (!target.has("POSITION")) warn("morph-attribute", target.pointer() + ": a morph target without positions");
    }
}

// Streams that this primitive did not have are filled, so that all are as long as there are points.
void MeshReader::fillUp()
{
    for (GltfStream& s : out_.streams) {
        const size_t missing = out_.positions.size() - s.points();
        if (!missing) continue;
        document_.charge(missing * size_t(s.components) * 4, place_.pointer());
        if (s.integral)
            s.integers.resize(out_.positions.size() * size_t(s.components), int32_t(s.fill));
        else
            s.floats.resize(out_.positions.size() * size_t(s.components), s.fill);
    }
}

// A primitive without normals among others that have them: normals of its own faces.
void MeshReader::fillNormals(const Primitive& p)
{
    const bool has = p.place["attributes"].has("NORMAL");
    const auto s = std::find_if(out_.streams.begin(), out_.streams.end(), [](const GltfStream& x) { return x.name == names::normal; });
    if (has || s == out_.streams.end() || p.mode < Triangles) return;
    std::vector<glm::dvec3> sum(p.elements.size(), glm::dvec3(0));
    for (size_t i = 0; p.mode == Triangles && i + 2 < p.sequence.size(); i += 3) {
        const auto at = [&](size_t k) { return glm::dvec3(out_.positions[p.sequence[i + k]]); };
        const glm::dvec3 n = glm::cross(at(1) - at(0), at(2) - at(0));
        for (size_t k = 0; k < 3; ++k) sum[p.sequence[i + k] - p.firstPoint] += n;
    }
    for (size_t i = 0; i < sum.size(); ++i) {
        const double length = glm::length(sum[i]);
        const glm::dvec3 n = length > 0 && std::isfinite(length) ? sum[i] / length : glm::dvec3(0, 0, 1);
        for (int k = 0; k < 3; ++k) s->floats[(p.firstPoint + i) * 3 + size_t(k)] = float(n[k]);
    }
}

uint32_t MeshReader::slotOf(const Primitive& p)
{
    const auto material = p.place.index("material", document_.root().sizeOf("materials"), "material");
    const auto known = std::find(slots_.begin(), slots_.end(), material);
    if (known != slots_.end()) return uint32_t(known - slots_.begin());
    slots_.push_back(material);
    return uint32_t(slots_.size() - 1);
}

void MeshReader::emitTriangle(const Primitive& p, size_t a, size_t b, size_t c, uint32_t slot)
{
    for (const size_t i : {a, b, c}) out_.corners.push_back(p.sequence[i]);
    out_.faceMaterial.push_back(slot);
}

void MeshReader::emit(const Primitive& p)
{
    const Array<uint32_t>& s = p.sequence;
    const size_t n = s.size();
    if (p.mode == Points) out_.apart.emplace_back(uint32_t(p.firstPoint), uint32_t(out_.positions.size()));
    if (p.mode <= LineStrip) {
        const auto line = [&](size_t a, size_t b) { out_.lines.insert(out_.lines.end(), {s[a], s[b]}); };
        for (size_t i = 0; p.mode == Lines && i + 1 < n; i += 2) line(i, i + 1);
        for (size_t i = 0; p.mode >= LineLoop && i + 1 < n; ++i) line(i, i + 1);
        if (p.mode == LineLoop && n > 2) line(n - 1, 0);
        return;
    }
    const uint32_t slot = slotOf(p);
    document_.charge(n * 4, p.place.pointer());
    if (p.mode == Triangles) {
        if (n % 3) warn("left-over-indices", p.place.pointer() + ": the last " + std::to_string(n % 3) + " indices make no triangle");
        for (size_t i = 0; i + 2 < n; i += 3) emitTriangle(p, i, i + 1, i + 2, slot);
        return;
    }
    for (size_t i = 0; i + 2 < n; ++i) {
        const size_t a = p.mode == TriangleFan ? i + 1 : i, b = p.mode == TriangleFan ? i + 2 : i + 1 + i % 2,
                     c = p.mode == TriangleFan ? 0 : i + 2 - i % 2;
        // Strips are joined by triangles without area, which are no faces.
        if (s[a] != s[b] && s[b] != s[c] && s[c] != s[a]) emitTriangle(p, a, b, c, slot);
    }
}

// JOINTS_0, JOINTS_1, ... become one attribute of 4n components, weights likewise, summing to 1.
void MeshReader::joinSkin()
{
    std::vector<GltfStream*> joints, weights;
    for (int set = 0; set < 32; ++set)
        for (GltfStream& s : out_.streams) {
            if (s.name == "JOINTS_" + std::to_string(set)) joints.push_back(&s);
            if (s.name == "WEIGHTS_" + std::to_string(set)) weights.push_back(&s);
        }
    if (joints.size() == weights.size() && !joints.empty()) {
        const size_t sets = joints.size(), points = out_.positions.size();
        document_.charge(points * sets * 32, place_.pointer());
        GltfStream j, w;
        j.name = names::joints;
        w.name = names::weights;
        j.components = w.components = int(4 * sets);
        j.ofVertex = w.ofVertex = j.integral = true;
        j.stored = joints[0]->stored;
        w.stored = weights[0]->stored;
        // What bytes round to is no fault of the file.
        const double tolerated = weights[0]->stored == Scalar::UInt8 ? 0.02 : 1e-3;
        size_t mended = 0;
        for (size_t p = 0; p < points; ++p) {
            double sum = 0;
            for (size_t k = 0; k < 4 * sets; ++k) {
                j.integers.push_back(joints[k / 4]->integers[4 * p + k % 4]);
                w.floats.push_back(std::max(0.f, weights[k / 4]->floats[4 * p + k % 4]));
                sum += double(w.floats.back());
            }
            mended += std::abs(sum - 1) > tolerated;
            for (size_t k = 4 * sets * p; sum > 0 && std::abs(sum - 1) > 1e-6 && k < w.floats.size(); ++k)
                w.floats[k] = float(double(w.floats[k]) / sum);
        }
        if (mended)
            warn("weights-sum", place_.pointer() + ": the joint weights of " + std::to_string(mended) +
                                    " vertices did not sum to 1; they were divided by their sum, vertices without any do not move");
        out_.streams.push_back(std::move(j));
        out_.streams.push_back(std::move(w));
    } else if (!joints.empty() || !weights.empty()) {
        warn("half-skin", place_.pointer() + ": joints without weights, or weights without joints, were left out");
    }
    std::erase_if(out_.streams, [](const GltfStream& s) { return s.name.starts_with("JOINTS_") || s.name.starts_with("WEIGHTS_"); });
}

}  // namespace

GltfMesh gltfMesh(GltfDocument& document, const JsonPlace& place, Progress* progress)
{
    return MeshReader(document, place).read(progress);
}

}  // namespace mw
