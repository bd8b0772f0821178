// The solids of the Add menu against closed forms: counts, genus, exact volumes of prisms and pyramids, texture coordinates.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/catalog/catalog.h"
#include "core/mesh/topology.h"

namespace mw {
namespace {

Mesh made(const char* call)
{
    const std::string text = call;
    const size_t colon = text.find(':');
    const Operation& op = operation(text.substr(0, colon));
    return std::get<Mesh>(apply(op, {}, colon == text.npos ? ParameterValues() : parsed(op.parameters, text.substr(colon + 1))));
}

/// Area of a regular polygon of n vertices at distance r.
double polygon(int n, double r)
{
    return 0.5 * n * r * r * std::sin(2 * std::numbers::pi / n);
}

struct Solid {
    const char* call;
    size_t vertices, faces;
    long genus;
    double volume;
};

TEST(Solids, ClosedOnesHaveTheCountsAndVolumesOfTheirFormulas)
{
    const double whole = 2 * std::numbers::pi;
    const Solid solids[] = {
        {"box:width=1,height=2,depth=3", 8, 6, 0, 6},
        {"box:segments=5", 6 * 25 + 2, 6 * 25, 0, 1},
        {"uv-sphere:segments=8,rings=4", 8 * 3 + 2, 8 * 4, 0, -1},
        {"cylinder:segments=7,radius=2,height=3", 14, 9, 0, 3 * polygon(7, 2)},
        {"cylinder:segments=7,rings=4,caps=fan", 7 * 5 + 2, 7 * 6, 0, polygon(7, 0.5)},
        {"cone:segments=9,radius=2,height=3", 10, 10, 0, polygon(9, 2)},
        {"cone:segments=9,rings=3,caps=fan", 9 * 3 + 2, 9 * 4, 0, polygon(9, 0.5) / 3},
        {"torus:segments=12,sides=5,radius=2,tube=0.5", 60, 60, 1, -1},
    };
    for (const Solid& s : solids) {
        const Mesh m = made(s.call);
        const TopologyReport& r = m.topology();
        EXPECT_EQ(m.vertexCount(), s.vertices) << s.call;
        EXPECT_EQ(m.faceCount(), s.faces) << s.call;
        EXPECT_TRUE(r.closed && r.manifold() && r.consistentlyOriented && r.isolatedVertices.empty()) << s.call;
        EXPECT_EQ(r.genus, s.genus) << s.call;
        if (s.volume > 0) {
            EXPECT_NEAR(enclosedVolume(m), s.volume, 1e-5 * s.volume) << s.call;
        }
    }
    // A ring of n equal pieces whose cross section is a polygon: Pappus with the chord in place of the arc.
    EXPECT_NEAR(enclosedVolume(made("torus:segments=400,sides=5,radius=2,tube=0.5")), polygon(5, 0.5) * whole * 2, 2e-3);
    EXPECT_NEAR(enclosedVolume(made("uv-sphere:segments=256,rings=128,radius=2")), 4. / 3 * std::numbers::pi * 8, 0.01);
}

TEST(Solids, OpenOnesHaveTheirLoops)
{
    EXPECT_EQ(made("cylinder:caps=open").topology().boundaryLoops.size(), 2u);
    EXPECT_EQ(made("cone:caps=open").topology().boundaryLoops.size(), 1u);
    const Mesh g = made("grid:columns=3,rows=2,width=3,depth=2");
    EXPECT_EQ(g.faceCount(), 6u);
    EXPECT_EQ(g.topology().boundaryEdges, 10u);
    EXPECT_NEAR(surfaceArea(g), 6, 1e-6);
    for (const glm::vec3& n : g.faceNormals()) EXPECT_NEAR(n.y, 1, 1e-6);
}

TEST(Solids, TextureCoordinatesFillTheUnitSquare)
{
    for (const char* call : {"box:segments=3", "grid", "uv-sphere", "cylinder", "cone", "torus"}) {
        const Mesh m = made(call);
        const Attribute* uv = m.find("texcoord", Domain::Corner);
        ASSERT_TRUE(uv) << call;
        float least = 1, most = 0;
        for (const float x : uv->floats()) least = std::min(least, x), most = std::max(most, x);
        EXPECT_NEAR(least, 0, 1e-6) << call;
        EXPECT_NEAR(most, 1, 1e-6) << call;
    }
}

TEST(Solids, RefuseWhatHasNoShape)
{
    EXPECT_THROW(made("torus:radius=1,tube=1"), Error);
    EXPECT_THROW(made("cylinder:segments=2"), Error);
    EXPECT_THROW(made("box:width=0"), Error);
}

}  // namespace
}  // namespace mw
