// From a scene to what is drawn of it, and the range of a heat map.
#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <mutex>
#include <set>

#include "core/character/skin.h"
#include "render/bones.h"
#include "render/posing.h"

namespace mw {
namespace {

MaterialPictures picturesOf(const Scene& scene, const Material& m)
{
    const Material::Texture* const textures[pictureUses] = {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture,
                                                            &m.emissiveTexture};
    MaterialPictures out;
    for (size_t use = 0; use < pictureUses; ++use)
        if (const Image* image = scene.find(textures[use]->image)) out[use] = image->bytes;
    return out;
}

DrawObject drawn(const Scene& scene, NodeId id, const MeshObject& object)
{
    DrawObject o;
    o.node = id;
    for (const MaterialId m : object.materials) {
        const Material* material = scene.find(m);
        o.materials.push_back(material ? scene.shared(m) : nullptr);
        o.pictures.push_back(material ? picturesOf(scene, *material) : MaterialPictures());
    }
    return o;
}

void addCorners(CameraFit& fit, const Bounds& b, const glm::dmat4& worldFromLocal)
{
    for (int i = 0; i < 8 && !b.empty; ++i)
        fit.add(glm::dvec3(worldFromLocal * glm::dvec4(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1)));
}

/// With the colours of the morph targets in use. Kept by the arrays they are made of, as every frame asks and new ones would be sent to the
/// graphics card each time.
Mesh colored(const Mesh& mesh, const MeshPose& pose)
{
    constexpr size_t most = 8;
    struct Entry {
        std::vector<const void*> arrays;
        std::weak_ptr<const void> owner;
        std::vector<float> weights;
        Attribute color;
    };
    static std::mutex mutex;
    static std::list<Entry> kept;
    std::vector<const void*> arrays;
    bool any = false;
    for (const Attribute& a : mesh.attributes()) {
        arrays.push_back(a.id());
        any |= a.name.starts_with("morph-color:");
    }
    if (!any || pose.morphWeights.empty()) return mesh;
    const std::lock_guard lock(mutex);
    std::erase_if(kept, [](const Entry& e) { return e.owner.expired(); });
    for (const Entry& e : kept)
        if (e.arrays == arrays && e.weights == pose.morphWeights) return mesh.with(e.color);
    const std::optional<Attribute> color = posedColor(mesh, pose);
    if (!color) return mesh;
    kept.push_front({std::move(arrays), mesh.positions().owner(), pose.morphWeights, *color});
    if (kept.size() > most) kept.pop_back();
    return mesh.with(*color);
}

}  // namespace

Frame frameOf(const Scene& scene, const std::function<Mesh(MeshId)>& shown, const ScenePose& pose)
{
    Frame frame;
    const std::map<NodeId, glm::dmat4> worlds = worldMatrices(scene, pose);
    std::set<NodeId> hidden;
    for (const NodeId id : scene.nodes()) {  // depth first: a parent comes before its children
        const Node& node = scene.node(id);
        if (!node.visible || hidden.count(node.parent)) {
            hidden.insert(id);
            continue;
        }
        if (const TerrainObject* ground = node.terrain ? scene.find(node.terrain) : nullptr) {
            DrawTerrain t;
            t.node = id;
            t.worldFromLocal = worlds.at(id);
            t.terrain = ground->terrain;
            frame.terrains.push_back(std::move(t));
        }
        const MeshObject* object = node.mesh ? scene.find(node.mesh) : nullptr;
        if (!object) continue;
        DrawObject o = drawn(scene, id, *object);
        o.mesh = shown(node.mesh);
        o.pose = meshPose(scene, id, o.mesh, pose, worlds);
        if (o.pose) o.mesh = colored(o.mesh, *o.pose);
        o.worldFromLocal = worldFromMesh(scene, id, worlds);
        frame.objects.push_back(std::move(o));
    }
    addBones(frame, scene, worlds);
    return frame;
}

Bounds boundsOf(const Frame& frame)
{
    Bounds all;
    const auto add = [&](const Bounds& b) {
        if (!b.empty) all.add(b);
    };
    for (const DrawObject& o : frame.objects) add(worldBounds(o));
    for (const DrawTerrain& t : frame.terrains) {
        const Bounds b = boundsOf(t.terrain);
        for (int i = 0; i < 8 && !b.empty; ++i) {
            const glm::dvec4 corner(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1);
            all.add(glm::dvec3(t.worldFromLocal * corner));
        }
    }
    for (const DrawBone& b : frame.bones) {
        all.add(glm::dvec3(b.head));
        all.add(glm::dvec3(b.tail));
    }
    return all;
}

void frameTightly(Frame& frame, double aspect)
{
    CameraFit fit(frame.camera, aspect);
    for (const DrawObject& o : frame.objects) {
        for (const glm::vec3& p : o.pose ? posedPositions(o.mesh, *o.pose) : o.mesh.positions())
            fit.add(glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(p), 1)));
    }
    for (const DrawBone& b : frame.bones) {
        fit.add(glm::dvec3(b.head));
        fit.add(glm::dvec3(b.tail));
    }
    for (const DrawTerrain& t : frame.terrains) addCorners(fit, boundsOf(t.terrain), t.worldFromLocal);
    for (const Label& l : frame.labels) fit.add(glm::dvec3(l.atWorld));
    fit.apply(frame.camera);
    frame.camera.fitClip(boundsOf(frame));
}

std::pair<double, double> heatRange(const Column& column)
{
    std::vector<double> v;
    v.reserve(column.values.size());
    for (const double x : column.values)
        if (std::isfinite(x)) v.push_back(x);
    if (v.empty()) return {0, 1};
    const auto quantile = [&](double q) {
        const auto at = v.begin() + ptrdiff_t(q * double(v.size() - 1) + 0.5);
        std::nth_element(v.begin(), at, v.end());
        return *at;
    };
    double low = quantile(0.02), high = quantile(0.98);
    if (!(low < high)) {
        const auto [least, most] = std::minmax_element(v.begin(), v.end());
        low = *least;
        high = *most;
    }
    if (low < 0 && high > 0 && !column.categorical) high = std::max(high, -low), low = -high;  // zero in the middle
    return {low, high};
}

}  // namespace mw
