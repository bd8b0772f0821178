// Picking against ray casting on the CPU, over a grid of pixels.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "shapes.h"

namespace mw {
namespace {

using namespace test;

constexpr glm::ivec2 size{320, 200};

struct Hit {
    const DrawObject* object = nullptr;
    uint32_t face = none;
    double distance = 1e300;
    double margin = 0;  ///< least barycentric coordinate: near 0 the pixel's centre lies on an edge
};

glm::dvec3 worldOf(const DrawObject& o, uint32_t v)
{
    return o.worldFromLocal * glm::dvec4(glm::dvec3(o.mesh.positions()[v]), 1);
}

/// All triangles, one by one.
Hit cast(const Frame& f, const Ray& r)
{
    Hit best;
    for (const DrawObject& o : f.objects) {
        const Mesh::Triangulation& t = o.mesh.triangulation();
        for (size_t i = 0; i < t.faces.size(); ++i) {
            const glm::dvec3 a = worldOf(o, t.vertices[3 * i]), u = worldOf(o, t.vertices[3 * i + 1]) - a, v = worldOf(o, t.vertices[3 * i + 2]) - a;
            const glm::dvec3 p = glm::cross(r.direction, v), s = r.origin - a, q = glm::cross(s, u);
            const double det = glm::dot(u, p);
            if (det == 0) continue;
            const double x = glm::dot(s, p) / det, y = glm::dot(r.direction, q) / det, d = glm::dot(v, q) / det;
            const double margin = std::min({x, y, 1 - x - y});
            if (margin >= 0 && d > 0 && d < best.distance) best = {&o, t.faces[i], d, margin};
        }
    }
    return best;
}

bool visible(const Frame& f, const Camera& c, glm::dvec3 p)
{
    const glm::dvec3 pixel = c.project(p, glm::dvec2(size));
    const Ray r = c.ray({pixel.x, pixel.y}, glm::dvec2(size));
    return cast(f, r).distance > glm::dot(p - r.origin, r.direction) * (1 - 1e-5);
}

Frame twoSpheres()
{
    Frame f = frameWith(sphere(2), 6);
    DrawObject second;
    second.node = NodeId{9};
    second.mesh = quadCube();
    second.worldFromLocal = glm::rotate(glm::translate(glm::dmat4(1), {1.1, 0.2, -0.8}), 0.5, glm::dvec3(0.3, 1, 0));
    f.objects.push_back(second);
    f.camera.azimuth = 0.3;
    f.camera.elevation = 0.2;
    return f;
}

TEST(Pick, FacesAgreeWithRayCasting)
{
    Offscreen offscreen(true);
    for (const bool perspective : {true, false}) {
        Frame f = twoSpheres();
        f.camera.perspective = perspective;
        int hits = 0, differ = 0;
        for (int y = 3; y < size.y; y += 7) {
            for (int x = 3; x < size.x; x += 7) {
                const glm::dvec2 pixel(x + 0.5, y + 0.5);
                const Hit expected = cast(f, f.camera.ray(pixel, glm::dvec2(size)));
                const auto pick = offscreen.renderer().pick(f, size, pixel);
                const uint32_t face = pick ? pick->face : none;
                if (!expected.object) {
                    EXPECT_EQ(face, none) << x << " " << y;
                    continue;
                }
                ++hits;
                if (face == expected.face && pick->node == expected.object->node) {
                    const Ray r = f.camera.ray(pixel, glm::dvec2(size));
                    EXPECT_LT(glm::length(r.origin + expected.distance * r.direction - pick->atWorld), 1e-5);
                } else if (expected.margin > 0.01) {
                    ++differ;
                    ADD_FAILURE() << x << " " << y << ": " << face << " for " << expected.face;
                }
            }
        }
        EXPECT_GT(hits, 300);
        EXPECT_EQ(differ, 0);
    }
    EXPECT_EQ(offscreen.messages(), std::vector<std::string>{});
}

TEST(Pick, NearestVisibleVertexAndEdge)
{
    Offscreen offscreen;
    const Frame f = twoSpheres();
    int vertices = 0, edges = 0;
    for (int y = 5; y < size.y; y += 13) {
        for (int x = 5; x < size.x; x += 13) {
            const glm::dvec2 pixel(x + 0.5, y + 0.5);
            const auto pick = offscreen.renderer().pick(f, size, pixel);
            if (!pick || pick->face == none) continue;
            const DrawObject& o = f.objects[pick->node == NodeId{7} ? 0 : 1];
            double nearest = 1e300;
            for (uint32_t v = 0; v < o.mesh.vertexCount(); ++v) {
                const glm::dvec3 p = worldOf(o, v), at = f.camera.project(p, glm::dvec2(size));
                const double d = glm::distance(glm::dvec2(at), pixel);
                if (d < std::min(nearest, 10.0) && visible(f, f.camera, p)) nearest = d;
            }
            if (nearest < 9.9) {
                ASSERT_NE(pick->vertex, none) << x << " " << y;
                const glm::dvec3 at = f.camera.project(worldOf(o, pick->vertex), glm::dvec2(size));
                EXPECT_LE(glm::distance(glm::dvec2(at), pixel), nearest + 0.05) << x << " " << y;
                ++vertices;
            }
            if (pick->edge.x == none) continue;
            ++edges;
            EXPECT_LT(pick->edge.x, pick->edge.y);
            const glm::dvec2 a(f.camera.project(worldOf(o, pick->edge.x), glm::dvec2(size))),
                b(f.camera.project(worldOf(o, pick->edge.y), glm::dvec2(size)));
            const double t = std::clamp(glm::dot(pixel - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            EXPECT_LE(glm::distance(a + t * (b - a), pixel), 7.0);
        }
    }
    EXPECT_GT(vertices, 20);
    EXPECT_GT(edges, 40);
}

TEST(Pick, HiddenVerticesOnlyWithXray)
{
    Offscreen offscreen;
    Frame f = frameWith(quadCube(), 6);
    const glm::dvec3 behind = f.camera.project({-1, -1, -1}, glm::dvec2(size));
    const auto solid = offscreen.renderer().pick(f, size, glm::dvec2(behind));
    ASSERT_TRUE(solid);
    EXPECT_NE(solid->vertex, 0u);
    f.options.xray = true;
    const auto through = offscreen.renderer().pick(f, size, glm::dvec2(behind));
    ASSERT_TRUE(through);
    EXPECT_EQ(through->vertex, 0u);
}

TEST(Pick, LoosePointsAndEmptySpace)
{
    Offscreen offscreen;
    const Frame f = frameWith(Mesh(Array<glm::vec3>{{0, 0, 0}, {1, 1, 0}}, {}, {}));
    const glm::dvec3 at = f.camera.project({1, 1, 0}, glm::dvec2(size));
    const auto pick = offscreen.renderer().pick(f, size, glm::dvec2(at) + glm::dvec2(2, 1));
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->vertex, 1u);
    EXPECT_EQ(pick->face, none);
    EXPECT_LT(glm::length(pick->atWorld - glm::dvec3(1, 1, 0)), 1e-6);
    EXPECT_FALSE(offscreen.renderer().pick(f, size, {3, 3}));
    EXPECT_FALSE(offscreen.renderer().pick(f, size, {-5, 3}));
    EXPECT_FALSE(offscreen.renderer().pick(f, size, {3, 1e6}));
}

TEST(Pick, VisibleFacesInARectangle)
{
    Offscreen offscreen;
    Frame f = frameWith(quadCube(), 6);
    const auto all = offscreen.renderer().visibleFaces(f, size, {{0, 0}, size});
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].first, NodeId{7});
    EXPECT_EQ(all[0].second, std::vector<uint32_t>{1});  // only z = 1 looks at the camera
    EXPECT_TRUE(offscreen.renderer().visibleFaces(f, size, {{0, 0}, {5, 5}}).empty());
    EXPECT_TRUE(offscreen.renderer().visibleFaces(f, size, {{-50, -50}, {-5, 500}}).empty());

    f = twoSpheres();  // the id buffer follows what is drawn
    EXPECT_EQ(offscreen.renderer().visibleFaces(f, size, {{0, 0}, size}).size(), 2u);
}

}  // namespace
}  // namespace mw
