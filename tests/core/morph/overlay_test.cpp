// Overlays of two meshes: both ends are the meshes themselves, whatever coincides; counts against a count of their own.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

#include "core/catalog/others.h"
#include "core/mesh/topology.h"
#include "core/morph/morph_maps.h"
#include "core/morph/target.h"
#include "tests/mesh_checks.h"

namespace mw {
namespace {

Mesh turned(const Mesh& mesh, glm::dvec3 axis, double angle, double scale = 1)
{
    const glm::dmat4 m = glm::rotate(glm::dmat4(1), angle, glm::normalize(axis));
    Array<glm::vec3> p;
    for (const glm::vec3& v : mesh.positions()) p.push_back(glm::vec3(scale * glm::dvec3(m * glm::dvec4(v, 1))));
    return mesh.withPositions(p);
}

Mesh tetrahedron()
{
    return Mesh::triangles(Array<glm::vec3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, Array<uint32_t>{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2});
}

Overlay overlaid(MorphMaps& maps)
{
    Overlay o(std::move(maps.maps[0]), std::move(maps.maps[1]));
    o.locate();
    for (const int of : {0, 1}) {
        while (o.locateMore(of, 100)) {
        }
        o.trace(of, 0, uint32_t(o.input(of).map.edges()));
    }
    while (o.connect()) {
    }
    while (o.fill(100)) {
    }
    return o;
}

/// Proper crossings of edges of two convex solids seen from the origin, by side tests in double: none may be near 0.
size_t crossings(const Mesh& a, const Mesh& b)
{
    size_t n = 0;
    const auto at = [](const Mesh& m, uint32_t v) { return glm::normalize(glm::dvec3(m.positions()[v])); };
    const auto det = [](glm::dvec3 u, glm::dvec3 v, glm::dvec3 w) { return glm::dot(u, glm::cross(v, w)); };
    for (size_t i = 0; i < a.edges().size(); i += 2)
        for (size_t k = 0; k < b.edges().size(); k += 2) {
            const glm::dvec3 p = at(a, a.edges()[i]), q = at(a, a.edges()[i + 1]), u = at(b, b.edges()[k]), v = at(b, b.edges()[k + 1]);
            const double s[4] = {det(p, q, u), det(p, q, v), det(u, v, p), det(u, v, q)};
            for (const double x : s) EXPECT_GT(std::abs(x), 1e-9);
            n += s[0] * s[1] < 0 && s[2] * s[3] < 0 && s[0] * s[3] > 0;  // the last: on one side of the sphere
        }
    return n;
}

void expectEnds(const Mesh& a, const Mesh& b, size_t* coincident = nullptr, bool closed = true)
{
    MorphMaps maps = projectiveMaps(a, b);
    const Overlay o = overlaid(maps);
    const Mesh result = morphed(o, maps.meshes[0], "x"), last = towardsTarget(result, 1);
    EXPECT_TRUE(test::checkMesh(result));
    const TopologyReport t = result.topology();
    EXPECT_TRUE(t.manifold());
    EXPECT_TRUE(t.consistentlyOriented);
    EXPECT_EQ(t.closed, closed);
    EXPECT_EQ(t.euler, closed ? 2 : 1);
    EXPECT_TRUE(t.isolatedVertices.empty());
    EXPECT_TRUE(t.degenerateFaces.empty());
    EXPECT_EQ(result.vertexCount(), a.vertexCount() + b.vertexCount() + o.crossings() - o.coincident());
    EXPECT_NEAR(enclosedVolume(result), enclosedVolume(a), 1e-6 * enclosedVolume(a));
    EXPECT_NEAR(surfaceArea(result), surfaceArea(a), 1e-6 * surfaceArea(a));
    EXPECT_NEAR(enclosedVolume(last), enclosedVolume(b), 1e-6 * enclosedVolume(b));
    EXPECT_NEAR(surfaceArea(last), surfaceArea(b), 1e-6 * surfaceArea(b));
    for (size_t c = 0; c < o.corners().size(); ++c) {  // sides along an edge of a mesh lie on it: both ends do
        for (const int in : {0, 1}) {
            const glm::dvec3 w = o.weightsIn(in, o.triangleOf(in, c / 3), o.corners()[c]);
            EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
            EXPECT_GE(std::min({w.x, w.y, w.z}), 0);
        }
    }
    if (coincident) *coincident = o.coincident();
}

TEST(Overlay, OfTetrahedronAndCube)
{
    // Turned so that no corner lies on an edge, and so that the count is the one the book's figure has.
    const Mesh cube = *meshOfSource("box");
    const Mesh tetra = turned(tetrahedron(), {-0.7, -0.9, 0}, 0.48);
    const Mesh triangles = Mesh::triangles(cube.positions(), cube.triangulation().vertices);
    EXPECT_EQ(crossings(tetra, triangles), 13u);
    MorphMaps maps = projectiveMaps(tetra, cube);
    const Overlay o = overlaid(maps);
    EXPECT_EQ(o.crossings(), 13u);
    EXPECT_EQ(o.vertices(), 25u);
    EXPECT_EQ(o.corners().size() / 3, 2 * 25u - 4);
    expectEnds(tetra, cube);
}

TEST(Overlay, CountsCrossingsAsALoopOverAllPairsDoes)
{
    for (int i = 0; i < 12; ++i) {
        const Mesh a = *meshOfSource("icosphere:subdivisions=" + std::to_string(i % 3)),
                   b = turned(*meshOfSource("uv-sphere:segments=9,rings=5"), {1, 0.2 * i, 0.7}, 0.31 + 0.17 * i, 2.5);
        const Mesh triangles = Mesh::triangles(b.positions(), b.triangulation().vertices);
        MorphMaps maps = projectiveMaps(a, b);
        EXPECT_EQ(overlaid(maps).crossings(), crossings(a, triangles)) << i;
        expectEnds(a, b);
    }
}

TEST(Overlay, OfEqualMeshesAddsNothing)
{
    const Mesh a = *meshOfSource("icosphere:subdivisions=2");
    size_t coincident = 0;
    expectEnds(a, a, &coincident);
    EXPECT_EQ(coincident, a.vertexCount());
    MorphMaps maps = projectiveMaps(a, turned(a, {0, 1, 0}, 0, 4));
    EXPECT_EQ(overlaid(maps).vertices(), a.vertexCount()) << "scaled, too";
}

TEST(Overlay, OfFinerMeshesHasVerticesOnEdges)
{
    // The coarse edges run through vertices and along edges of the finer ones.
    const Mesh coarse = *meshOfSource("box"), fine = *meshOfSource("box:segments=4"), finer = *meshOfSource("box:segments=6");
    size_t coincident = 0;
    expectEnds(coarse, fine, &coincident);
    EXPECT_EQ(coincident, 8u);
    expectEnds(fine, coarse);
    expectEnds(fine, finer, &coincident);
    EXPECT_EQ(coincident, 6 * 2 * 2 + 2u) << "every second of the coarser lies on every third of the finer";
    expectEnds(*meshOfSource("icosphere:subdivisions=1"), *meshOfSource("icosphere:subdivisions=3"));
}

TEST(Overlay, OfSolidsWithTheSameSymmetriesIsExact)
{
    // Cube, octahedron-like sphere, tetrahedron in a cube: corners on edges and in the middle of faces, edges that cross at corners.
    const Mesh cube = *meshOfSource("box"), octa = *meshOfSource("uv-sphere:segments=4,rings=2"),
               sphere = *meshOfSource("uv-sphere:segments=8,rings=4");
    for (const Mesh& a : {cube, octa, sphere, tetrahedron()})
        for (const Mesh& b : {cube, octa, sphere, tetrahedron()}) expectEnds(a, b);
}

TEST(Overlay, OfRandomHullsKeepsBothEnds)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> u(0.6f, 1.4f);
    for (int i = 0; i < 20; ++i) {
        const auto bumpy = [&](int subdivisions) {  // star-shaped
            const Mesh m = *meshOfSource("icosphere:subdivisions=" + std::to_string(subdivisions));
            Array<glm::vec3> p;
            for (const glm::vec3& v : m.positions()) p.push_back(u(random) * v);
            return turned(m.withPositions(p), {u(random), u(random), -1}, u(random));
        };
        expectEnds(bumpy(1), bumpy(i % 4));
    }
}

TEST(Direction, SidesAreExact)
{
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int64_t> any(-(int64_t(1) << 40), int64_t(1) << 40), few(-3, 3);
    for (int i = 0; i < 20000; ++i) {
        const Direction a{any(random), any(random), any(random)}, b{any(random), any(random), any(random)};
        const int64_t s = few(random), t = few(random);
        Direction c{(s * a.x + t * b.x) / 8 * 8 / 8, 0, 0};
        c = {s * (a.x >> 3) + t * (b.x >> 3), s * (a.y >> 3) + t * (b.y >> 3), s * (a.z >> 3) + t * (b.z >> 3)};
        const Direction a8{a.x >> 3, a.y >> 3, a.z >> 3}, b8{b.x >> 3, b.y >> 3, b.z >> 3};
        EXPECT_EQ(side(a8, b8, c), 0);
        if (c == Direction{}) continue;
        const Direction lifted{c.x, c.y, c.z + 1};
        const Wide turn = Wide(a8.x) * b8.y - Wide(a8.y) * b8.x;
        EXPECT_EQ(side(a8, b8, lifted), turn > 0 ? 1 : turn < 0 ? -1 : 0);
    }
}

}  // namespace
}  // namespace mw
