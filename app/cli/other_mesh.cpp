#include "app/cli/other_mesh.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/io/io.h"

namespace mw::cli {

namespace {

bool isNode(const Scene& scene, const std::string& name)
{
    const std::vector<NodeId> nodes = scene.nodes();
    return std::any_of(nodes.begin(), nodes.end(), [&](NodeId id) { return scene.node(id).name == name && scene.node(id).mesh; });
}

std::optional<MeshObject> meshOfFile(const std::string& file, Progress* progress)
{
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) return std::nullopt;
    const Imported read = readFile(file, progress, {});
    const std::vector<MeshId> meshes = read.scene.meshes();
    if (meshes.size() != 1) throw Error(file, meshes.empty() ? "there is no mesh in it" : "there are several meshes in it; join them first");
    MeshObject object = *read.scene.find(meshes.front());
    object.base = evaluated(object, progress);
    object.stack.clear();
    object.materials.clear();
    return object;
}

}  // namespace

FindMesh meshesOf(const Scene& scene, Progress* progress)
{
    return [&scene, progress, evaluator = std::make_shared<Evaluator>()](const std::string& name) -> std::optional<Mesh> {
        if (std::optional<Mesh> mesh = evaluator->meshOf(scene, name, progress)) return mesh;
        if (const std::optional<MeshObject> object = meshOfFile(name, progress)) return object->base;
        return std::nullopt;
    };
}

void keepOthers(Scene& scene, OperationCall& call, Progress* progress)
{
    for (const Parameter& p : call.operation->parameters) {
        if (p.type != ParameterType::Object) continue;
        const std::string name = std::get<std::string>(valueOf(p, call.values));
        if (isNode(scene, name)) continue;
        std::optional<MeshObject> object = meshOfFile(name, progress);
        if (!object) continue;
        Node node;
        node.name = std::filesystem::path(name).stem().string();
        while (isNode(scene, node.name)) node.name += "'";
        node.visible = false;
        node.mesh = scene.add(*std::move(object));
        call.values[p.name] = node.name;
        scene.add(std::move(node));
    }
}

}  // namespace mw::cli
