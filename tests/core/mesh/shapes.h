// Meshes with known figures, for tests.
#pragma once
#include <cmath>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw::test {

/// Collects vertices and polygons.
struct Polygons {
    Array<glm::vec3> positions;
    Array<uint32_t> start{0u}, corners;

    /// n vertices in general position (of no meaning).
    static Polygons points(uint32_t n)
    {
        Polygons p;
        for (uint32_t i = 0; i < n; ++i) p.positions.emplace_back(float(i * i % 17), float(i * 5 % 11), float(i % 7));
        return p;
    }
    Polygons& face(std::initializer_list<uint32_t> f)
    {
        corners.insert(corners.end(), f.begin(), f.end());
        start.push_back(uint32_t(corners.size()));
        return *this;
    }
    Mesh mesh() const { return Mesh(positions, start, corners); }
};

inline Polygons tetrahedron()
{
    Polygons p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    p.face({0, 2, 1}).face({0, 1, 3}).face({0, 3, 2}).face({1, 2, 3});
    return p;
}

/// Unit cube of quads; vertex 4x + 2y + z.
inline Polygons cube()
{
    Polygons p;
    for (int i = 0; i < 8; ++i) p.positions.emplace_back(i >> 2, i >> 1 & 1, i & 1);
    p.face({0, 1, 3, 2}).face({4, 6, 7, 5}).face({0, 4, 5, 1}).face({2, 3, 7, 6}).face({0, 2, 6, 4}).face({1, 5, 7, 3});
    return p;
}

/// n x n cells; a torus when wrapped, else a flat square.
inline Polygons grid(uint32_t n, bool wrap, bool quads)
{
    Polygons p;
    const uint32_t m = wrap ? n : n + 1;
    for (uint32_t y = 0; y < m; ++y)
        for (uint32_t x = 0; x < m; ++x) {
            const double u = 2 * std::numbers::pi * x / n, v = 2 * std::numbers::pi * y / n;
            if (wrap)
                p.positions.emplace_back((3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v));
            else
                p.positions.emplace_back(float(x) / float(n), float(y) / float(n), 0.f);
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * m + x, b = y * m + (x + 1) % m, c = (y + 1) % m * m + (x + 1) % m, d = (y + 1) % m * m + x;
            if (quads)
                p.face({a, b, c, d});
            else
                p.face({a, b, c}).face({a, c, d});
        }
    return p;
}

/// A closed band of n quads with half a twist.
inline Polygons moebius(uint32_t n)
{
    Polygons p;
    for (uint32_t i = 0; i < n; ++i) {
        const double u = 2 * std::numbers::pi * i / n;
        for (const double s : {-0.3, 0.3})
            p.positions.emplace_back((1 + s * std::cos(u / 2)) * std::cos(u), (1 + s * std::cos(u / 2)) * std::sin(u), s * std::sin(u / 2));
    }
    for (uint32_t i = 0; i + 1 < n; ++i) p.face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    p.face({2 * n - 2, 1, 0, 2 * n - 1});
    return p;
}

}  // namespace mw::test
