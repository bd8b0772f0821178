// From a scene to what is drawn of it, and the range of a heat map.
#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace mw {
namespace {

void addNode(Frame& frame, const Scene& scene, NodeId id, const glm::dmat4& worldFromParent, const std::function<Mesh(MeshId)>& shown)
{
    const Node& node = scene.node(id);
    if (!node.visible) return;
    const glm::dmat4 world = worldFromParent * node.local.matrix();
    if (const MeshObject* object = node.mesh ? scene.find(node.mesh) : nullptr) {
        DrawObject o;
        o.node = id;
        o.worldFromLocal = world;
        o.mesh = shown(node.mesh);
        for (const MaterialId m : object->materials) {
            const Material* material = scene.find(m);
            const Image* image = material ? scene.find(material->baseColorTexture.image) : nullptr;
            o.materials.push_back(material ? std::make_shared<Material>(*material) : nullptr);
            o.baseImages.push_back(image ? std::make_shared<Image>(*image) : nullptr);
        }
        frame.objects.push_back(std::move(o));
    }
    for (const NodeId child : node.children) addNode(frame, scene, child, world, shown);
}

}  // namespace

Frame frameOf(const Scene& scene, const std::function<Mesh(MeshId)>& shown, const ScenePose&)
{
    Frame frame;
    for (const NodeId root : scene.roots()) addNode(frame, scene, root, glm::dmat4(1), shown);
    return frame;
}

Bounds boundsOf(const Frame& frame)
{
    Bounds all;
    for (const DrawObject& o : frame.objects) {
        const Bounds b = o.mesh.bounds();
        if (b.empty) continue;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec4 corner(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1);
            all.add(glm::dvec3(o.worldFromLocal * corner));
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
    for (const DrawObject& o : frame.objects)
        for (const glm::vec3& p : o.mesh.positions()) fit.add(glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(p), 1)));
    for (const DrawBone& b : frame.bones) {
        fit.add(glm::dvec3(b.head));
        fit.add(glm::dvec3(b.tail));
    }
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
