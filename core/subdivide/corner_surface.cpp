// Distinct values at each vertex, by sorting the corners there.
#include "core/subdivide/corner_surface.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace mw {

std::vector<CornerSurface> cornerSurfacesOf(const Mesh& mesh)
{
    std::vector<CornerSurface> out;
    for (const Attribute& a : mesh.attributes()) {
        if (a.domain != Domain::Corner || a.components != 2 || a.integral() || !a.name.starts_with(names::texcoord)) continue;
        std::vector<uint32_t> order(mesh.cornerCount());
        std::iota(order.begin(), order.end(), 0u);
        const auto key = [&](uint32_t c) { return std::tuple(mesh.cornerVertex()[c], a.at(c, 0), a.at(c, 1)); };
        std::sort(order.begin(), order.end(), [&](uint32_t c, uint32_t d) { return key(c) < key(d); });
        Array<glm::vec3> places;
        Array<uint32_t> corner(mesh.cornerCount());
        for (size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || key(order[i]) != key(order[i - 1])) places.emplace_back(float(a.at(order[i], 0)), float(a.at(order[i], 1)), 0.f);
            corner[order[i]] = uint32_t(places.size() - 1);
        }
        out.push_back({a, Mesh(std::move(places), mesh.faceStart(), std::move(corner))});
    }
    return out;
}

Attribute cornerValues(const CornerSurface& surface, const Array<glm::vec3>& points, std::span<const uint32_t> corners)
{
    Array<float> values(2 * corners.size());
    float* out = values.data();
    for (const uint32_t c : corners) *out++ = points[c].x, *out++ = points[c].y;
    return floatAttribute(surface.attribute.name, Domain::Corner, 2, std::move(values));
}

}  // namespace mw
