#include "core/repair/normalise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mw {

namespace {

glm::dvec3 centroid(const Mesh& mesh)
{
    const Shared<glm::vec3>& p = mesh.positions();
    const Shared<uint32_t>& t = mesh.triangulation().vertices;
    glm::dvec3 sum(0), plain(0);
    double area = 0;
    for (size_t i = 0; i + 2 < t.size(); i += 3) {
        const glm::dvec3 a(p[t[i]]), b(p[t[i + 1]]), c(p[t[i + 2]]);
        const double twice = glm::length(glm::cross(b - a, c - a));
        sum += twice * (a + b + c) / 3.0;
        area += twice;
    }
    if (area > 0) return sum / area;
    for (const glm::vec3& q : p) plain += glm::dvec3(q);
    return p.empty() ? plain : plain / double(p.size());
}

glm::dvec3 origin(const Mesh& mesh, Normalise::Centre centre)
{
    if (centre == Normalise::Centre::Keep) return glm::dvec3(0);
    return centre == Normalise::Centre::Box ? mesh.bounds().centre() : centroid(mesh);
}

double scaleOf(const Mesh& mesh, const Normalise& p, const glm::dvec3& centre)
{
    const glm::dvec3 side = mesh.bounds().size();
    double extent = std::max({side.x, side.y, side.z});
    if (p.fit == Normalise::Fit::Sphere) {
        extent = 0;
        for (const glm::vec3& q : mesh.positions()) extent = std::max(extent, 2 * glm::length(glm::dvec3(q) - centre));
    }
    return p.fit == Normalise::Fit::Keep || !(extent > 0) ? 1 : p.size / extent;
}

/// Displacements are scaled as the positions are.
Mesh withScaledMorphs(Mesh mesh, double scale)
{
    const std::vector<Attribute> attributes = mesh.attributes();
    for (Attribute a : attributes) {
        if (!a.name.starts_with(names::morph) || a.floats().empty()) continue;
        Array<float> values(a.floats().begin(), a.floats().end());
        for (float& x : values) x = float(scale * x);
        a.values = Shared<float>(std::move(values));
        mesh = mesh.with(std::move(a));
    }
    return mesh;
}

}  // namespace

Generator normalise(Mesh input, Normalise p, Stage<Mesh>& stage)
{
    co_yield Step("measure").progress(0);
    if (input.vertexCount() == 0) {
        stage.finish(input);
        co_return;
    }
    glm::dvec3 centre = origin(input, p.centre);
    const double scale = scaleOf(input, p, centre);
    if (p.floor) centre.y = input.bounds().min.y;
    co_yield Step("place").number("scale", scale).progress(0.5);
    Array<glm::vec3> positions(input.vertexCount());
    for (size_t v = 0; v < positions.size(); ++v) positions[v] = glm::vec3(scale * (glm::dvec3(input.positions()[v]) - centre));
    stage.finish(withScaledMorphs(input.withPositions(std::move(positions)), scale));
}

}  // namespace mw
