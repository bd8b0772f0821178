// A sum of sine waves (5.3, equations 5.8 to 5.10): the simplest landscape.
#pragma once
#include <cstdint>
#include <string>

#include "core/steps/stage.h"
#include "core/terrain/height_map.h"

namespace mw {

struct Sinusoids {
    int64_t size = 257, harmonics = 5;
    double until = 0.6;

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
        v.integer("harmonics", harmonics,
                  {.title = "Waves",
                   .help = "How many are added; each has double the frequency and half the height of the one before.",
                   .min = 1,
                   .max = 12});
        v.number("until", until, {.title = "Length", .help = "Periods of the first wave along a side.", .min = 0.01, .max = 100, .softMax = 4});
    }
};

/// g(until x) + g(until y) for x and y from 0 to 1, g(t) = sum over k of sin(2^(k+1) pi t) / 2^k (5.9), stretched to 0..1.
Generator sinusoids(Sinusoids parameters, Stage<HeightMap>& stage);

}  // namespace mw
