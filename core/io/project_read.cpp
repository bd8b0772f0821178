// Reading MESHWRIGHT_project: as suspicious of every number as of any other file.
#include <cmath>
#include <cstring>
#include <limits>

#include "core/io/project.h"

namespace mw {

namespace {

constexpr uint32_t greatestId = 0x7FFFFFFF;

double exactNumber(const JsonPlace& place)
{
    if (!place.value().is_string()) return place.number();
    const std::string& word = place.text();
    if (word != "inf" && word != "-inf" && word != "nan") place.fail("is no number");
    constexpr double inf = std::numeric_limits<double>::infinity();
    return word == "nan" ? std::numeric_limits<double>::quiet_NaN() : word == "inf" ? inf : -inf;
}

template <int N, class Vector>
void exactNumbers(const JsonPlace& place, Vector& to)
{
    if (place.size() != N) place.fail("must have " + std::to_string(N) + " numbers");
    for (int i = 0; i < N; ++i) to[i] = exactNumber(place[size_t(i)]);
}

uint32_t idOf(const JsonPlace& place)
{
    const uint64_t id = place.whole();
    if (id > greatestId) place.fail("is too large for a name of a thing");
    return uint32_t(id);
}

/// 0 when it is not there.
uint32_t idOf(const JsonPlace& owner, const char* key)
{
    const auto place = owner.find(key);
    return place ? idOf(*place) : 0;
}

class ProjectReader {
public:
    explicit ProjectReader(GltfDocument& document) : document_(document), top_(document.root()["extensions"][projectExtension]) {}
    Scene read();

private:
    template <class T>
    Array<T> array(const JsonPlace& owner, const char* key);
    Mesh mesh(const JsonPlace& place);
    Attribute attribute(const JsonPlace& place, const Mesh& mesh);
    MeshObject object(const JsonPlace& place);
    Modifier modifier(const JsonPlace& place);
    ParameterValues values(const JsonPlace& place);
    ParameterValue value(const JsonPlace& place);
    Material material(const JsonPlace& place);
    Material::Texture texture(const JsonPlace& place);
    Image image(const JsonPlace& place);
    Skin skin(const JsonPlace& place);
    Clip clip(const JsonPlace& place);
    std::shared_ptr<const Channel> channel(const JsonPlace& place);
    Shared<double> numbers(const JsonPlace& owner, const char* key);
    TerrainObject terrain(const JsonPlace& place);
    HeightMap heightMap(const JsonPlace& place);
    void readNodes();
    /// Calls `make` for each entry of a list; keeps the results by their ids.
    template <class Id, class T, class Make>
    void list(const char* key, std::map<Id, T>& to, Make make)
    {
        const auto entries = top_.find(key);
        for (size_t i = 0; entries && i < entries->size(); ++i) {
            const JsonPlace place = (*entries)[i];
            const Id id{idOf(place["id"])};
            document_.charge(512, place.pointer());
            if (!id || !to.emplace(id, make(place)).second) place.fail("its id is 0 or taken");
        }
    }

    GltfDocument& document_;
    JsonPlace top_;
    Scene::Parts parts_;
    std::map<uint32_t, Shared<double>> numbers_;  // by view
};

Scene ProjectReader::read()
{
    if (const uint64_t version = top_["version"].whole(); version < 1 || version > projectVersion)
        top_["version"].fail("was saved by a newer Meshwright; open it with that one");
    list("images", parts_.images, [&](const JsonPlace& p) { return image(p); });
    list("materials", parts_.materials, [&](const JsonPlace& p) { return material(p); });
    list("meshes", parts_.meshes, [&](const JsonPlace& p) { return object(p); });
    list("skins", parts_.skins, [&](const JsonPlace& p) { return skin(p); });
    list("clips", parts_.clips, [&](const JsonPlace& p) { return clip(p); });
    list("terrains", parts_.terrains, [&](const JsonPlace& p) { return terrain(p); });
    readNodes();
    return Scene::restored(std::move(parts_));
}

template <class T>
Array<T> ProjectReader::array(const JsonPlace& owner, const char* key)
{
    const auto view = owner.index(key, document_.views(), "buffer view");
    if (!view) return {};
    const auto bytes = document_.viewBytes(*view);
    if (bytes.size() % sizeof(T)) owner[key].fail("its buffer view has a part of an element; the file is damaged");
    document_.charge(bytes.size(), owner.pointer());
    Array<T> out(bytes.size() / sizeof(T));
    if (!out.empty()) std::memcpy(static_cast<void*>(out.data()), bytes.data(), bytes.size());
    return out;
}

Mesh ProjectReader::mesh(const JsonPlace& place)
{
    const auto check = [&](bool good, const char* what) {
        if (!good) place.fail(std::string(what) + "; the file is damaged");
    };
    Array<glm::vec3> positions = array<glm::vec3>(place, "positions");
    Array<uint32_t> start = array<uint32_t>(place, "faceStart"), corners = array<uint32_t>(place, "cornerVertex"),
                    lines = array<uint32_t>(place, "lines");
    const auto inRange = [&](const Array<uint32_t>& a) { return std::all_of(a.begin(), a.end(), [&](uint32_t v) { return v < positions.size(); }); };
    check(positions.size() < none && corners.size() < none, "more elements than 32 bits can number");
    check(std::all_of(positions.begin(), positions.end(), [](glm::vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }),
          "a position is no number");
    check(inRange(corners) && inRange(lines), "a face or line uses a vertex that is not there");
    check(lines.size() % 2 == 0, "half a line");
    Mesh m;
    if (place.flag("triangles", false)) {
        check(corners.size() % 3 == 0, "a part of a triangle");
        document_.charge(corners.size() * 2, place.pointer());
        m = Mesh::triangles(std::move(positions), std::move(corners));
    } else {
        check(start.empty() ? corners.empty() : start.front() == 0 && start.back() == corners.size() && std::is_sorted(start.begin(), start.end()),
              "face offsets do not ascend from 0 to the number of corners");
        m = Mesh(std::move(positions), std::move(start), std::move(corners));
    }
    return lines.empty() ? m : m.withLines(std::move(lines));
}

Attribute ProjectReader::attribute(const JsonPlace& place, const Mesh& mesh)
{
    Attribute a;
    a.name = place["name"].text();
    a.domain = Domain(place["domain"].index(3, "domain"));
    a.stored = Scalar(place["stored"].index(8, "number type"));
    a.components = int(place["components"].index(4097, "number of components"));
    const std::string& type = place["type"].text();
    size_t numbers = 0;
    const auto take = [&]<class T>(T*) {
        Array<T> values = array<T>(place, "view");
        numbers = values.size();
        a.values = Shared<T>(std::move(values));
    };
    if (type == "f32")
        take(static_cast<float*>(nullptr));
    else if (type == "f64")
        take(static_cast<double*>(nullptr));
    else if (type == "i32")
        take(static_cast<int32_t*>(nullptr));
    else
        place["type"].fail("is not known");
    if (a.components < 1 || numbers != mesh.count(a.domain) * size_t(a.components))
        place.fail(std::to_string(numbers) + " numbers, but " + std::to_string(mesh.count(a.domain)) + " elements; the file is damaged");
    return a;
}

MeshObject ProjectReader::object(const JsonPlace& place)
{
    MeshObject o;
    o.name = place["name"].text();
    o.base = mesh(place);
    if (const auto list = place.find("attributes"))
        for (size_t i = 0; i < list->size(); ++i) {
            if (i >= 1000) list->fail("too many attributes; the file is damaged");
            o.base = o.base.with(attribute((*list)[i], o.base));
        }
    if (const auto groups = place.find("groups")) {
        std::vector<std::string> names;
        for (size_t i = 0; i < groups->size(); ++i) names.push_back((*groups)[i].text());
        o.base = o.base.withGroupNames(std::move(names));
    }
    if (const auto list = place.find("materials"))
        for (size_t i = 0; i < list->size(); ++i) o.materials.push_back({idOf((*list)[i])});
    if (const auto list = place.find("stack"))
        for (size_t i = 0; i < list->size(); ++i) o.stack.push_back(modifier((*list)[i]));
    return o;
}

Modifier ProjectReader::modifier(const JsonPlace& place)
{
    Modifier m;
    m.id = {idOf(place["id"])};
    m.operation = place["operation"].text();
    m.enabled = place["enabled"].flag();
    m.values = values(place["values"]);
    return m;
}

ParameterValues ProjectReader::values(const JsonPlace& place)
{
    ParameterValues out;
    if (!place.value().is_object()) place.fail("must be an object");
    for (const auto& item : place.value().items()) out[item.key()] = value(place[item.key().c_str()]);
    return out;
}

// The JSON type says the type: modifiers of operations that this version does not know keep their parameters, too.
ParameterValue ProjectReader::value(const JsonPlace& place)
{
    const nlohmann::json& v = place.value();
    if (v.is_boolean()) return v.get<bool>();
    if (v.is_number_integer()) return v.get<int64_t>();
    if (v.is_number_float()) return v.get<double>();
    if (v.is_string()) return v.get<std::string>();
    if (v.is_object()) return exactNumber(place["number"]);
    glm::dvec3 point;
    exactNumbers<3>(place, point);
    return point;
}

Material::Texture ProjectReader::texture(const JsonPlace& place)
{
    return {{idOf(place["image"])}, int(place["set"].index(1000, "set")), place["repeat"].flag()};
}

Material ProjectReader::material(const JsonPlace& place)
{
    Material m;
    m.name = place["name"].text();
    exactNumbers<4>(place["baseColor"], m.baseColor);
    exactNumbers<3>(place["emissive"], m.emissive);
    m.metallic = exactNumber(place["metallic"]);
    m.roughness = exactNumber(place["roughness"]);
    m.normalScale = exactNumber(place["normalScale"]);
    m.occlusionStrength = exactNumber(place["occlusionStrength"]);
    m.alphaCutoff = exactNumber(place["alphaCutoff"]);
    m.alpha = Material::Alpha(place["alpha"].index(3, "mode"));
    m.doubleSided = place["doubleSided"].flag();
    m.baseColorTexture = texture(place["baseColorTexture"]);
    m.metallicRoughnessTexture = texture(place["metallicRoughnessTexture"]);
    m.normalTexture = texture(place["normalTexture"]);
    m.occlusionTexture = texture(place["occlusionTexture"]);
    m.emissiveTexture = texture(place["emissiveTexture"]);
    m.extras = place["extras"].text();
    return m;
}

Image ProjectReader::image(const JsonPlace& place)
{
    Image i;
    i.name = place["name"].text();
    i.mimeType = place["mimeType"].text();
    const auto view = place.index("view", document_.views(), "buffer view");
    if (!view) return i;
    const auto bytes = document_.viewBytes(*view);
    document_.charge(bytes.size(), place.pointer());
    i.bytes = std::make_shared<const std::vector<uint8_t>>(bytes.begin(), bytes.end());
    return i;
}

Skin ProjectReader::skin(const JsonPlace& place)
{
    Skin s;
    s.name = place["name"].text();
    s.skeleton = {idOf(place["skeleton"])};
    const JsonPlace joints = place["joints"];
    document_.charge(joints.size() * sizeof(NodeId), place.pointer());
    for (size_t i = 0; i < joints.size(); ++i) s.joints.push_back({idOf(joints[i])});
    const Array<glm::dmat4> matrices = array<glm::dmat4>(place, "inverseBind");
    s.inverseBind.assign(matrices.begin(), matrices.end());
    return s;
}

Shared<double> ProjectReader::numbers(const JsonPlace& owner, const char* key)
{
    const auto view = owner.index(key, document_.views(), "buffer view");
    if (!view) return {};
    const auto [known, fresh] = numbers_.try_emplace(*view);
    if (fresh) known->second = array<double>(owner, key);
    return known->second;
}

std::shared_ptr<const Channel> ProjectReader::channel(const JsonPlace& place)
{
    Channel c;
    document_.charge(sizeof c, place.pointer());
    c.node = {idOf(place["node"])};
    c.path = Channel::Path(place["path"].index(10, "path"));
    c.interpolation = Channel::Interpolation(place["interpolation"].index(3, "interpolation"));
    c.components = int(place["components"].index(1u << 24, "number of components"));
    c.times = numbers(place, "times");
    c.values = numbers(place, "values");
    const int fixed = c.path == Channel::Path::Rotation ? 4 : c.path < Channel::Path::Weights ? 3 : c.path > Channel::Path::Weights ? 1 : 0;
    const size_t perKey = size_t(c.components) * (c.interpolation == Channel::Interpolation::Cubic ? 3 : 1);
    if (c.components < 1 || (fixed && c.components != fixed) || c.values.size() != c.keys() * perKey)
        place.fail("its numbers do not fit its path and keys; the file is damaged");
    for (size_t i = 0; i < c.keys(); ++i)
        if (!(c.times[i] >= (i ? c.times[i - 1] : 0)) || !std::isfinite(c.times[i])) place.fail("its times do not ascend; the file is damaged");
    return std::make_shared<const Channel>(std::move(c));
}

Clip ProjectReader::clip(const JsonPlace& place)
{
    Clip c;
    c.name = place["name"].text();
    c.frameTime = exactNumber(place["frameTime"]);
    const JsonPlace channels = place["channels"];
    for (size_t i = 0; i < channels.size(); ++i) c.channels.push_back(channel(channels[i]));
    return c;
}

HeightMap ProjectReader::heightMap(const JsonPlace& place)
{
    const uint32_t width = place["width"].index(HeightMap::largestSize + 1, "width"),
                   height = place["height"].index(HeightMap::largestSize + 1, "height");
    const Array<float> heights = array<float>(place, "heights");
    if (heights.size() != size_t(width) * height || (width == 0) != (height == 0) || width == 1 || height == 1)
        place.fail(std::to_string(heights.size()) + " heights for a map of " + std::to_string(width) + " by " + std::to_string(height) +
                   "; the file is damaged");
    if (!std::all_of(heights.begin(), heights.end(), [](float h) { return std::isfinite(h); }))
        place.fail("a height is no number; the file is damaged");
    constexpr uint32_t tile = HeightMap::tileSize;
    document_.charge(uint64_t((width + tile - 1) / tile * tile) * ((height + tile - 1) / tile * tile) * sizeof(float), place.pointer());
    return heights.empty() ? HeightMap() : HeightMap(width, height, heights);
}

TerrainObject ProjectReader::terrain(const JsonPlace& place)
{
    TerrainObject o;
    Terrain& t = o.terrain;
    t.name = place["name"].text();
    t.map = heightMap(place);
    t.extent = exactNumber(place["extent"]);
    t.maximumHeight = exactNumber(place["maximumHeight"]);
    t.waterLevel = exactNumber(place["waterLevel"]);
    const JsonPlace detail = place["detail"], layers = place["layers"];
    t.detail.patches = int(detail["patches"].index(1 << 20, "number of patches"));
    t.detail.nearLevel = exactNumber(detail["nearLevel"]);
    t.detail.farLevel = exactNumber(detail["farLevel"]);
    t.detail.nearDistance = exactNumber(detail["nearDistance"]);
    t.detail.farDistance = exactNumber(detail["farDistance"]);
    t.detail.corrected = detail["corrected"].flag();
    t.layers.sandTo = exactNumber(layers["sandTo"]);
    t.layers.grassTo = exactNumber(layers["grassTo"]);
    t.layers.snowFrom = exactNumber(layers["snowFrom"]);
    t.layers.rockSlope = exactNumber(layers["rockSlope"]);
    o.sourceOperation = place["sourceOperation"].text();
    o.sourceValues = values(place["sourceValues"]);
    return o;
}

void ProjectReader::readNodes()
{
    std::map<NodeId, NodeId> parents;
    list("nodes", parts_.nodes, [&](const JsonPlace& place) {
        Node n;
        n.name = place["name"].text();
        exactNumbers<3>(place["translation"], n.local.translation);
        exactNumbers<3>(place["scale"], n.local.scale);
        glm::dvec4 q;
        exactNumbers<4>(place["rotation"], q);
        n.local.rotation = glm::dquat(q.w, q.x, q.y, q.z);
        n.visible = place["visible"].flag();
        n.mesh = {idOf(place["mesh"])};
        n.extras = place.text("extras");
        n.skin = {idOf(place, "skin")};
        n.terrain = {idOf(place, "terrain")};
        n.joint = Node::Joint(place.index("joint", 3, "kind of joint").value_or(0));
        const size_t weights = place.sizeOf("morphWeights");
        for (size_t w = 0; w < weights; ++w) n.morphWeights.push_back(exactNumber(place["morphWeights"][w]));
        const NodeId id{idOf(place["id"])};
        for (size_t c = 0; c < place.sizeOf("children"); ++c) {
            n.children.push_back({idOf(place["children"][c])});
            if (!parents.emplace(n.children.back(), id).second) place.fail("a child of it has two parents; the file is damaged");
        }
        return n;
    });
    for (const auto& [child, parent] : parents) {
        const auto n = parts_.nodes.find(child);
        if (n == parts_.nodes.end()) top_.fail("node " + std::to_string(child.value) + " is not there; the file is damaged");
        n->second.parent = parent;
    }
    const auto roots = top_.find("roots");
    for (size_t i = 0; roots && i < roots->size(); ++i) {
        parts_.roots.push_back({idOf((*roots)[i])});
        if (parents.contains(parts_.roots.back())) (*roots)[i].fail("is no root; the file is damaged");
    }
}

}  // namespace

Scene readProject(GltfDocument& document)
{
    return ProjectReader(document).read();
}

}  // namespace mw
