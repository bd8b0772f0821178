#include "core/morph/morph_maps.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/morph/star_centre.h"

namespace mw {

OverlayInput onSphere(const MorphMesh& mesh, std::span<const glm::dvec3> directions, int64_t step)
{
    std::vector<Direction> places;
    for (const glm::dvec3& d : directions) {
        Direction at = Direction::onSphere(d);
        for (int64_t* x : {&at.x, &at.y, &at.z}) *x = (*x + (*x < 0 ? -step / 2 : step / 2)) / step * step;
        places.push_back(at);
    }
    return {DomainMesh(std::move(places), mesh.corners), mesh.positions, std::vector<double>(mesh.positions.size(), 1)};
}

void requireCovering(const OverlayInput& input, const char* which)
{
    const double times = input.map.coverings();
    if (std::abs(times - 1) > 1e-6)
        throw Error("the map of the " + std::string(which) + " mesh covers the sphere " + std::to_string(int(std::lround(times))) +
                    " times instead of once; choose another method");
}

MorphMaps projectiveMaps(const Mesh& first, const Mesh& second)
{
    MorphMaps out;
    Generator parts = projectiveMaps(first, second, out);
    while (parts.next()) {
    }
    return out;
}

Generator projectiveMaps(Mesh first, Mesh second, MorphMaps& out)
{
    out = MorphMaps();
    out.meshes[0] = MorphMesh::of(first);
    out.meshes[1] = MorphMesh::of(second);
    for (int m = 0; m < 2; ++m) {
        co_yield Step("project").progress(0.5 * m);
        const char* which = m == 0 ? "first" : "other";
        const MorphMesh& mesh = out.meshes[m];
        const std::optional<glm::dvec3> centre = starCentre(mesh.positions, mesh.corners);
        if (!centre)
            throw Error("there is no point from which all of the " + std::string(which) + " mesh is seen; method spherical does without one");
        out.centres[m] = *centre;
        std::vector<glm::dvec3> directions;
        for (const glm::dvec3& p : mesh.positions) directions.push_back(p - *centre);
        out.maps[m] = onSphere(mesh, directions, 64);
        for (size_t v = 0; v < directions.size(); ++v) out.maps[m].mass[v] = 1 / glm::length(directions[v]);
        requireCovering(out.maps[m], which);
    }
}

}  // namespace mw
