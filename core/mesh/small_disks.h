// Sources: two small open shapes whose maps can be followed vertex by vertex. Book 3.3.2, figure 3.27.
#pragma once
#include "core/mesh/describe_length.h"
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct SmallDisk {
    double size = 1;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "size", size, "Size", "Width of its box along X.");
    }
};

/// Walls and roof without a floor: 15 vertices (6 of them on the border), 36 edges, 22 triangles. +Y is up, the floor at 0.
Generator house(SmallDisk parameters, Stage<Mesh>& stage);
/// A body without an underside, with arches over its wheels: 32 vertices (20 on the border), 73 edges, 42 triangles. It drives towards +X.
Generator car(SmallDisk parameters, Stage<Mesh>& stage);

}  // namespace mw
