#include "core/repair/damaged_sphere.h"

#include <algorithm>

#include "core/math/random.h"
#include "core/mesh/primitives.h"

namespace mw {

namespace {

Mesh sphere(int64_t subdivisions)
{
    Stage<Mesh> stage(false);
    Generator run = icosphere({.subdivisions = subdivisions, .radius = 1}, stage);
    while (run.next()) continue;
    return stage.value();
}

/// Faces at one of these vertices are gone.
std::vector<uint8_t> holeCentres(const Mesh& mesh, int64_t holes, Random& random)
{
    std::vector<uint8_t> centre(mesh.vertexCount(), 0);
    for (int64_t k = 0; k < holes; ++k) centre[size_t(random.uniform() * double(centre.size()))] = 1;
    return centre;
}

}  // namespace

Generator damagedSphere(DamagedSphere p, Stage<Mesh>& stage)
{
    co_yield Step("sphere").progress(0);
    const Mesh whole = sphere(p.subdivisions);
    co_yield Step("damage").progress(0.5);
    Random random(uint64_t(p.seed));
    const std::vector<uint8_t> centre = holeCentres(whole, p.holes, random);
    Array<uint32_t> triangles;
    for (size_t f = 0; f < whole.faceCount(); ++f) {
        const auto v = whole.face(f);
        const bool turned = random.uniform() < p.turned;
        if (centre[v[0]] || centre[v[1]] || centre[v[2]]) continue;
        triangles.push_back(v[0]);
        triangles.push_back(v[turned ? 2 : 1]);
        triangles.push_back(v[turned ? 1 : 2]);
    }
    stage.finish(Mesh::triangles(whole.positions(), std::move(triangles)));
}

}  // namespace mw
