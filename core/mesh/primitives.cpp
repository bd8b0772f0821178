// The icosphere: triangles of nearly equal size, unlike a sphere of longitudes and latitudes.
#include "core/mesh/primitives.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/mesh/connectivity.h"

namespace mw {

namespace {

/// Positions on the unit sphere, in double until the end, and triangles.
struct Ball {
    std::vector<glm::dvec3> points;
    Array<uint32_t> triangles;
    Mesh mesh(double radius) const
    {
        Array<glm::vec3> positions(points.size());
        for (size_t i = 0; i < points.size(); ++i) positions[i] = glm::vec3(points[i] * radius);
        return Mesh::triangles(std::move(positions), triangles);
    }
};

/// Corners of three golden rectangles.
Ball icosahedron()
{
    const double g = std::numbers::phi;
    Ball b;
    for (const double s : {-1., 1.})
        for (const double t : {-g, g}) {
            b.points.emplace_back(0, s, t);
            b.points.emplace_back(s, t, 0);
            b.points.emplace_back(t, 0, s);
        }
    for (glm::dvec3& p : b.points) p = glm::normalize(p);
    // Every three points that are neighbours of each other, outside anticlockwise. Neighbours are 63.4 degrees apart, others 116.6 or more.
    const auto near = [&](uint32_t i, uint32_t j) { return glm::dot(b.points[i], b.points[j]) > 0.4; };
    for (uint32_t i = 0; i < 12; ++i)
        for (uint32_t j = i + 1; j < 12; ++j)
            for (uint32_t k = j + 1; k < 12; ++k) {
                if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
                const bool outwards = glm::dot(glm::cross(b.points[i], b.points[j]), b.points[k]) > 0;
                b.triangles.insert(b.triangles.end(), {i, outwards ? j : k, outwards ? k : j});
            }
    return b;
}

Ball cutInFour(const Ball& coarse)
{
    const EdgeSides edges = edgeSidesOf(coarse.mesh(1));
    const uint32_t old = uint32_t(coarse.points.size());
    Ball fine;
    fine.points = coarse.points;
    fine.points.reserve(old + edges.size());
    Array<uint32_t> middle(coarse.triangles.size());  // of each side
    for (uint32_t e = 0; e < edges.size(); ++e) {
        fine.points.push_back(glm::normalize(coarse.points[edges.ends[2 * e]] + coarse.points[edges.ends[2 * e + 1]]));
        for (const uint32_t c : edges.sides(e)) middle[c] = old + e;
    }
    fine.triangles.reserve(4 * coarse.triangles.size());
    for (size_t c = 0; c < coarse.triangles.size(); c += 3) {
        const uint32_t *v = &coarse.triangles[c], *m = &middle[c];
        fine.triangles.insert(fine.triangles.end(), {v[0], m[0], m[2], m[0], v[1], m[1], m[2], m[1], v[2], m[0], m[1], m[2]});
    }
    return fine;
}

}  // namespace

Generator icosphere(Icosphere parameters, Stage<Mesh>& stage)
{
    Ball ball = icosahedron();
    stage.show([&] { return ball.mesh(parameters.radius); });
    for (int64_t level = 0; level < parameters.subdivisions; ++level) {
        co_yield Step("subdivide")
            .number("level", double(level))
            .number("triangles", double(ball.triangles.size() / 3))
            .progress(std::pow(4.0, double(level - parameters.subdivisions)));
        ball = cutInFour(ball);
    }
    stage.finish(ball.mesh(parameters.radius));
}

}  // namespace mw
