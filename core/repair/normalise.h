// Modifier: brings a mesh to the origin and to a size of 1 (book 2.8).
#pragma once
#include "core/mesh/describe_length.h"
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Normalise {
    enum class Fit { Sphere, Box, Keep };
    enum class Centre { Box, Centroid, Keep };

    Fit fit = Fit::Box;
    double size = 1;
    Centre centre = Centre::Box;
    bool floor = false;

    template <class V>
    void describe(V& v)
    {
        v.choice("fit", fit, {"sphere", "box", "keep"},
                 {.title = "Fit",
                  .help = "Sphere: the farthest vertex is half the size from the centre. Box: the longest side is the size. Keep: the size stays."});
        describeLength(v, "size", size, "Size", "Diameter of the sphere, or longest side of the box, afterwards.");
        v.choice("centre", centre, {"box", "centroid", "keep"},
                 {.title = "Centre",
                  .help = "What goes to the origin: the middle of the bounding box, or the centroid of the surface. Keep: the origin stays."});
        v.flag("floor", floor, {.title = "Stand on the floor", .help = "Afterwards the lowest vertex is at height 0 (y is up)."});
    }
};

/// p' = s (p - c), s one factor for all axes. Faces, texture coordinates, normals stay as they are; morph targets are scaled. The box is that of
/// all vertices, the centroid that of the surface (of the vertices when it has no area). A mesh without extent is moved only. O(n).
Generator normalise(Mesh input, Normalise parameters, Stage<Mesh>& stage);

}  // namespace mw
