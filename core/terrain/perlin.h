// Perlin noise in octaves (5.3, equations 5.12 to 5.16).
#pragma once
#include <cstdint>
#include <string>

#include "core/steps/stage.h"
#include "core/terrain/height_map.h"

namespace mw {

struct Perlin {
    enum class Fade { None, Cubic, Quintic };
    enum class Normalise { Octaves, Sum, None };

    int64_t size = 257, interval = 128, octaves = 4, octave = 0, seed = 1;
    Fade fade = Fade::Quintic;
    Normalise normalise = Normalise::Octaves;

    template <class V>
    void describe(V& v)
    {
        v.integer("size", size,
                  {.title = "Size",
                   .help = "Samples along each side.",
                   .unit = "samples",
                   .min = 2,
                   .max = 8193,
                   .softMin = 17,
                   .softMax = 2049,
                   .logarithmic = true});
        v.integer("interval", interval,
                  {.title = "Largest interval",
                   .help = "Distance of the vectors in the first octave, the size of the largest hills; half of it in each further one.",
                   .unit = "samples",
                   .min = 2,
                   .max = 8192,
                   .softMin = 8,
                   .softMax = 1024,
                   .logarithmic = true});
        v.integer("octaves", octaves,
                  {.title = "Octaves",
                   .help = "How many are added, with weights 1, 1/2, 1/4, ...; octaves of an interval below 2 samples are zero and left out.",
                   .min = 1,
                   .max = 13});
        v.integer("octave", octave, {.title = "One octave alone", .help = "0: the sum of all. 1, 2, ...: only that octave.", .min = 0, .max = 13});
        v.choice("fade", fade, {"none", "cubic", "quintic"},
                 {.title = "Fade",
                  .help = "Weight of the interpolation across a cell. none: w, kinks at cell borders. cubic: 3w^2 - 2w^3, smooth slope. quintic: "
                          "6w^5 - 15w^4 + 10w^3, smooth curvature."});
        v.integer("seed", seed, {.title = "Seed", .help = "Another number, other hills.", .min = 0, .max = 4294967295.0, .softMax = 100});
        v.choice(
            "normalise", normalise, {"octaves", "sum", "none"},
            {.title = "Stretch",
             .help = "octaves: each octave to 0..1 before it is weighted (5.14). sum: only the sum to 0..1. none: heights around 0, as they come."});
    }
};

/// Octave k has vectors at every (interval / 2^k)-th sample of one random field, whole numbers rounded down. A sample takes from each of the
/// four around it the dot product of vector and way there (5.12), the way counted in intervals, and interpolates them (5.13). The sum is
/// divided by the sum of weights (5.16).
/// Two steps an octave: "corners" for one sample, "octave" when it is added; "normalise" when the sum is stretched.
Generator perlin(Perlin parameters, Stage<HeightMap>& stage);

/// Direction of the random field at a sample, in turns, 0 to 1 (times 2 pi: the angle of the vector).
double perlinTurn(int64_t seed, uint32_t x, uint32_t y);

}  // namespace mw
