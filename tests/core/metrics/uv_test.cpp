// Distortion by closed forms; seams and fold-overs of layouts that can be counted by hand; Euler angles that stay where they were.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "core/catalog/catalog.h"
#include "core/io/io.h"
#include "core/math/euler.h"
#include "core/metrics/uv_distortion.h"
#include "core/metrics/uv_layout.h"
#include "core/parameterize/project_uv.h"
#include "tests/data.h"

namespace mw {
namespace {

using Map = glm::dvec2 (*)(glm::dvec2);

// A quad grid in the plane, tilted in space, with coordinates by `map`.
Mesh tiltedGrid(uint32_t n, Map map)
{
    Array<glm::vec3> p;
    Array<uint32_t> start{0u}, corners;
    Array<float> uv;
    const glm::dvec3 right = glm::normalize(glm::dvec3(1, 2, -1)), up = glm::normalize(glm::cross(right, glm::dvec3(0.3, -1, 2)));
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) p.push_back(double(x) * right + double(y) * up);
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            for (const glm::uvec2 o : {glm::uvec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                corners.push_back((y + o.y) * (n + 1) + x + o.x);
                const glm::dvec2 t = map(glm::dvec2(x + o.x, y + o.y));
                uv.insert(uv.end(), {float(t.x), float(t.y)});
            }
            start.push_back(uint32_t(corners.size()));
        }
    return Mesh(std::move(p), std::move(start), std::move(corners)).with(floatAttribute("texcoord", Domain::Corner, 2, std::move(uv)));
}

Table distortion(const Mesh& mesh, int64_t set = 0)
{
    return std::get<Table>(apply(operation("uv-distortion"), mesh, {{"set", set}}));
}

double summary(const Table& t, const std::string& name)
{
    for (const auto& [n, v] : t.summary)
        if (n == name) return v;
    ADD_FAILURE() << name;
    return 0;
}

TEST(UvDistortion, ScaleAndTurnKeepAngles)
{
    const Table t = distortion(tiltedGrid(4, [](glm::dvec2 p) { return 0.25 * glm::dvec2(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y); }));
    ASSERT_EQ(t.columns[0].values.size(), 16u);
    for (size_t f = 0; f < 16; ++f) {
        EXPECT_NEAR(t.columns[0].values[f], 1, 1e-5);
        EXPECT_NEAR(t.columns[1].values[f], 1, 1e-5);
    }
    EXPECT_EQ(summary(t, "faces folded over"), 0);
}

TEST(UvDistortion, StretchAndShearByTheirClosedForms)
{
    // diag(3, 1): s1/s2 = 3. The shear x + k y has s1 s2 = 1 and s1^2 + s2^2 = 2 + k^2, so s1/s2 = (k + sqrt(k^2 + 4))^2 / 4.
    const Table three = distortion(tiltedGrid(3, [](glm::dvec2 p) { return glm::dvec2(3 * p.x, p.y); }));
    for (const double v : three.columns[0].values) EXPECT_NEAR(v, 3, 1e-5);
    const double k = 1.5, expected = std::pow(k + std::sqrt(k * k + 4), 2) / 4;
    const Table shear = distortion(tiltedGrid(3, [](glm::dvec2 p) { return glm::dvec2(p.x + 1.5 * p.y, p.y); }));
    for (const double v : shear.columns[0].values) EXPECT_NEAR(v, expected, 1e-5);
    EXPECT_NEAR(summary(shear, "mean angle distortion"), expected, 1e-5);
}

TEST(UvDistortion, AreaIsAFactorOfTheMean)
{
    // u = x^2 on four columns: a column's area is 1, 3, 5, 7 and their mean 4.
    const Table t = distortion(tiltedGrid(4, [](glm::dvec2 p) { return glm::dvec2(p.x * p.x, p.y); }));
    for (size_t f = 0; f < 16; ++f) EXPECT_NEAR(t.columns[1].values[f], double(2 * (f % 4) + 1) / 4, 1e-5);
}

TEST(UvDistortion, FacesWithoutAreaHaveNoNumber)
{
    const Mesh m = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, Array<uint32_t>{0, 1, 2, 0, 1, 3})
                       .with(floatAttribute("texcoord", Domain::Corner, 2, Array<float>{0, 0, 1, 0, 2, 0, 0, 0, 0, 0, 0, 0}));
    const Table t = distortion(m);
    EXPECT_TRUE(std::isnan(t.columns[0].values[0]));
    EXPECT_TRUE(std::isnan(t.columns[0].values[1]));  // all of it at one point
    EXPECT_THROW(distortion(m.without("texcoord")), Error);
    EXPECT_THROW(distortion(m, 1), Error);
}

TEST(UvLayout, FoldsAndSeams)
{
    // Folded along x = 2: the faces right of it lie upside down on those left of it; no edge is torn.
    const Mesh folded = tiltedGrid(4, [](glm::dvec2 p) { return glm::dvec2(p.x < 2 ? p.x : 4 - p.x, p.y); });
    const UvLayout f = uvLayoutOf(folded, 0);
    EXPECT_EQ(f.folded.size(), 8u);
    EXPECT_EQ(f.seams, 0u);
    EXPECT_EQ(f.kinds.size(), 40u);
    EXPECT_EQ(size_t(std::count(f.kinds.begin(), f.kinds.end(), UvLayout::Border)), 16u);
    EXPECT_EQ(facesAt(folded, f, {0.5, 0.5}), (std::vector<uint32_t>{0, 3}));
    EXPECT_TRUE(facesAt(folded, f, {5, 5}).empty());
    EXPECT_EQ(f.high, glm::dvec2(2, 4));
}

TEST(UvLayout, ATornEdgeIsDrawnOnBothSides)
{
    const Mesh two = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, Array<uint32_t>{0, 1, 2, 1, 3, 2})
                         .with(floatAttribute("texcoord", Domain::Corner, 2, Array<float>{0, 0, 1, 0, 0, 1, 2, 0, 3, 1, 2, 1}));
    const UvLayout l = uvLayoutOf(two, 0);
    EXPECT_EQ(l.seams, 1u);
    EXPECT_EQ(l.kinds.size(), 6u);
    EXPECT_EQ(size_t(std::count(l.kinds.begin(), l.kinds.end(), UvLayout::Seam)), 2u);
}

TEST(ProjectUv, ABoxIsLaidOutWithoutStretch)
{
    // Twelve triangles of a 2 x 3 x 4 box: six squares apart, every angle kept, all as dense as each other.
    Array<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? 2 : 0, i & 2 ? 3 : 0, i & 4 ? 4 : 0});
    const Mesh box(std::move(p), Array<uint32_t>{0, 4, 8, 12, 16, 20, 24},
                   Array<uint32_t>{1, 3, 7, 5, 0, 4, 6, 2, 2, 6, 7, 3, 0, 1, 5, 4, 4, 5, 7, 6, 0, 2, 3, 1});
    const Mesh laid = box.with(projectedCoordinates(box, UvProjection::Box));
    const Table t = distortion(laid);
    for (size_t f = 0; f < 6; ++f) {
        EXPECT_NEAR(t.columns[0].values[f], 1, 1e-5);
        EXPECT_NEAR(t.columns[1].values[f], 1, 1e-5);
    }
    const UvLayout l = uvLayoutOf(laid, 0);
    EXPECT_TRUE(l.folded.empty());
    EXPECT_EQ(l.seams, 12u);
    EXPECT_GE(std::min(l.low.x, l.low.y), 0);
    EXPECT_LE(std::max(l.high.x, l.high.y), 1);
    // Along Z the four sides of the box have no area, and its back is upside down.
    const UvLayout z = uvLayoutOf(box.with(projectedCoordinates(box, UvProjection::Z)), 0);
    EXPECT_EQ(z.folded, std::vector<uint32_t>{5});
    EXPECT_NEAR(z.areas[4], (0.96 / 4 * 2) * (0.96 / 4 * 3), 1e-6);
}

TEST(UvLayout, RealModels)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported spot = readFile(data / "meshes/closed_genus0/spot.obj");
    const Mesh& mesh = spot.scene.find(spot.scene.meshes().front())->base;
    const UvLayout l = uvLayoutOf(mesh, 0);
    // A closed mesh has no border; every edge once, seams twice.
    EXPECT_EQ(std::count(l.kinds.begin(), l.kinds.end(), UvLayout::Border), 0);
    EXPECT_EQ(l.kinds.size(), mesh.edges().size() / 2 + l.seams);
    EXPECT_GT(l.seams, 0u);
    // The box is that of the file's own vt lines.
    std::ifstream in(data / "meshes/closed_genus0/spot.obj");
    glm::dvec2 low(1e9), high(-1e9);
    for (std::string line; std::getline(in, line);) {
        glm::dvec2 t;
        if (std::sscanf(line.c_str(), "vt %lf %lf", &t.x, &t.y) == 2) low = glm::min(low, t), high = glm::max(high, t);
    }
    EXPECT_LT(glm::distance(l.low, low), 1e-6);
    EXPECT_LT(glm::distance(l.high, high), 1e-6);
    const Imported suzanne = readFile(data / "meshes/quads/suzanne.obj");
    EXPECT_THROW(uvLayoutOf(suzanne.scene.find(suzanne.scene.meshes().front())->base, 0), Error);
}

TEST(Euler, StaysWithWhatWasShown)
{
    for (const glm::dvec3 shown : {glm::dvec3(10, 20, 30), {120, 130, -140}, {5, 90, 40}, {0, 0, 350}, {-200, 80, 725}}) {
        const glm::dquat q(glm::radians(shown));
        EXPECT_EQ(eulerDegreesNear(q, shown), shown);
        // A small step from there is a small step of the numbers, but for the pole, where none is.
        if (shown.y == 90) continue;
        const glm::dvec3 next = shown + glm::dvec3(1, 2, -1);
        EXPECT_LT(glm::distance(eulerDegreesNear(glm::dquat(glm::radians(next)), shown), next), 1e-6);
    }
    const glm::dquat q(glm::radians(glm::dvec3(400, 100, 7)));
    const glm::dquat back(glm::radians(eulerDegreesNear(q, {0, 0, 0})));
    EXPECT_NEAR(std::abs(glm::dot(q, back)), 1, 1e-12);
}

}  // namespace
}  // namespace mw
