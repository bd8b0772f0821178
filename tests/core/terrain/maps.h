// Height maps for tests.
#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "core/terrain/terrain.h"

namespace mw::test {

/// A map whose height at sample (x, y) is f(x, y).
inline HeightMap mapOf(uint32_t width, uint32_t height, const std::function<double(uint32_t, uint32_t)>& f)
{
    Array<float> rows;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) rows.push_back(float(f(x, y)));
    return HeightMap(width, height, rows);
}

/// Hills with some roughness, the same each time.
inline HeightMap hills(uint32_t width, uint32_t height)
{
    std::mt19937 random(5);
    return mapOf(width, height, [&](uint32_t x, uint32_t y) {
        return 0.5 + 0.3 * std::sin(x * 0.05) * std::cos(y * 0.08) + 0.02 * double(random()) / double(std::mt19937::max());
    });
}

inline Terrain terrainOf(HeightMap map, double extent = 1000, double maximumHeight = 100)
{
    Terrain t;
    t.map = std::move(map);
    t.extent = extent;
    t.maximumHeight = maximumHeight;
    return t;
}

}  // namespace mw::test
