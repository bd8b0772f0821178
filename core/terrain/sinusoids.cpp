// The sum over both axes is made of one row of values.
#include "core/terrain/sinusoids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mw {

Generator sinusoids(Sinusoids parameters, Stage<HeightMap>& stage)
{
    const size_t n = size_t(parameters.size);
    std::vector<double> g(n, 0.0);
    const auto map = [&] {
        const auto [low, high] = std::minmax_element(g.begin(), g.end());
        const double least = 2 * *low, scale = *high > *low ? 1 / (2 * (*high - *low)) : 0;
        Array<float> heights(n * n);
        for (size_t y = 0; y < n; ++y)
            for (size_t x = 0; x < n; ++x) heights[y * n + x] = float((g[x] + g[y] - least) * scale);
        return HeightMap(uint32_t(n), uint32_t(n), heights);
    };
    stage.show(map);
    for (int64_t k = 0; k < parameters.harmonics; ++k) {
        const double frequency = std::ldexp(parameters.until, int(k)), weight = std::ldexp(1.0, -int(k));
        for (size_t i = 0; i < n; ++i) g[i] += weight * std::sin(2 * std::numbers::pi * frequency * double(i) / double(n - 1));
        co_yield Step("wave")
            .number("wave", double(k + 1))
            .number("frequency", frequency)
            .number("weight", weight)
            .progress(double(k + 1) / double(parameters.harmonics + 1));
    }
    stage.finish(map());
}

}  // namespace mw
