// Large meshes for benchmarks, made or read once.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>
#include <time.h>

#include "core/io/io.h"
#include "core/mesh/mesh.h"

namespace mw::bench {

/// About a million triangles of a knobbly torus with noise of 0.06 % of its diagonal, as a scanner would give; vertices row by row.
inline const Mesh& scanLike()
{
    static const Mesh mesh = [] {
        const uint32_t rows = 400, columns = 1250;
        std::mt19937 random(1);
        Array<glm::vec3> positions;
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < columns; ++x) {
                const double u = 2 * std::numbers::pi * x / columns, v = 2 * std::numbers::pi * y / rows;
                const double r = 1 + 0.15 * std::sin(5 * u) * std::cos(3 * v) + 0.005 * (double(random() % 2001) / 1000 - 1);
                positions.emplace_back((3 + r * std::cos(v)) * std::cos(u), (3 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
            }
        Array<uint32_t> corners;
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < columns; ++x) {
                const uint32_t a = y * columns + x, b = y * columns + (x + 1) % columns, up = (y + 1) % rows * columns;
                const uint32_t c = up + (x + 1) % columns, d = up + x;
                corners.insert(corners.end(), {a, b, c, a, c, d});
            }
        return Mesh::triangles(positions, corners);
    }();
    return mesh;
}

/// The dragon of the test data; an empty mesh without it.
inline const Mesh& dragon()
{
    static const Mesh mesh = [] {
        const char* data = std::getenv("MESHWRIGHT_DATA");
        const std::filesystem::path file = std::filesystem::path(data ? data : "") / "meshes/large/dragon_871k.ply";
        if (!data || !std::filesystem::exists(file)) return Mesh();
        const Scene scene = readFile(file).scene;
        return scene.find(scene.meshes().at(0))->base;
    }();
    return mesh;
}

/// CPU seconds of the quickest of several runs, all threads together: other programs on the machine disturb it little.
template <class F>
double quickest(int runs, const F& f)
{
    const auto now = [] {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    };
    double best = 1e30;
    for (; runs > 0; --runs) {
        const double start = now();
        f();
        best = std::min(best, now() - start);
    }
    return best;
}

}  // namespace mw::bench
