// Square root of three subdivision. Book 3.2; Kobbelt 2000, "sqrt(3)-subdivision". Two rounds cut every edge in three: hence the name.
//
// Takes any mesh; polygons are cut into triangles first, faces of fewer than three corners are left out. Sharp edges (one face, more than two, two
// that run the same way, or `crease` of 1 and more) are never flipped: they stay as they are in odd rounds and become three in even ones, along a
// curve of their own; a vertex where other than two of them meet stays, but the end of a crease moves as if it had none. Vertex attributes are mixed
// with the weights of the positions. Corner attributes are linear in the triangles of each pair of rounds, which puts seams back where they were.
// Between the two rounds of a pair an edge runs across: if the number of levels is odd, edges at seams, or between different materials or groups, are
// not flipped in the last one; the places are the same. Vertex v stays v, then come the centres, then the points on sharp edges. Linear in the
// result; at most 100 million triangles, beyond that it throws Error.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct SubdivideSqrt3 {
    int64_t levels = 2;

    template <class V>
    void describe(V& v)
    {
        v.integer("levels", levels,
                  {.title = "Levels",
                   .help = "How often every triangle becomes three. Two levels cut every edge in three.",
                   .min = 1,
                   .max = 8,
                   .softMax = 6});
    }
};

Generator subdivideSqrt3(Mesh input, SubdivideSqrt3 parameters, Stage<Mesh>& stage);

}  // namespace mw
