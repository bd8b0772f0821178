#include "app/figures/drawn_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace mw::figures {

At placeOf(const Mesh& mesh, uint32_t vertex)
{
    return mesh.positions()[vertex];
}

At centreOf(const Mesh& mesh, uint32_t face)
{
    glm::dvec3 sum(0);
    for (const uint32_t v : mesh.face(face)) sum += glm::dvec3(mesh.positions()[v]);
    return sum / double(mesh.face(face).size());
}

At middleOf(const Mesh& mesh, uint32_t a, uint32_t b)
{
    return 0.5 * (glm::dvec3(mesh.positions()[a]) + glm::dvec3(mesh.positions()[b]));
}

void drawEdges(Drawing& d, const Mesh& mesh, const Pen& pen)
{
    const auto& e = mesh.edges();
    for (size_t i = 0; i + 1 < e.size(); i += 2) d.line(placeOf(mesh, e[i]), placeOf(mesh, e[i + 1]), pen);
}

void fillFace(Drawing& d, const Mesh& mesh, uint32_t face, glm::vec4 fill, double shrunk)
{
    const glm::dvec3 middle = centreOf(mesh, face).p;
    std::vector<At> corners;
    for (const uint32_t v : mesh.face(face)) corners.push_back(glm::mix(placeOf(mesh, v).p, middle, shrunk));
    d.polygon(std::move(corners), fill);
}

std::pair<At, At> inset(At a, At b, At inside, double share, double ends)
{
    const glm::dvec3 p = glm::mix(a.p, inside.p, share), q = glm::mix(b.p, inside.p, share);
    return {glm::mix(p, q, ends), glm::mix(q, p, ends)};
}

void closeUp(Space& s, glm::dvec3 place, glm::dvec3 normal, double reach, double turn)
{
    Camera c = s.frame.camera;
    const glm::dvec3 n = glm::normalize(normal);
    c.perspective = false;
    c.target = place;
    c.azimuth = std::atan2(n.x, n.z) + turn;
    c.elevation = std::asin(std::clamp(n.y, -1.0, 1.0));
    c.distance = reach / std::tan(0.5 * c.fieldOfView);
    s.fixed(c);
}

std::pair<uint32_t, uint32_t> nearestEdge(const Mesh& mesh, glm::dvec3 place)
{
    const auto& e = mesh.edges();
    size_t best = 0;
    for (size_t i = 0; i + 1 < e.size(); i += 2)
        if (glm::distance(middleOf(mesh, e[i], e[i + 1]).p, place) < glm::distance(middleOf(mesh, e[best], e[best + 1]).p, place)) best = i;
    return {e[best], e[best + 1]};
}

uint32_t nearestFace(const Mesh& mesh, glm::dvec3 place)
{
    uint32_t best = 0;
    for (uint32_t f = 0; f < mesh.faceCount(); ++f)
        if (glm::distance(centreOf(mesh, f).p, place) < glm::distance(centreOf(mesh, best).p, place)) best = f;
    return best;
}

std::string joined(std::span<const uint32_t> indices, const char* between)
{
    std::string s;
    for (const uint32_t i : indices) s += (s.empty() ? "" : between) + std::to_string(i);
    return s;
}

}  // namespace mw::figures
