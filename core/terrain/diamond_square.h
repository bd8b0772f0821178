// Diamond-square (5.3, listing 5.5): midpoint displacement on a square grid.
#pragma once
#include <cstdint>
#include <string>

#include "core/steps/stage.h"
#include "core/terrain/height_map.h"

namespace mw {

struct DiamondSquare {
    int64_t size = 257, rounds = 0, seed = 1;
    double sigma = 0.3;
    double a = 0.5, b = 0.5, c = 0.5, d = 0.5;
    bool normalise = true;

    template <class V>
    void describe(V& v)
    {
        v.integer("size", size,
                  {.title = "Size",
                   .help = "Samples along each side. The grid is a power of two and one more (33, 65, 129, 257, ...); of other sizes the next "
                           "larger grid is made and cut off.",
                   .unit = "samples",
                   .min = 2,
                   .max = 8193,
                   .softMin = 17,
                   .softMax = 2049,
                   .logarithmic = true});
        v.integer("rounds", rounds,
                  {.title = "Rounds",
                   .help = "How often squares are halved; what then lies between is interpolated. 0: until every sample is displaced.",
                   .min = 0,
                   .max = 14});
        v.number("sigma", sigma,
                 {.title = "Sigma",
                  .help = "Standard deviation of the displacements in the first round, 1 being the full height; half of it in each further round.",
                  .min = 0,
                  .max = 100,
                  .softMax = 1});
        v.integer("seed", seed, {.title = "Seed", .help = "Another number, another landscape.", .min = 0, .max = 4294967295.0, .softMax = 100});
        v.flag("normalise", normalise,
               {.title = "Stretch to full height", .help = "Lowest point to 0, highest to 1. Off: heights stay as they come."});
        const auto corner = [&](const char* name, double& height, const char* title, const char* where) {
            v.number(name, height,
                     {.title = title,
                      .help = std::string("Height of the corner at ") + where + ".",
                      .min = -100,
                      .max = 100,
                      .softMin = 0,
                      .softMax = 1,
                      .advanced = true});
        };
        corner("a", a, "Corner A", "the first sample");
        corner("b", b, "Corner B", "the end of the first row");
        corner("c", c, "Corner C", "the last sample");
        corner("d", d, "Corner D", "the beginning of the last row");
    }
};

/// Round k = 0, 1, ... on squares of side s = 2^n / 2^k: every centre becomes the mean of the 4 corners + N(0, sigma / 2^k), then every
/// middle of a side the mean of its 4 neighbours (2 ends, 2 centres; on the border 3) + N(0, sigma / 2^k). The i-th deviate is the i-th of
/// Random(seed); they are drawn in the order of the steps: in each round the centres row by row, then the middles row by row.
/// A step a sample ("square", "diamond"), one when a round is over ("interpolate"), one for the stretching ("normalise"). While it runs the
/// value is the whole grid, what is not known yet being bilinear.
Generator diamondSquare(DiamondSquare parameters, Stage<HeightMap>& stage);

}  // namespace mw
