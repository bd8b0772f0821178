#include "core/morph/target.h"

namespace mw {

namespace {

Mesh displaced(const Mesh& mesh, std::span<const float> d, double t)
{
    Array<glm::vec3> places(mesh.positions().begin(), mesh.positions().end());
    for (size_t v = 0; v < places.size(); ++v)
        for (int k = 0; k < 3; ++k) places[v][k] += float(t * double(d[3 * v + size_t(k)]));
    return mesh.withPositions(std::move(places));
}

}  // namespace

Mesh withTarget(const Mesh& mesh, const std::string& name, Array<float> displacement)
{
    std::string free = name;
    for (int i = 2; mesh.find(std::string(names::morph) + free); ++i) free = name + " " + std::to_string(i);
    const Shared<glm::vec3> normals = displaced(mesh, displacement, 1).vertexNormals();
    const Attribute* own = mesh.find(names::normal, Domain::Corner);
    const Domain domain = own ? Domain::Corner : Domain::Vertex;
    if (!own) own = mesh.find(names::normal, Domain::Vertex);
    const Shared<glm::vec3> smooth = own ? Shared<glm::vec3>() : mesh.vertexNormals();
    Array<float> turned;
    turned.reserve(3 * mesh.count(domain));
    for (size_t i = 0; i < mesh.count(domain); ++i) {
        const uint32_t v = domain == Domain::Corner ? mesh.cornerVertex()[i] : uint32_t(i);
        for (int k = 0; k < 3; ++k) turned.push_back(float(double(normals[v][k]) - (own ? own->at(i, k) : double(smooth[v][k]))));
    }
    return mesh.with(floatAttribute(std::string(names::morph) + free, Domain::Vertex, 3, std::move(displacement)))
        .with(floatAttribute("morph-normal:" + free, domain, 3, std::move(turned)));
}

Mesh towardsTarget(const Mesh& mesh, double t)
{
    const Attribute* last = nullptr;
    for (const Attribute& a : mesh.attributes())
        if (a.domain == Domain::Vertex && a.name.starts_with(names::morph)) last = &a;
    return last ? displaced(mesh, last->floats(), t) : mesh;
}

}  // namespace mw
