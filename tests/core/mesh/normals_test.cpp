// Normals of faces, vertices and corners against closed forms. Book 2.7.
#include "core/mesh/normals.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

#include "core/catalog/catalog.h"
#include "core/mesh/weighted_normals.h"

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

constexpr NormalWeight weights[] = {NormalWeight::Area, NormalWeight::Angle, NormalWeight::Plain};

Mesh made(const char* id, const ParameterValues& values)
{
    return std::get<Mesh>(apply(operation(id), std::monostate{}, values));
}

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance);
}

/// Quads cut along the diagonal from their first corner.
Mesh cutCube()
{
    const Mesh quads = cube().mesh();
    Array<uint32_t> t;
    for (size_t f = 0; f < quads.faceCount(); ++f) {
        const auto v = quads.face(f);
        t.insert(t.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
    }
    return Mesh::triangles(quads.positions(), t);
}

}  // namespace

// Formula (2.5): its components are those of the cross product, its length twice the area (by Heron's formula here).
TEST(FaceNormal, ComponentsAreThoseOfTheCrossProduct)
{
    std::mt19937 random(1);
    const auto any = [&] { return float(random() % 2001) / 1000 - 1; };
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 p[3] = {{any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()}};
        const Mesh m = Mesh::triangles(Array<glm::vec3>{p[0], p[1], p[2]}, Array<uint32_t>{0, 1, 2});
        const glm::dvec3 a(p[0]), b(p[1]), c(p[2]), n = areaVector(m, 0);
        const auto component = [&](int y, int z) { return a[y] * (b[z] - c[z]) + b[y] * (c[z] - a[z]) + c[y] * (a[z] - b[z]); };
        expectNear(n, {component(1, 2), component(2, 0), component(0, 1)}, 1e-14);
        const double u = glm::distance(a, b), v = glm::distance(b, c), w = glm::distance(c, a), s = (u + v + w) / 2;
        EXPECT_NEAR(glm::length(n), 2 * std::sqrt(std::max(0., s * (s - u) * (s - v) * (s - w))), 1e-7);
        if (glm::length(n) > 1e-3) expectNear(glm::dvec3(m.faceNormals()[0]), n / glm::length(n), 1e-5);
    }
}

TEST(VertexNormal, CornerOfACubePointsAlongTheDiagonal)
{
    const Mesh m = cube().mesh();
    for (const NormalWeight w : weights) {
        const auto n = vertexNormalsOf(m, w);
        for (uint32_t v = 0; v < 8; ++v) expectNear(glm::dvec3(n[v]), glm::normalize(glm::dvec3(m.positions()[v]) - 0.5), 1e-6);
    }
}

// Faces cut in two count twice in the plain sum; angles add up to the same right angle.
TEST(VertexNormal, OnlyAnglesDoNotDependOnTheCut)
{
    const Mesh m = cutCube();
    std::vector<glm::dvec3> plain(8, glm::dvec3(0));
    for (size_t f = 0; f < m.faceCount(); ++f)
        for (const uint32_t v : m.face(f)) plain[v] += glm::dvec3(m.faceNormals()[f]);
    bool differs = false;
    for (uint32_t v = 0; v < 8; ++v) {
        const glm::dvec3 diagonal = glm::normalize(glm::dvec3(m.positions()[v]) - 0.5);
        expectNear(glm::dvec3(vertexNormalsOf(m, NormalWeight::Angle)[v]), diagonal, 1e-6);
        expectNear(glm::dvec3(vertexNormalsOf(m, NormalWeight::Plain)[v]), glm::normalize(plain[v]), 1e-6);
        expectNear(glm::dvec3(vertexNormalsOf(m, NormalWeight::Area)[v]), glm::normalize(plain[v]), 1e-6);  // all areas are one half
        differs = differs || glm::distance(glm::normalize(plain[v]), diagonal) > 0.1;
    }
    EXPECT_TRUE(differs);
}

TEST(VertexNormal, OnASphereItIsTheRadius)
{
    const Mesh m = made("icosphere", {{"subdivisions", int64_t(4)}});
    for (const NormalWeight w : weights) {
        const auto n = vertexNormalsOf(m, w);
        for (size_t v = 0; v < m.vertexCount(); ++v)
            EXPECT_GT(glm::dot(glm::dvec3(n[v]), glm::normalize(glm::dvec3(m.positions()[v]))), std::cos(0.5 * M_PI / 180));
    }
}

TEST(VertexNormal, ReflexCornerCountsItsWholeAngle)
{
    Polygons p;  // an L in the plane, folded up along one side: the corner inside the L has 270 degrees there and 90 in the wall
    p.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {1, 1, 1}, {2, 1, 1}};
    p.face({0, 1, 2, 3, 4, 5}).face({3, 2, 7, 6});
    const glm::dvec3 up(0, 0, 1), wall(glm::normalize(areaVector(p.mesh(), 1)));
    expectNear(glm::dvec3(vertexNormalsOf(p.mesh(), NormalWeight::Angle)[3]), glm::normalize(3. * up + wall), 1e-6);
}

TEST(CornerNormal, CreasesStaySharpAndTheRestIsSmooth)
{
    const Mesh m = cube().mesh();
    for (const NormalWeight w : weights) {
        const auto sharp = cornerNormalsOf(m, w, 89), smooth = cornerNormalsOf(m, w, 91);
        for (size_t f = 0; f < m.faceCount(); ++f)
            for (uint32_t c = m.faceStart()[f]; c < m.faceStart()[f + 1]; ++c) {
                expectNear(glm::dvec3(sharp[c]), glm::dvec3(m.faceNormals()[f]), 1e-6);
                expectNear(glm::dvec3(smooth[c]), glm::normalize(glm::dvec3(m.positions()[m.cornerVertex()[c]]) - 0.5), 1e-6);
            }
    }
}

TEST(CornerNormal, CylinderHasASmoothWallAndFlatEnds)
{
    const Mesh m = made("cylinder", {});
    const auto n = cornerNormalsOf(m, NormalWeight::Angle, 45);
    size_t wall = 0, ends = 0;
    for (size_t f = 0; f < m.faceCount(); ++f)
        for (uint32_t c = m.faceStart()[f]; c < m.faceStart()[f + 1]; ++c) {
            const glm::dvec3 p(m.positions()[m.cornerVertex()[c]]), face(m.faceNormals()[f]);
            if (std::abs(face.y) > 0.9) {
                expectNear(glm::dvec3(n[c]), face, 1e-6);
                ++ends;
            } else {
                expectNear(glm::dvec3(n[c]), glm::normalize(glm::dvec3(p.x, 0, p.z)), 1e-6);
                ++wall;
            }
        }
    EXPECT_GT(wall, 0u);
    EXPECT_GT(ends, 0u);
}

TEST(NormalsOperation, WritesTheAttribute)
{
    const Mesh m = cutCube();
    const Mesh onVertices = std::get<Mesh>(apply(operation("normals"), m, {{"weight", std::string("angle")}}));
    const Attribute* a = onVertices.find(names::normal, Domain::Vertex);
    ASSERT_NE(a, nullptr);
    EXPECT_NEAR(a->at(7, 0), 1 / std::sqrt(3.), 1e-6);
    const Mesh onCorners = std::get<Mesh>(apply(operation("normals"), onVertices, {{"on", std::string("corners")}}));
    EXPECT_EQ(onCorners.find(names::normal, Domain::Vertex), nullptr);  // in place of it
    ASSERT_NE(onCorners.find(names::normal, Domain::Corner), nullptr);
    for (size_t c = 0; c < m.cornerCount(); ++c)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(onCorners.find(names::normal)->at(c, k), m.faceNormals()[c / 3][k], 1e-6);
    Polygons lonely = tetrahedron();
    lonely.positions.emplace_back(5.f, 5.f, 5.f);
    EXPECT_EQ(std::get<Mesh>(apply(operation("normals"), lonely.mesh(), {})).find(names::normal)->at(4, 2), 1);
}
