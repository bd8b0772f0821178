// One edge at a time: counts of legal collapses, and each reason against one on a mesh made for it.
#include "core/simplify/collapse_edge.h"

#include <gtest/gtest.h>

#include "core/catalog/others.h"
#include "core/mesh/topology.h"
#include "tests/core/algorithm_meshes.h"

namespace mw::test {
namespace {

Mesh sphere()
{
    return *meshOfSource("icosphere:subdivisions=2");
}

Mesh sheet()
{
    const Mesh quads = *meshOfSource("grid:columns=4,rows=4");
    return Mesh::triangles(quads.positions(), quads.triangulation().vertices);
}

std::string edgeText(const Mesh& m, size_t e)
{
    return "edge=" + std::to_string(m.edges()[2 * e]) + "~" + std::to_string(m.edges()[2 * e + 1]);
}

std::string refusalOf(const Mesh& m, const std::string& parameters)
{
    try {
        applied("collapse-edge", m, parameters.c_str());
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

TEST(CollapseEdge, LegalOnesTakeOneVertexThreeEdgesTwoFaces)
{
    const Mesh m = sphere();
    for (size_t e = 0; e < m.edges().size() / 2; e += 7) {
        const Mesh out = applied("collapse-edge", m, edgeText(m, e).c_str());
        EXPECT_EQ(out.vertexCount() + 1, m.vertexCount());
        EXPECT_EQ(out.edges().size() / 2 + 3, m.edges().size() / 2);
        EXPECT_EQ(out.faceCount() + 2, m.faceCount());
        EXPECT_EQ(out.topology().euler, 2);
    }
}

TEST(CollapseEdge, GoesWhereItWasTold)
{
    const Mesh m = sphere();
    const uint32_t a = m.edges()[10], b = m.edges()[11];
    const auto has = [](const Mesh& out, const glm::vec3& p) {
        for (const glm::vec3& q : out.positions())
            if (glm::distance(p, q) < 1e-5f) return true;
        return false;
    };
    const std::string forth = "edge=" + std::to_string(a) + "~" + std::to_string(b), back = "edge=" + std::to_string(b) + "~" + std::to_string(a);
    const glm::vec3 p = m.positions()[a], q = m.positions()[b];
    EXPECT_TRUE(has(applied("collapse-edge", m, (forth + ",place=middle").c_str()), 0.5f * (p + q)));
    const Mesh first = applied("collapse-edge", m, (forth + ",place=first").c_str());
    EXPECT_TRUE(has(first, p));
    EXPECT_FALSE(has(first, q));
    const Mesh second = applied("collapse-edge", m, (back + ",place=first").c_str());
    EXPECT_TRUE(has(second, q));
    EXPECT_FALSE(has(second, p));
    // On a sphere the planes of the faces meet outside it.
    double farthest = 0;
    const Mesh best = applied("collapse-edge", m, forth.c_str());
    for (const glm::vec3& v : best.positions()) farthest = std::max(farthest, double(glm::length(v)));
    EXPECT_GT(farthest, glm::length(p) * 1.001);
}

TEST(CollapseEdge, EachReasonIsTold)
{
    EXPECT_NE(refusalOf(tetrahedron().mesh(), "edge=0~1").find("may not be collapsed"), std::string::npos);
    // Two vertices with a third neighbour in common: a ring of three round a prism.
    Polygons prism;
    prism.positions = {{1, 0, 0},          {-0.5f, 0.87f, 0}, {-0.5f, -0.87f, 0}, {1, 0, 2},         {-0.5f, 0.87f, 2},
                       {-0.5f, -0.87f, 2}, {1, 0, 4},         {-0.5f, 0.87f, 4},  {-0.5f, -0.87f, 4}};
    for (uint32_t level = 0; level < 2; ++level)
        for (uint32_t i = 0; i < 3; ++i) {
            const uint32_t a = 3 * level + i, b = 3 * level + (i + 1) % 3;
            prism.face({a, b, b + 3}).face({a, b + 3, a + 3});
        }
    prism.face({2, 1, 0}).face({6, 7, 8});
    const std::string link = refusalOf(prism.mesh(), "edge=3~4,place=middle");
    EXPECT_NE(link.find("share another neighbour"), std::string::npos) << link;
    // An inner edge between two border vertices.
    Polygons strip;
    strip.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
    strip.face({0, 1, 3}).face({0, 3, 2}).face({2, 3, 5}).face({2, 5, 4});
    const std::string border = refusalOf(strip.mesh(), "edge=2~3");
    EXPECT_NE(border.find("borders or seams"), std::string::npos) << border;
    // A face whose normal flips: the new place is beyond a neighbour.
    Polygons bent;
    bent.positions = {{0, 0, 0}, {2, 0, 0}, {1, 3, 0}, {1, -3, 0}, {3, 0.2f, 0}, {2.2f, 3, 0}, {2.2f, -3, 0}, {-2, 0, 0}};
    bent.face({0, 1, 2}).face({0, 3, 1}).face({1, 5, 2}).face({1, 4, 5}).face({1, 6, 4}).face({1, 3, 6}).face({0, 2, 7}).face({0, 7, 3});
    Mesh flipped = bent.mesh();
    Array<glm::vec3> moved(flipped.positions().begin(), flipped.positions().end());
    moved[5] = {0.4f, 0.6f, 0};  // the ring of 1 reaches round 0: moved to 0, face 1 5 2 turns over
    flipped = flipped.withPositions(std::move(moved));
    const std::string turn = refusalOf(flipped, "edge=0~1,place=first");
    EXPECT_TRUE(turn.find("turn over") != std::string::npos || turn.find("fold") != std::string::npos) << turn;
    EXPECT_NE(refusalOf(sphere(), "edge=0~99").find("no edge"), std::string::npos);
    EXPECT_NE(refusalOf(sphere(), "edge=0~1;1~2").find("more than one"), std::string::npos);
    // Three faces at an edge.
    Polygons book;
    book.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    book.face({0, 1, 2}).face({0, 1, 3}).face({0, 1, 4});
    EXPECT_NE(refusalOf(book.mesh(), "edge=0~2").find("no surface"), std::string::npos);
}

TEST(CollapseEdge, BorderEdgesStayOnTheBorder)
{
    const Mesh m = sheet();
    size_t legal = 0;
    for (size_t e = 0; e < m.edges().size() / 2; ++e) {
        EdgeCollapser c(m);
        const auto j = c.judge(m.edges()[2 * e], m.edges()[2 * e + 1], CollapsePlace::Optimal);
        EXPECT_EQ(reasonAgainst(j).empty(), j.legal());
        if (!j.legal()) continue;
        const Mesh out = c.collapsed(j);
        EXPECT_EQ(out.topology().euler, 1);
        EXPECT_EQ(out.topology().boundaryLoops.size(), 1u);
        EXPECT_TRUE(out.topology().manifold());
        ++legal;
    }
    EXPECT_GT(legal, 20u);
}

}  // namespace
}  // namespace mw::test
