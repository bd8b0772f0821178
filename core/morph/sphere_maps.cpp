// Two closed meshes without holes on the sphere, each by its spherical embedding, one turned to fit the other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/morph/morph_maps.h"
#include "core/parameterize/embed_spherical.h"

namespace mw {

Generator sphericalMaps(Mesh first, Mesh second, bool align, MorphMaps& out)
{
    out = MorphMaps();
    out.meshes[0] = MorphMesh::of(first);
    out.meshes[1] = MorphMesh::of(second);
    std::vector<glm::dvec3> directions[2];
    for (int m = 0; m < 2; ++m) {
        Generator parts = sphericalEmbedding(out.meshes[m].mesh(), EmbedSpherical(), directions[m]);
        while (parts.next()) co_yield Step("embed").progress(0.45 * (double(m) + double(parts.step().progress())));
    }
    if (align) {
        glm::dmat3 turn(1);
        Generator parts = aligningRotation(directions[0], out.meshes[0].positions, directions[1], out.meshes[1].positions, turn);
        while (parts.next()) co_yield Step("embed").progress(0.9 + 0.1 * double(parts.step().progress()));
        for (glm::dvec3& d : directions[1]) d = turn * d;
        out.turn = std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
    }
    for (int m = 0; m < 2; ++m) {
        out.maps[m] = onSphere(out.meshes[m], directions[m]);
        requireCovering(out.maps[m], m == 0 ? "first" : "other");
        co_yield Step("embed").progress(1);
    }
}

}  // namespace mw
