// Sources: meshes made from a few numbers.
#pragma once
#include "core/mesh/describe_length.h"
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
        describeLength(v, "radius", radius, "Radius", "Distance of all vertices from the origin.");
    }
};

/// The icosahedron, each triangle cut in four and the new vertices moved out to the sphere, `subdivisions` times: 10 * 4^n + 2 vertices,
/// 20 * 4^n triangles, closed, outside anticlockwise. The first vertices are those of the coarser spheres. A step a level.
Generator icosphere(Icosphere parameters, Stage<Mesh>& stage);

}  // namespace mw
