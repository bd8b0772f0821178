// Query: how much texture coordinates stretch each face. Book 3.12.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

/// Singular values of the linear map that takes a triangle to its texture coordinates: s1 >= s2 >= 0. Not numbers where the triangle has no area.
struct Stretch {
    double s1 = 0, s2 = 0;
};
Stretch stretchOf(const glm::dvec3 (&places)[3], const glm::dvec2 (&coordinates)[3]);

struct UvDistortion {
    int64_t set = 0;
    template <class V>
    void describe(V& v)
    {
        v.integer("set", set, {.title = "Set", .help = "Which texture coordinates; 0 are the first.", .min = 0, .max = 63, .softMax = 3});
    }
};

/// A row a face, from the singular values of its triangles (means by area where it is a polygon). "angle": s1/s2, 1 where angles are kept.
/// "area": s1 s2 as a factor of the whole mesh's, 1 where the picture is as dense as on average. NaN where there is no area. The summary has
/// means by area, the greatest values, and the number of faces that are folded over. Throws Error without texture coordinates.
Generator uvDistortion(Mesh input, UvDistortion parameters, Stage<Table>& stage);

}  // namespace mw
