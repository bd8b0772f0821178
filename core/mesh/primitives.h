// Sources: meshes made from a few numbers.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Icosphere {
    int64_t subdivisions = 3;
    double radius = 1;
    template <class V>
    void describe(V& v)
    {
        v.integer("subdivisions", subdivisions,
                  {.title = "Subdivisions", .help = "How often every triangle is cut in four: 20, 80, 320, ... triangles.", .min = 0, .max = 8});
        v.number("radius", radius,
                 {.title = "Radius",
                  .help = "Distance of all vertices from the origin.",
                  .unit = "m",
                  .min = 1e-6,
                  .max = 1e6,
                  .softMin = 0.1,
                  .softMax = 10,
                  .logarithmic = true});
    }
};

/// The icosahedron, each triangle cut in four and the new vertices moved out to the sphere, `subdivisions` times: 10 * 4^n + 2 vertices,
/// 20 * 4^n triangles, closed, outside anticlockwise. The first vertices are those of the coarser spheres. A step a level.
Generator icosphere(Icosphere parameters, Stage<Mesh>& stage);

}  // namespace mw
