// Source: a sphere with faces turned over and holes, to try repairs on.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct DamagedSphere {
    int64_t subdivisions = 2;
    double turned = 0.2;
    int64_t holes = 2;
    int64_t seed = 1;

    template <class V>
    void describe(V& v)
    {
        v.integer("subdivisions", subdivisions,
                  {.title = "Subdivisions", .help = "How often every triangle is cut in four: 20, 80, 320, ... triangles.", .min = 1, .max = 7});
        v.number("turned", turned, {.title = "Turned", .help = "Share of the faces that show their back.", .min = 0, .max = 1});
        v.integer("holes", holes,
                  {.title = "Holes", .help = "How often the faces round some vertex are taken away.", .min = 0, .max = 1000, .softMax = 10});
        v.integer("seed", seed, {.title = "Seed", .help = "Another number, another damage.", .min = 0, .max = 1000000000});
    }
};

/// The icosphere of radius 1. Vertices keep their numbers; those inside a hole are left without faces.
Generator damagedSphere(DamagedSphere parameters, Stage<Mesh>& stage);

}  // namespace mw
