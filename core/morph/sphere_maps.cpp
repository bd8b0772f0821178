// Two closed meshes without holes on the sphere, each by its spherical embedding, one turned to fit the other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/morph/morph_maps.h"
#include "core/parameterize/embed_spherical.h"

namespace mw {

MorphMaps sphericalMaps(const Mesh& first, const Mesh& second, bool align)
{
    MorphMaps out{{MorphMesh::of(first), MorphMesh::of(second)}, {}};
    std::vector<glm::dvec3> directions[2];
    for (int m = 0; m < 2; ++m) {
        const MorphMesh& mesh = out.meshes[m];
        directions[m] = sphericalEmbedding(mesh.mesh());
    }
    if (align) {
        const glm::dmat3 turn = aligningRotation(directions[0], out.meshes[0].positions, directions[1], out.meshes[1].positions);
        for (glm::dvec3& d : directions[1]) d = turn * d;
        out.turn = std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
    }
    for (int m = 0; m < 2; ++m) {
        out.maps[m] = onSphere(out.meshes[m], directions[m]);
        requireCovering(out.maps[m], m == 0 ? "first" : "other");
    }
    return out;
}

}  // namespace mw
