#include "core/morph/target.h"

#include <algorithm>

namespace mw {

namespace {

Mesh displaced(const Mesh& mesh, std::span<const float> d, double t)
{
    Array<glm::vec3> places(mesh.positions().begin(), mesh.positions().end());
    for (size_t v = 0; v < places.size(); ++v)
        for (int k = 0; k < 3; ++k) places[v][k] += float(t * double(d[3 * v + size_t(k)]));
    return mesh.withPositions(std::move(places));
}

const Attribute* lastTarget(const Mesh& mesh)
{
    const Attribute* last = nullptr;
    for (const Attribute& a : mesh.attributes())
        if (a.domain == Domain::Vertex && a.name.starts_with(names::morph)) last = &a;
    return last;
}

/// A colour on elements of `domain`, 1 where there is none.
Array<float> colorOn(const Mesh& mesh, const Attribute* color, Domain domain, int components)
{
    Array<float> out;
    out.reserve(mesh.count(domain) * size_t(components));
    for (size_t i = 0; i < mesh.count(domain); ++i) {
        const size_t from = color && color->domain != domain ? mesh.cornerVertex()[i] : i;
        for (int k = 0; k < components; ++k) out.push_back(color && k < color->components ? float(color->at(from, k)) : 1.f);
    }
    return out;
}

}  // namespace

const Attribute* colorOf(const Mesh& mesh)
{
    const Attribute* color = mesh.find(names::color, Domain::Corner);
    if (!color) color = mesh.find(names::color, Domain::Vertex);
    return color && (color->components == 3 || color->components == 4) ? color : nullptr;
}

Mesh withTargetColor(const Mesh& mesh, const Attribute& color)
{
    const Attribute *own = colorOf(mesh), *target = lastTarget(mesh);
    if (!target) return mesh;
    const Domain domain = color.domain == Domain::Corner || (own && own->domain == Domain::Corner) ? Domain::Corner : Domain::Vertex;
    const int components = std::max(color.components, own ? own->components : 3);
    Array<float> from = colorOn(mesh, own, domain, components), to = colorOn(mesh, &color, domain, components);
    for (size_t i = 0; i < to.size(); ++i) to[i] -= from[i];
    const std::string name = "morph-color:" + target->name.substr(names::morph.size());
    return mesh.without(names::color)
        .with(floatAttribute(std::string(names::color), domain, components, std::move(from)))
        .with(floatAttribute(name, domain, components, std::move(to)));
}

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
    const Attribute* last = lastTarget(mesh);
    return last ? displaced(mesh, last->floats(), t) : mesh;
}

}  // namespace mw
