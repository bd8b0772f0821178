// One mesh of everything a scene shows, in world space: for formats without a hierarchy. Terrains as meshes: for formats without terrains.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/io/placement.h"
#include "core/scene/evaluation.h"
#include "core/scene/join_meshes.h"

namespace mw {

namespace {

bool isShown(const Scene& scene, NodeId id)
{
    for (const Node* n = scene.find(id); n; n = scene.find(n->parent))
        if (!n->visible) return false;
    return true;
}

/// Rounding of rotations kept as quaternions, taken out of the linear part: a model turned and turned back has its own numbers again.
glm::dmat4 tidied(glm::dmat4 m)
{
    double most = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(m[i][k]));
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            double& e = m[i][k];
            if (std::abs(e) < 1e-15 * most) e = 0;
            if (const double whole = std::round(e); whole != 0 && std::abs(e - whole) < 1e-14 * std::abs(whole)) e = whole;
        }
    return m;
}

std::vector<MeshPart> shownMeshes(const Scene& scene, Progress* progress, const Placement& placement, Evaluator* evaluator)
{
    Evaluator own;
    Evaluator& results = evaluator ? *evaluator : own;
    std::vector<MeshPart> shown;
    std::map<MeshId, Mesh> done;  // several nodes may show one
    const std::vector<NodeId> nodes = scene.nodes();
    for (size_t i = 0; i < nodes.size(); ++i) {
        if (progress) progress->at(float(i) / float(nodes.size()));
        const Node& node = scene.node(nodes[i]);
        const MeshObject* object = scene.find(node.mesh);
        if (!object || !isShown(scene, nodes[i])) continue;
        auto known = done.find(node.mesh);
        if (known == done.end()) known = done.emplace(node.mesh, results.evaluate(*object, progress, {}, &scene).result()).first;
        shown.push_back({node.name, object->materials, tidied(fileFromScene(placement) * scene.worldFromLocal(nodes[i])), known->second});
    }
    return shown;
}

/// The colours are at the vertices.
Material groundMaterial()
{
    Material m;
    m.name = "ground";
    m.baseColor = glm::dvec4(1);
    m.roughness = 0.9;
    return m;
}

}  // namespace

Scene withTerrainMeshes(const Scene& scene, size_t trianglesEach, Progress* progress)
{
    Scene out = scene;
    std::map<TerrainId, MeshId> done;
    MaterialId ground;
    for (const NodeId id : scene.nodes()) {
        Node node = scene.node(id);
        const TerrainObject* object = scene.find(node.terrain);
        if (!object || node.mesh || object->terrain.map.empty()) continue;
        if (!ground) ground = out.add(groundMaterial());
        auto known = done.find(node.terrain);
        if (known == done.end()) {
            Mesh mesh = terrainMesh(object->terrain, trianglesEach, progress);
            known = done.emplace(node.terrain, out.add(MeshObject{object->terrain.name, std::move(mesh), {ground}, {}})).first;
        }
        node.mesh = known->second;
        out.set(id, std::move(node));
    }
    return out;
}

Flattened flattened(const Scene& scene, Progress* progress, const Placement& placement, Evaluator* evaluator)
{
    JoinedMeshes joined = joinedMeshes(shownMeshes(scene, progress, placement, evaluator), true);
    return {std::move(joined.mesh), std::move(joined.materials)};
}

}  // namespace mw
