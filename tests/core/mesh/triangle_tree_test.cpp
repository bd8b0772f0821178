// The tree of triangles against holding every triangle against the point.
#include "core/mesh/triangle_tree.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

#include "core/catalog/others.h"
#include "core/math/closest.h"

namespace mw {
namespace {

glm::dvec3 anyPoint(std::mt19937& r, double reach)
{
    std::uniform_real_distribution<double> u(-reach, reach);
    const double x = u(r), y = u(r), z = u(r);
    return {x, y, z};
}

Mesh sphere(int subdivisions)
{
    return *meshOfSource("icosphere:subdivisions=" + std::to_string(subdivisions));
}

ClosestPoint bruteForce(const Mesh& mesh, const glm::dvec3& p)
{
    const auto& t = mesh.triangulation();
    ClosestPoint best;
    for (uint32_t i = 0; i < t.faces.size(); ++i) {
        glm::dvec3 c[3];
        for (size_t k = 0; k < 3; ++k) c[k] = mesh.positions()[t.vertices[3 * i + k]];
        const glm::dvec3 w = closestOnTriangle(p, c[0], c[1], c[2]), at = w.x * c[0] + w.y * c[1] + w.z * c[2], gap = at - p;
        const double d = glm::dot(gap, gap);
        if (d < best.distance2) best = {i, t.faces[i], w, at, d};
    }
    return best;
}

void expectSame(const ClosestPoint& a, const ClosestPoint& b)
{
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.face, b.face);
    EXPECT_EQ(a.distance2, b.distance2);
    EXPECT_EQ(a.at, b.at);
    EXPECT_EQ(a.weights, b.weights);
}

TEST(TriangleTree, FindsWhatTryingAllFinds)
{
    std::mt19937 r(5);
    for (const char* source : {"icosphere:subdivisions=3", "icosphere:subdivisions=0", "torus", "box"}) {
        const Mesh mesh = *meshOfSource(source);
        const TriangleTree tree(mesh);
        uint32_t near = none;
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 p = anyPoint(r, 1.6);
            const ClosestPoint all = bruteForce(mesh, p), found = tree.closest(p);
            expectSame(found, all);
            expectSame(tree.closest(p, near), all);  // a hint changes nothing
            near = found.triangle;
        }
    }
}

// At a vertex six triangles and more are as close; the one of the lowest number is meant, on every way through the tree.
TEST(TriangleTree, TiesGoToTheLowest)
{
    const Mesh mesh = sphere(3);
    const TriangleTree tree(mesh);
    const Shared<uint32_t>& corners = mesh.triangulation().vertices;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        const uint32_t lowest = uint32_t((std::find(corners.begin(), corners.end(), v) - corners.begin()) / 3);
        for (const uint32_t near : {none, uint32_t(tree.size() - 1), lowest}) {
            const ClosestPoint found = tree.closest(mesh.positions()[v], near);
            EXPECT_EQ(found.distance2, 0);
            EXPECT_EQ(found.triangle, lowest) << v;
        }
    }
}

TEST(TriangleTree, ManyAtOnceAreTheSameAsOneByOne)
{
    std::mt19937 r(9);
    const Mesh mesh = sphere(4);
    const TriangleTree tree(mesh);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 30000; ++i) points.push_back(anyPoint(r, 2));
    const std::vector<ClosestPoint> found = closestPoints(tree, points);
    ASSERT_EQ(found.size(), points.size());
    for (size_t i = 0; i < points.size(); i += 7) expectSame(found[i], tree.closest(points[i]));
    Progress cancelled;
    cancelled.cancelled = true;
    EXPECT_THROW(closestPoints(tree, points, &cancelled), Cancelled);
}

TEST(TriangleTree, TheWalkOpensWhatItNeedsAndPassesOverTheRest)
{
    const Mesh mesh = sphere(5);
    const TriangleTree tree(mesh);
    ClosestWalk walk(tree, {0.3, 1.4, -0.2});
    size_t opened = 0, leaves = 0, pruned = 0;
    double last = std::numeric_limits<double>::infinity();
    for (;;) {
        const ClosestWalk::Event e = walk.next();
        if (e == ClosestWalk::Event::End) break;
        opened += e == ClosestWalk::Event::Opened;
        leaves += e == ClosestWalk::Event::Leaf;
        pruned += e == ClosestWalk::Event::Pruned;
        EXPECT_LE(walk.best().distance2, last);  // it only gets better
        last = walk.best().distance2;
        if (e == ClosestWalk::Event::Pruned) {
            EXPECT_GE(walk.nodeDistance2(), last * (1 - 1e-9));
        }
    }
    EXPECT_EQ(opened + 1, leaves + pruned);  // a binary tree
    EXPECT_LT(leaves, 60u);                  // of 8192 leaves
    expectSame(walk.best(), bruteForce(mesh, {0.3, 1.4, -0.2}));
}

TEST(TriangleTree, TakesPolygonsDegenerateTrianglesAndNothing)
{
    EXPECT_EQ(TriangleTree(Mesh()).closest({1, 2, 3}).triangle, none);
    const Array<glm::vec3> line{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 5, 5}};
    const Mesh flat = Mesh::triangles(line, Array<uint32_t>{0, 1, 2, 3, 3, 3});  // a line and a point
    const TriangleTree tree(flat);
    EXPECT_NEAR(tree.closest({2, 4, 0}).distance2, 16, 1e-12);
    EXPECT_NEAR(tree.closest({2.5, 0, 0}).distance2, 0, 1e-24);
    EXPECT_NEAR(tree.closest({5, 5, 6}).distance2, 1, 1e-12);
    EXPECT_EQ(tree.closest({5, 5, 6}).face, 1u);
    EXPECT_EQ(tree.closest({NAN, 0, 0}).triangle, none);
}

// Triangles so thin that their area is lost in rounding: the nearest point is on a side.
TEST(TriangleTree, ThinTrianglesGiveTheNearestPointOfTheirSides)
{
    std::mt19937 r(3);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 a = anyPoint(r, 1), b = anyPoint(r, 1), p = anyPoint(r, 2);
        const double t = std::uniform_real_distribution<double>(0, 1)(r);
        const glm::dvec3 c = a + t * (b - a);  // off the line by rounding alone
        const glm::dvec3 w = closestOnTriangle(p, a, b, c), at = w.x * a + w.y * b + w.z * c;
        const double s = closestOnSegment(p, a, b);
        EXPECT_NEAR(glm::distance(at, p), glm::distance(a + s * (b - a), p), 1e-9);
        EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
        EXPECT_GE(std::min({w.x, w.y, w.z}), -1e-12);
    }
}

}  // namespace
}  // namespace mw
