// sqrt(3) subdivision: counts, OpenMesh's scheme, two rounds are a ternary split, seams and borders.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <gtest/gtest.h>
#include <map>

#include "core/mesh/topology.h"
#include "core/subdivide/sqrt3_round.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

constexpr const char* id = "subdivide-sqrt3";

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};
using Kernel = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Closed meshes: OpenMesh numbers old vertices and then the centres of its faces as we do.
double differenceToOpenMesh(const Mesh& mesh, int levels)
{
    Kernel kernel;
    for (const glm::vec3& p : mesh.positions()) kernel.add_vertex({double(p.x), double(p.y), double(p.z)});
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<Kernel::VertexHandle> face;
        for (const uint32_t v : mesh.face(f)) face.emplace_back(int(v));
        kernel.add_face(face);
    }
    OpenMesh::Subdivider::Uniform::Sqrt3T<Kernel, double> sqrt3;
    sqrt3.attach(kernel);
    sqrt3(size_t(levels));
    sqrt3.detach();
    const Mesh out = applied(id, mesh, ("levels=" + std::to_string(levels)).c_str());
    if (out.vertexCount() != kernel.n_vertices() || out.faceCount() != kernel.n_faces()) return 1e9;
    // Second rounds number faces by other orders: match by nearest among equals in sorted order of places.
    const auto sorted = [](std::vector<glm::dvec3> p) {
        std::sort(p.begin(), p.end(), [](glm::dvec3 a, glm::dvec3 b) {
            for (int k = 0; k < 3; ++k)
                if (std::lround(a[k] * 1e4) != std::lround(b[k] * 1e4)) return a[k] < b[k];
            return false;
        });
        return p;
    };
    std::vector<glm::dvec3> a, b;
    for (const glm::vec3& p : out.positions()) a.emplace_back(p);
    for (const auto v : kernel.vertices()) b.emplace_back(kernel.point(v)[0], kernel.point(v)[1], kernel.point(v)[2]);
    if (levels > 1) a = sorted(a), b = sorted(b);
    double worst = 0;
    for (size_t v = 0; v < a.size(); ++v) worst = std::max(worst, glm::length(a[v] - b[v]));
    return worst / mesh.bounds().diagonal();
}

Mesh octahedron()
{
    Polygons p;
    p.positions = {{1.1f, 0.2f, 0}, {-1, 0.1f, 0}, {0, 1.3f, 0.1f}, {0.1f, -1, 0}, {0, 0, 0.9f}, {0.2f, 0, -1.2f}};
    p.face({0, 2, 4}).face({2, 1, 4}).face({1, 3, 4}).face({3, 0, 4}).face({2, 0, 5}).face({1, 2, 5}).face({3, 1, 5}).face({0, 3, 5});
    return p.mesh();
}

TEST(Sqrt3, AgreesWithOpenMesh)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    EXPECT_LT(differenceToOpenMesh(octahedron(), 1), 1e-6);
    EXPECT_LT(differenceToOpenMesh(octahedron(), 2), 1e-3) << "sorted places";
    EXPECT_LT(differenceToOpenMesh(meshOf(data / "meshes/closed_genus0/spot.obj"), 1), 1e-6);
    EXPECT_LT(differenceToOpenMesh(meshOf(data / "meshes/closed_higher_genus/3holes.off"), 1), 1e-6);
}

TEST(Sqrt3, CountsOfTheIcosahedron)
{
    const Operation& source = operation("icosphere");
    const Mesh icosahedron = std::get<Mesh>(apply(source, {}, parsed(source.parameters, "subdivisions=0")));
    const size_t counts[][2] = {{32, 60}, {92, 180}, {272, 540}};
    for (int level = 1; level <= 3; ++level) {
        const Mesh out = applied(id, icosahedron, ("levels=" + std::to_string(level)).c_str());
        const TopologyReport r = topologyOf(out);
        EXPECT_EQ(r.vertices, counts[level - 1][0]);
        EXPECT_EQ(r.faces, counts[level - 1][1]);
        EXPECT_EQ(r.genus, 0);
        EXPECT_EQ(r.vertexValences, (std::map<size_t, size_t>{{5, 12}, {6, counts[level - 1][0] - 12}})) << "old keep theirs, new get 6";
    }
}

/// Edges as pairs of vertices, lower first.
std::set<std::pair<uint32_t, uint32_t>> edgesOf(const Mesh& m)
{
    std::set<std::pair<uint32_t, uint32_t>> out;
    for (size_t f = 0; f < m.faceCount(); ++f)
        for (size_t k = 0; k < m.face(f).size(); ++k) out.insert(std::minmax(m.face(f)[k], m.face(f)[(k + 1) % m.face(f).size()]));
    return out;
}

/// Vertices of two meshes matched by the linear texture coordinates that both carry: equal faces, as sets of corners.
using Corner = std::pair<int, int>;
std::multiset<std::vector<Corner>> facesByTexcoord(const Mesh& m)
{
    const Attribute& t = *m.find("texcoord");
    std::multiset<std::vector<Corner>> out;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        std::vector<Corner> face;
        for (size_t c = 3 * f; c < 3 * f + 3; ++c) face.emplace_back(std::lround(t.at(c, 0) * 1e3), std::lround(t.at(c, 1) * 1e3));
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        out.insert(face);
    }
    return out;
}

Mesh withChartsOfTheirOwn(const Mesh& m, bool apart)
{
    Array<float> texcoord;
    Array<int32_t> material;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        for (const uint32_t v : m.face(f))
            texcoord.insert(texcoord.end(), {10 * m.positions()[v].x + (apart ? 20 * float(f) : 0), 10 * m.positions()[v].y});
        material.push_back(int32_t(f));
    }
    return m.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord)).with(integerAttribute("material", Domain::Face, 1, material));
}

TEST(Sqrt3, TwiceIsATernarySplit)
{
    // Texture coordinates are linear in both, so they say which corner is which: with a border, and where every face is a chart of its own.
    for (const bool apart : {false, true}) {
        const Mesh m = withChartsOfTheirOwn(grid(4, false, false).mesh(), apart);
        const Mesh twice = applied(id, m, "levels=2"), ternary = applied("split-nadic", m, "n=3");
        ASSERT_EQ(twice.faceCount(), ternary.faceCount());
        ASSERT_EQ(twice.vertexCount(), ternary.vertexCount());
        EXPECT_EQ(facesByTexcoord(twice), facesByTexcoord(ternary));
        const Attribute& face = *twice.find("material");
        if (apart) {
            for (size_t c = 0; c < twice.cornerCount(); ++c) EXPECT_EQ(std::floor((twice.find("texcoord")->at(c, 0) + 5) / 20), face.at(c / 3, 0));
        }
    }
    const TopologyReport closed = topologyOf(applied(id, grid(5, true, false).mesh(), "levels=4"));
    EXPECT_EQ(closed.genus, 1);
    EXPECT_EQ(closed.faces, 50u * 81);
}

TEST(Sqrt3, SeamsStayInTheLastOddRound)
{
    const Mesh m = withChartsOfTheirOwn(grid(4, false, false).mesh(), true), once = applied(id, m, "levels=1");
    EXPECT_EQ(once.faceCount(), 3 * m.faceCount());
    const auto edges = edgesOf(once);
    for (const auto& e : edgesOf(m)) EXPECT_TRUE(edges.contains(e)) << "an edge between two charts";
    const Mesh joined = withChartsOfTheirOwn(grid(4, false, false).mesh(), false).without("material"), flipped = applied(id, joined, "levels=1");
    const TopologyReport r = topologyOf(joined);
    size_t left = 0;
    for (const auto& e : edgesOf(joined)) left += edgesOf(flipped).contains(e);
    EXPECT_EQ(left, r.boundaryEdges) << "all others are flipped";
    // The places are the same whatever is flipped.
    EXPECT_TRUE(std::equal(once.positions().begin(), once.positions().end(), flipped.positions().begin()));
}

TEST(Sqrt3, BordersAreACurveOfTheirOwn)
{
    Polygons p = grid(5, false, false);
    for (glm::vec3& v : p.positions) v.z = 0.2f * std::sin(7 * v.x + 4 * v.y);
    const Mesh m = p.mesh(), two = applied(id, m, "levels=2"), one = applied(id, m, "levels=1");
    EXPECT_EQ(topologyOf(one).boundaryEdges, 20u);
    EXPECT_EQ(topologyOf(two).boundaryEdges, 60u);
    // Moving the inside does not move the border.
    for (size_t v = 0; v < p.positions.size(); ++v)
        if (v % 6 != 0 && v % 6 != 5 && v / 6 != 0 && v / 6 != 5) p.positions[v].z += 0.5f;
    const Mesh other = applied(id, p.mesh(), "levels=2");
    for (const auto& loop : topologyOf(two).boundaryLoops)
        for (const uint32_t v : loop) EXPECT_EQ(two.positions()[v], other.positions()[v]);
    // Kobbelt's masks in the middle of a side.
    const glm::dvec3 a = m.positions()[1], b = m.positions()[2], c = m.positions()[3];
    EXPECT_LT(glm::length(glm::dvec3(two.positions()[2]) - (4.0 * a + 19.0 * b + 4.0 * c) / 27.0), 1e-6);
    double near = 1;
    for (const glm::vec3& q : two.positions()) near = std::min(near, glm::length(glm::dvec3(q) - (10.0 * a + 16.0 * b + c) / 27.0));
    EXPECT_LT(near, 1e-6);
}

TEST(Sqrt3, CreasesStay)
{
    const Mesh bare = grid(6, false, false).mesh();
    Array<float> crease(bare.cornerCount(), 0.f);
    for (size_t c = 0; c < bare.cornerCount(); ++c) {
        const glm::vec3 a = bare.positions()[bare.cornerVertex()[c]], b = bare.positions()[bare.cornerVertex()[c % 3 == 2 ? c - 2 : c + 1]];
        if (a.x == 0.5f && b.x == 0.5f) crease[c] = 1;
    }
    const Mesh m = bare.with(floatAttribute("crease", Domain::Corner, 1, crease));
    const size_t expected[] = {12, 36, 36, 108};
    for (int level = 1; level <= 4; ++level) {
        const Mesh out = applied(id, m, ("levels=" + std::to_string(level)).c_str());
        const Attribute& c = *out.find("crease");
        size_t sides = 0;
        for (size_t i = 0; i < out.cornerCount(); ++i)
            if (c.at(i, 0) > 0) {
                ++sides;
                EXPECT_NEAR(out.positions()[out.cornerVertex()[i]].x, 0.5, 1e-6);
                EXPECT_NEAR(out.positions()[out.cornerVertex()[i % 3 == 2 ? i - 2 : i + 1]].x, 0.5, 1e-6);
            }
        EXPECT_EQ(sides, expected[level - 1]) << level;
    }
}

TEST(Sqrt3, WhatIsNoSurfaceIsKept)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"nonmanifold/fan3.obj", "nonmanifold/hourglass_ico.obj", "nonmanifold/moebius.obj", "nonmanifold/beetle.obj",
                             "nonmanifold/spider.obj", "quads/suzanne.obj"}) {
        const Mesh mesh = meshOf(data / "meshes" / name);
        const TopologyReport a = topologyOf(mesh);
        const Mesh two = applied(id, mesh, "levels=2");
        EXPECT_EQ(two.faceCount(), 9 * a.triangles) << name;
        const Bounds before = mesh.bounds(), after = two.bounds();
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(after.min[k], before.min[k] - 1e-4) << name;
            EXPECT_LE(after.max[k], before.max[k] + 1e-4) << name;
        }
    }
}

}  // namespace
