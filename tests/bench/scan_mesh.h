// The mesh that the benchmarks measure on when no outside data is there: like a scan, a closed surface of a million small, irregular triangles
// in coherent order, with shape at every scale and noise of the size of a triangle.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/mesh/mesh.h"

namespace mw::bench {

inline double hashNoise(uint32_t i)
{
    uint64_t h = (uint64_t(i) + 1) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 31)) * 0xbf58476d1ce4e5b9u;
    return double((h ^ (h >> 29)) >> 11) / 9007199254740992.0 - 0.5;
}

/// A bumpy torus of 2 * rings * sides triangles; 1,048,576 as it stands.
inline Mesh scanMesh(uint32_t rings = 1024, uint32_t sides = 512)
{
    Array<glm::vec3> positions(size_t(rings) * sides);
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            const uint32_t v = i * sides + j;
            const double a = 2 * std::numbers::pi * (i + 0.5 * hashNoise(3 * v)) / rings,
                         b = 2 * std::numbers::pi * (j + 0.5 * hashNoise(3 * v + 1)) / sides;
            double r = 0.4 + 0.0002 * hashNoise(3 * v + 2);
            for (int octave = 1; octave < 7; ++octave)
                r += 0.03 / octave * std::sin((2 << octave) * a + octave) * std::sin((1 << octave) * b + 2 * octave) / octave;
            positions[v] = glm::vec3((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a), r * std::sin(b));
        }
    Array<uint32_t> corners;
    corners.reserve(6 * positions.size());
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            const uint32_t i1 = (i + 1) % rings, j1 = (j + 1) % sides;
            const uint32_t q[4] = {i * sides + j, i1 * sides + j, i1 * sides + j1, i * sides + j1};
            const uint32_t turn = hashNoise(i * sides + j + 77) > 0 ? 1 : 0;  // either diagonal
            for (uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) corners.push_back(q[(k + turn) % 4]);
        }
    return Mesh::triangles(std::move(positions), std::move(corners));
}

}  // namespace mw::bench
