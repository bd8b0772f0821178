// Meshes and colours that the tests of drawing share.
#pragma once
#include <glm/glm.hpp>

#include "core/catalog/catalog.h"
#include "render/offscreen.h"

namespace mw::test {

inline Mesh sphere(int64_t level)
{
    const Operation& op = operation("icosphere");
    return std::get<Mesh>(apply(op, {}, checked(op.parameters, {{"subdivisions", level}})));
}

/// Six quads, corners at +-1.
inline Mesh quadCube()
{
    Array<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    Array<uint32_t> start{0u, 4u, 8u, 12u, 16u, 20u, 24u};
    Array<uint32_t> v{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return Mesh(std::move(p), std::move(start), std::move(v));
}

/// n x n quads in the plane z = 0 from -1 to 1, facing +Z.
inline Mesh plane(uint32_t n)
{
    Array<glm::vec3> p;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) p.emplace_back(2.f * float(x) / float(n) - 1, 2.f * float(y) / float(n) - 1, 0);
    Array<uint32_t> start{0u}, v;
    for (uint32_t y = 0; y < n; ++y) {
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x;
            v.insert(v.end(), {a, a + 1, a + n + 2, a + n + 1});
            start.push_back(uint32_t(v.size()));
        }
    }
    return Mesh(std::move(p), std::move(start), std::move(v));
}

/// One object, nothing else in the view, seen from the front.
inline Frame frameWith(Mesh mesh, double distance = 5)
{
    Frame f;
    f.objects.push_back({});
    f.objects[0].node = NodeId{7};
    f.objects[0].mesh = std::move(mesh);
    f.camera.azimuth = f.camera.elevation = 0;
    f.camera.distance = distance;
    f.options.grid = f.options.axes = f.options.orientationMarker = f.options.legend = false;
    f.options.samples = 0;
    return f;
}

inline glm::ivec4 at(const Picture& p, int x, int y)
{
    const uint8_t* c = p.rgba.data() + 4 * (size_t(y) * size_t(p.width) + size_t(x));
    return {c[0], c[1], c[2], c[3]};
}

/// The colour at the place where a point of the world is seen.
inline glm::ivec4 at(const Picture& p, const Camera& camera, glm::dvec3 world)
{
    const glm::dvec3 pixel = camera.project(world, {p.width, p.height});
    return at(p, int(pixel.x), int(pixel.y));
}

inline int distance(glm::ivec4 a, glm::ivec4 b)
{
    const glm::ivec4 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

}  // namespace mw::test
