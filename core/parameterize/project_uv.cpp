// Texture coordinates by projection.
#include "core/parameterize/project_uv.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace mw {
namespace {

constexpr double gap = 0.02;  // of a cell, round it

// u x v looks out of the box, v is up where there is an up.
struct Side {
    glm::dvec3 u, v;
};
constexpr Side sides[6] = {{{0, 0, -1}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, -1}},
                           {{1, 0, 0}, {0, 0, 1}},  {{1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}}};

/// 0 +X, 1 -X, 2 +Y, ...
size_t sideOf(glm::vec3 n)
{
    size_t axis = std::abs(n.y) > std::abs(n.x) ? 1 : 0;
    if (std::abs(n.z) > std::abs(n[int(axis)])) axis = 2;
    return 2 * axis + (n[int(axis)] < 0 ? 1 : 0);
}

}  // namespace

Attribute projectedCoordinates(const Mesh& mesh, UvProjection from)
{
    const bool box = from == UvProjection::Box;
    const Bounds b = mesh.bounds();
    const glm::dvec3 size = b.size();
    const double longest = std::max({size.x, size.y, size.z, 1e-30});
    // Six sides lie in three columns and two rows of squares.
    const double cell = box ? 1.0 / 3 : 1, scale = cell * (1 - 2 * gap) / longest;
    Array<float> out(2 * mesh.cornerCount(), 0.f);
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const size_t side = box ? sideOf(mesh.faceNormals()[f]) : 2 * (size_t(from) - 1);
        const glm::dvec2 middle = box ? cell * glm::dvec2(double(side / 2) + 0.5, double(side % 2) + 0.5) : glm::dvec2(0.5);
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
            const glm::dvec3 p = glm::dvec3(mesh.positions()[mesh.cornerVertex()[c]]) - b.centre();
            const glm::dvec2 t = middle + scale * glm::dvec2(glm::dot(p, sides[side].u), glm::dot(p, sides[side].v));
            out[2 * c] = float(t.x);
            out[2 * c + 1] = float(t.y);
        }
    }
    return floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(out));
}

}  // namespace mw
