// Splits: counts, valences, what stays in place, attributes; four parts are two halvings.
#include <gtest/gtest.h>
#include <set>

#include "core/mesh/topology.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

/// A tetrahedron's triangle, the side of a prism and its pentagonal base: faces of 3, 4 and 5 corners.
Mesh mixedFaces()
{
    Polygons p;
    for (int i = 0; i < 5; ++i)
        for (const float z : {0.f, 1.f}) p.positions.emplace_back(std::cos(1.2566f * float(i)), std::sin(1.2566f * float(i)), z);
    p.positions.emplace_back(0, 0, 1.6f);
    p.face({8, 6, 4, 2, 0});
    for (uint32_t i = 0; i < 5; ++i) {
        const uint32_t a = 2 * i, b = 2 * ((i + 1) % 5);
        p.face({a, b, b + 1, a + 1}).face({a + 1, b + 1, 10});
    }
    return p.mesh();
}

using Triangle = std::vector<std::array<int, 3>>;

/// Faces as sorted lists of places, rounded: equal for meshes that differ only in the order of their elements.
std::multiset<Triangle> shapesOf(const Mesh& m)
{
    std::multiset<Triangle> out;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        Triangle t;
        for (const uint32_t v : m.face(f)) {
            const glm::dvec3 p(m.positions()[v]);
            t.push_back({int(std::lround(p.x * 1e4)), int(std::lround(p.y * 1e4)), int(std::lround(p.z * 1e4))});
        }
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        out.insert(t);
    }
    return out;
}

TEST(Split, CountsAreThoseOfTheBook)
{
    const Mesh triangle = Polygons{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0u, 3u}, {0, 1, 2}}.mesh();
    const Mesh quad = Polygons{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0u, 4u}, {0, 1, 2, 3}}.mesh();
    for (const Mesh& m : {triangle, quad}) {
        EXPECT_EQ(applied("split-dyadic", m, "").faceCount(), 4u);
        EXPECT_EQ(applied("split-dyadic", m, "levels=2").faceCount(), 16u);
        for (const char* n : {"2", "3", "5", "8"})
            EXPECT_EQ(applied("split-nadic", m, ("n=" + std::string(n)).c_str()).faceCount(), size_t(std::stoi(n) * std::stoi(n)));
    }
    const auto valences = topologyOf(applied("split-dyadic", triangle, "levels=3")).vertexValences;
    EXPECT_EQ(valences, (std::map<size_t, size_t>{{2, 3}, {4, 21}, {6, 21}})) << "corners, sides, and all inner vertices regular";
    EXPECT_EQ(topologyOf(applied("split-dyadic", quad, "levels=2")).vertexValences, (std::map<size_t, size_t>{{2, 4}, {3, 12}, {4, 9}}));
}

TEST(Split, FourPartsAreTwoHalvings)
{
    for (const Mesh& m : {tetrahedron().mesh(), cube().mesh(), grid(3, true, false).mesh(), moebius(7).mesh()})
        EXPECT_EQ(shapesOf(applied("split-nadic", m, "n=4")), shapesOf(applied("split-dyadic", m, "levels=2")));
    EXPECT_EQ(shapesOf(applied("split-nadic", grid(3, true, false).mesh(), "n=6")),
              shapesOf(applied("split-nadic", applied("split-nadic", grid(3, true, false).mesh(), "n=2"), "n=3")));
}

TEST(Split, ShapeAndTopologyStay)
{
    const Mesh m = mixedFaces();
    ASSERT_EQ(topologyOf(m).genus, 0);
    for (const auto& [id, parameters, count] :
         {std::tuple{"split-dyadic", "", size_t(5 + 5 * 4 + 5 * 4)}, std::tuple{"split-nadic", "n=3", size_t(9 * (3 + 5 + 5))}}) {
        const Mesh out = applied(id, m, parameters);
        const TopologyReport r = topologyOf(out);
        EXPECT_EQ(out.faceCount(), count) << id;
        EXPECT_EQ(r.genus, 0) << id;
        EXPECT_TRUE(r.closed && r.consistentlyOriented) << id;
        EXPECT_NEAR(surfaceArea(out), surfaceArea(m), 1e-5) << id;
        EXPECT_NEAR(enclosedVolume(out), enclosedVolume(m), 1e-5) << id;
        for (size_t v = 0; v < m.vertexCount(); ++v) EXPECT_EQ(out.positions()[v], m.positions()[v]) << id;
    }
}

TEST(Split, AttributesAreLinear)
{
    for (const bool quads : {false, true}) {
        const Mesh bare = grid(5, false, quads).mesh();
        Array<float> texcoord, crease(bare.cornerCount(), 0.f);
        Array<int32_t> material;
        for (size_t f = 0; f < bare.faceCount(); ++f) {
            material.push_back(int32_t(f));
            for (const uint32_t v : bare.face(f)) {  // every face a chart of its own
                texcoord.insert(texcoord.end(), {bare.positions()[v].x + float(f), bare.positions()[v].y - float(f)});
            }
        }
        crease[0] = 0.7f;
        const Mesh m = bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
                           .with(integerAttribute("material", Domain::Face, 1, material))
                           .with(floatAttribute("crease", Domain::Corner, 1, crease));
        for (const auto& [id, parameters, parts] : {std::tuple{"split-dyadic", "levels=2", 4.0}, std::tuple{"split-nadic", "n=3", 3.0}}) {
            const Mesh out = applied(id, m, parameters);
            const Attribute *t = out.find("texcoord"), *face = out.find("material"), *c = out.find("crease");
            ASSERT_TRUE(t && face && c);
            double creased = 0;
            for (size_t f = 0; f < out.faceCount(); ++f)
                for (uint32_t k = out.faceStart()[f]; k < out.faceStart()[f + 1]; ++k) {
                    const glm::vec3 p = out.positions()[out.cornerVertex()[k]];
                    EXPECT_NEAR(t->at(k, 0), p.x + face->at(f, 0), 1e-4);
                    EXPECT_NEAR(t->at(k, 1), p.y - face->at(f, 0), 1e-4);
                    creased += c->at(k, 0);
                }
            EXPECT_NEAR(creased, 0.7 * parts, 1e-5) << id << ": one side becomes several";
        }
    }
}

TEST(Split, SoupStaysSoup)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name :
         {"nonmanifold/fan3.obj", "nonmanifold/hourglass_ico.obj", "nonmanifold/moebius.obj", "nonmanifold/spider.obj", "quads/suzanne.obj"}) {
        const Mesh m = meshOf(data / "meshes" / name);
        const TopologyReport before = topologyOf(m);
        for (const char* id : {"split-dyadic", "split-nadic"}) {
            const TopologyReport after = topologyOf(applied(id, m, std::string(id) == "split-nadic" ? "n=2" : ""));
            EXPECT_EQ(after.nonmanifoldEdges.size(), 2 * before.nonmanifoldEdges.size()) << name;
            EXPECT_EQ(after.boundaryEdges, 2 * before.boundaryEdges) << name;
            EXPECT_EQ(after.components, before.components) << name;
        }
    }
}

TEST(Split, TooMuchIsRefused)
{
    EXPECT_THROW(applied("split-nadic", grid(100, true, false).mesh(), "n=64,levels=2"), Error);
    EXPECT_THROW(applied("split-dyadic", grid(100, true, false).mesh(), "levels=8"), Error);
}

}  // namespace
