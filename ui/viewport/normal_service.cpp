#include "ui/viewport/normal_service.h"

#include "core/mesh/same_mesh.h"

namespace mw {
namespace {

constexpr size_t atOnce = 30'000;  // faces: a few milliseconds

Attribute madeFor(const Mesh& mesh, NormalWeight weight)
{
    const Array<glm::vec3> normals = vertexNormalsOf(mesh, weight);
    Array<float> values;
    values.reserve(3 * normals.size());
    for (const glm::vec3& n : normals)
        for (int k = 0; k < 3; ++k) values.push_back(n[k]);
    return floatAttribute(std::string(names::normal), Domain::Vertex, 3, std::move(values));
}

}  // namespace

Mesh NormalService::shown(const Mesh& mesh, NormalWeight weight)
{
    if (weight == NormalWeight::Area || mesh.faceCount() == 0 || mesh.find(names::normal)) return mesh;
    for (const Entry& e : entries_)
        if (e.weight == weight && sameMesh(e.mesh, mesh)) return e.normals ? mesh.with(*e.normals) : mesh;
    entries_.push_front({weight, mesh, std::nullopt});
    if (entries_.size() > 16) entries_.pop_back();
    if (mesh.faceCount() <= atOnce) {
        entries_.front().normals = madeFor(mesh, weight);
        return mesh.with(*entries_.front().normals);
    }
    jobs_.start("Normals", [this, mesh, weight](Progress& progress) -> std::function<void()> {
        progress.at(0);
        const Attribute made = madeFor(mesh, weight);
        return [this, mesh, weight, made] {
            for (Entry& e : entries_)
                if (e.weight == weight && sameMesh(e.mesh, mesh)) e.normals = made;
            emit ready();
        };
    });
    return mesh;
}

}  // namespace mw
