// Removing vertices: counts of every single removal, what must stay, attributes, and scanned meshes.
#include "core/simplify/decimate_vertices.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "core/catalog/others.h"
#include "core/mesh/topology.h"
#include "core/simplify/star_hole.h"
#include "core/steps/stepper.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

double number(const StepRecord& step, std::string_view name)
{
    for (const Number& n : step.numbers)
        if (n.name == name) return n.value;
    ADD_FAILURE() << "no " << name;
    return NAN;
}

Mesh removed(const Mesh& mesh, const char* parameters)
{
    return applied("decimate-vertices", mesh, parameters);
}

struct Counts {
    double vertices, edges, faces;
};

Counts countsOf(const Mesh& m)
{
    return {double(m.vertexCount()), double(m.edges().size() / 2), double(m.faceCount())};
}

// A removal takes up to a millisecond: whoever cancels must not wait for a thousand of them.
TEST(DecimateVertices, LooksUpOftenWhenNobodyWatches)
{
    const Operation& op = operation("decimate-vertices");
    const Mesh mesh = *meshOfSource("icosphere:subdivisions=5");
    const auto run = stepping(op, mesh, parsed(op.parameters, "threshold=2,faces=2000"))(false);
    size_t looks = 0;
    while (run->advance()) ++looks;
    const size_t gone = mesh.vertexCount() - std::get<Mesh>(valueOf(run->snapshot())).vertexCount();
    EXPECT_GT(gone, 5000u);
    EXPECT_GE(looks, gone / 100);
}

// Every removal inside takes 1 vertex, 3 edges, 2 faces; every one on the border 1, 2, 1: told by the steps, and true of the mesh that is shown.
TEST(DecimateVertices, EachRemovalHasItsCounts)
{
    for (const char* source : {"icosphere:subdivisions=2", "grid:columns=6,rows=6"}) {
        const Operation& op = operation("decimate-vertices");
        Stepper s(stepping(op, *meshOfSource(source), parsed(op.parameters, "threshold=2")));
        Counts before{};
        double place = 0, inside = 0, border = 0;
        while (s.forward() && !s.atEnd()) {
            const std::string phase = s.step().phase;
            const Mesh now = std::get<Mesh>(valueOf(s.value()));
            if (phase == "pick") {
                before = countsOf(now);
                place = number(s.step(), "place");
            }
            if (phase != "retriangulate") continue;
            const Counts after = countsOf(now);
            const double e = place == 0 ? -3 : -2, f = place == 0 ? -2 : -1;
            EXPECT_EQ(after.vertices - before.vertices, -1);
            EXPECT_EQ(after.edges - before.edges, e);
            EXPECT_EQ(after.faces - before.faces, f);
            EXPECT_EQ(number(s.step(), "dV"), -1);
            EXPECT_EQ(number(s.step(), "dE"), e);
            EXPECT_EQ(number(s.step(), "dF"), f);
            EXPECT_EQ(number(s.step(), "triangles"), number(s.step(), "k") - 2);
            EXPECT_EQ(number(s.step(), "euler"), after.vertices - after.edges + after.faces);
            (place == 0 ? inside : border) += 1;
        }
        EXPECT_GT(inside, 10) << source;
        if (source[0] == 'g') {
            EXPECT_GT(border, 5);
        }
    }
}

// A plane keeps its four corners and nothing else, and covers the same square.
TEST(DecimateVertices, AFlatSheetIsLeftWithItsCorners)
{
    const Mesh grid = *meshOfSource("grid:width=1,depth=1,columns=12,rows=12");
    const Mesh out = removed(grid, "threshold=0.001");
    EXPECT_EQ(out.vertexCount(), 4u);
    EXPECT_EQ(out.faceCount(), 2u);
    double area = 0;
    for (size_t f = 0; f < out.faceCount(); ++f) {
        const auto c = out.face(f);
        const glm::dvec3 a = out.positions()[c[0]], b = out.positions()[c[1]], d = out.positions()[c[2]];
        area += 0.5 * glm::length(glm::cross(b - a, d - a));
    }
    EXPECT_NEAR(area, 1, 1e-6);
    const Mesh framed = removed(grid, "threshold=0.001,border=false");  // the 48 border vertices alone
    EXPECT_EQ(framed.vertexCount(), 48u);
    EXPECT_EQ(framed.faceCount(), 46u);
}

TEST(DecimateVertices, ABoxKeepsItsCorners)
{
    const Mesh out = removed(*meshOfSource("box:segments=6"), "threshold=0.01");
    EXPECT_TRUE(out.topology().closed);
    EXPECT_EQ(out.topology().euler, 2);
    std::set<std::array<float, 3>> corners;
    const Bounds box = out.bounds();
    for (const glm::vec3& p : out.positions()) {
        int on = 0;
        for (int k = 0; k < 3; ++k) on += p[k] == float(box.min[k]) || p[k] == float(box.max[k]);
        if (on == 3) corners.insert({p.x, p.y, p.z});
    }
    EXPECT_EQ(corners.size(), 8u);
    EXPECT_NEAR(farthest(*meshOfSource("box:segments=6"), out), 0, 1e-6);
}

TEST(DecimateVertices, NothingBelowTheThresholdIsLeftThatCouldGo)
{
    const Mesh sphere = *meshOfSource("icosphere:subdivisions=4");
    EXPECT_EQ(removed(sphere, "threshold=0").faceCount(), sphere.faceCount());
    const Mesh to500 = removed(sphere, "threshold=10,faces=500");
    EXPECT_EQ(to500.faceCount(), 500u);
    EXPECT_EQ(to500.topology().euler, 2);
    // Vertices that stay have not moved.
    const Bounds box = to500.bounds();
    EXPECT_FALSE(box.empty);
    for (const glm::vec3& p : to500.positions()) EXPECT_NEAR(glm::length(glm::dvec3(p)), glm::length(glm::dvec3(sphere.positions()[0])), 1e-6);
    // Only the smallest closed surface is left at the most.
    EXPECT_GE(removed(sphere, "threshold=10").faceCount(), 4u);
}

TEST(DecimateVertices, SeamsStayAndValuesToo)
{
    const Mesh grid = *meshOfSource("grid:width=1,depth=1,columns=10,rows=10");
    Array<float> texcoord, place;
    Array<int32_t> material, slot;
    for (size_t f = 0; f < grid.faceCount(); ++f) {
        double x = 0;
        for (const uint32_t v : grid.face(f)) x += grid.positions()[v].x / 4;
        material.push_back(x < 0 ? 0 : 1);
        for (const uint32_t v : grid.face(f)) {  // beyond x = 0 the texture jumps by 5
            texcoord.push_back(grid.positions()[v].x + (x < 0 ? 0 : 5));
            texcoord.push_back(grid.positions()[v].z);
        }
    }
    for (const glm::vec3& p : grid.positions()) place.insert(place.end(), {p.x, p.y, p.z});
    const Mesh mesh = grid.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
                          .with(floatAttribute("place", Domain::Vertex, 3, place))
                          .with(integerAttribute("material", Domain::Face, 1, material));
    const Mesh out = removed(mesh, "threshold=0.01");
    EXPECT_LT(out.vertexCount(), 20u);
    size_t onSeam = 0;
    for (const glm::vec3& p : out.positions()) onSeam += std::abs(p.x) < 1e-6;
    EXPECT_EQ(onSeam, 11u);
    const Attribute &t = *out.find("texcoord"), &p = *out.find("place"), &m = *out.find("material");
    for (size_t f = 0; f < out.faceCount(); ++f) {
        double x = 0;
        for (const uint32_t v : out.face(f)) x += out.positions()[v].x / 3;
        EXPECT_EQ(m.at(f, 0), x < 0 ? 0 : 1);
        for (size_t c = out.faceStart()[f]; c < out.faceStart()[f + 1]; ++c) {
            const glm::vec3 at = out.positions()[out.cornerVertex()[c]];
            EXPECT_EQ(t.at(c, 0), at.x + (x < 0 ? 0.f : 5.f));
            EXPECT_EQ(t.at(c, 1), at.z);
        }
    }
    for (size_t v = 0; v < out.vertexCount(); ++v)
        for (int k = 0; k < 3; ++k) EXPECT_EQ(p.at(v, k), out.positions()[v][k]);
}

TEST(DecimateVertices, CreasesStay)
{
    const Mesh grid = *meshOfSource("grid:width=1,depth=1,columns=8,rows=8");
    Array<float> crease(grid.cornerCount(), 0.f);
    for (size_t f = 0; f < grid.faceCount(); ++f)
        for (size_t k = 0; k < 4; ++k) {
            const uint32_t a = grid.face(f)[k], b = grid.face(f)[(k + 1) % 4];
            if (std::abs(grid.positions()[a].x) < 1e-6 && std::abs(grid.positions()[b].x) < 1e-6) crease[grid.faceStart()[f] + k] = 2;
        }
    const Mesh out = removed(grid.with(floatAttribute(std::string(names::crease), Domain::Corner, 1, crease)), "threshold=0.01");
    EXPECT_LT(out.vertexCount(), 20u);
    const Attribute& kept = *out.find(names::crease);
    size_t sides = 0;
    for (size_t c = 0; c < out.cornerCount(); ++c) {
        const size_t next = c % 3 == 2 ? c - 2 : c + 1;
        const bool on = std::abs(out.positions()[out.cornerVertex()[c]].x) < 1e-6 && std::abs(out.positions()[out.cornerVertex()[next]].x) < 1e-6;
        EXPECT_EQ(kept.at(c, 0), on ? 2 : 0);
        sides += on;
    }
    EXPECT_EQ(sides, 16u);
}

TEST(DecimateVertices, ScannedMeshesStayManifoldWithTheirGenusAndBorders)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"closed_genus0/fandisk.off", "closed_higher_genus/3holes.off", "disk/camelhead.off", "boundary/hole_capsule.off"}) {
        SCOPED_TRACE(name);
        const Mesh in = meshOf(data / "meshes" / name), out = removed(in, "threshold=0.2");
        const TopologyReport &a = in.topology(), &b = out.topology();
        EXPECT_LT(out.faceCount(), in.faceCount() * 3 / 4);
        EXPECT_EQ(a.euler, b.euler);
        EXPECT_EQ(a.components, b.components);
        EXPECT_EQ(a.boundaryLoops.size(), b.boundaryLoops.size());
        EXPECT_EQ(a.manifold(), b.manifold());
        EXPECT_LE(folds(out), folds(in));
    }
}

StarHole ring(std::initializer_list<glm::dvec3> points)
{
    StarHole h;
    h.points = points;
    h.normal = {0, 0, 1};
    h.beyond.assign(h.points.size(), glm::dvec3(0));
    h.allowed = [](uint32_t, uint32_t) { return true; };
    return h;
}

// A hexagon with one point drawn in: a star from the middle, not convex.
TEST(StarHole, IsFilledInsideItsOutline)
{
    const StarHole star = ring({{1, 0, 0}, {0.5, 0.87, 0}, {-0.5, 0.87, 0}, {-0.2, 0, 0}, {-0.5, -0.87, 0}, {0.5, -0.87, 0}});
    const Filling f = filled(star, 0.2);
    ASSERT_EQ(f.triangles.size(), 4u);
    double area = 0, outline = 0;
    for (const auto& t : f.triangles) {
        const glm::dvec3 a = star.points[t[0]], b = star.points[t[1]], c = star.points[t[2]];
        const double twice = glm::cross(b - a, c - a).z;
        EXPECT_GT(twice, 0);
        area += twice;
    }
    for (size_t i = 0; i < 6; ++i) outline += glm::cross(star.points[i], star.points[(i + 1) % 6]).z;
    EXPECT_NEAR(area, outline, 1e-12);
}

TEST(StarHole, SaysWhyItCannotBeFilled)
{
    StarHole notStar = ring({{1, 0, 0}, {0.2, 1, 0}, {0.6, 2, 0}, {-1, 2, 0}, {-1, -1, 0}});
    EXPECT_EQ(filled(notStar, 0.2).why, NoFilling::NotStar);
    StarHole square = ring({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}});
    EXPECT_EQ(filled(square, 0.2).triangles.size(), 2u);
    square.allowed = [](uint32_t, uint32_t) { return false; };
    EXPECT_EQ(filled(square, 0.2).why, NoFilling::Exists);
    StarHole folded = ring({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}});
    folded.beyond[0] = {0, 0, -1};  // the face beyond lies on the hole
    EXPECT_EQ(filled(folded, 0.2).why, NoFilling::Fold);
    StarHole steep = ring({{1, 1, 9}, {-1, 1, -9}, {-1, -1, 9}, {1, -1, -9}});
    EXPECT_EQ(filled(steep, 0.2).why, NoFilling::Fold);
}

// Of the two ways to cut a flat kite the one with the better angles is taken.
TEST(StarHole, PrefersGoodAngles)
{
    const StarHole kite = ring({{3, 0, 0}, {0, 1, 0}, {-3, 0, 0}, {0, -1, 0}});
    const Filling f = filled(kite, 0.2);
    ASSERT_EQ(f.triangles.size(), 2u);
    for (const auto& t : f.triangles) EXPECT_TRUE(std::count(t.begin(), t.end(), 1u) && std::count(t.begin(), t.end(), 3u));
    EXPECT_NEAR(f.leastAngle, 2 * std::atan(1.0 / 3) * 180 / M_PI, 1e-9);
}

}  // namespace
}  // namespace mw::test
