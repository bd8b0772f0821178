// Butterfly: goes through old vertices, repeats cubics, agrees with OpenMesh's modified scheme.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <gtest/gtest.h>
#include <map>

#include "core/mesh/topology.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

constexpr const char* id = "subdivide-butterfly";

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};
using Kernel = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Largest distance of a vertex of OpenMesh's result to ours with the same number, over the size. Both give an edge's point by its ends.
double differenceToOpenMesh(const Mesh& mesh)
{
    Kernel kernel;
    for (const glm::vec3& p : mesh.positions()) kernel.add_vertex({double(p.x), double(p.y), double(p.z)});
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<Kernel::VertexHandle> face;
        for (const uint32_t v : mesh.face(f)) face.emplace_back(int(v));
        kernel.add_face(face);
    }
    std::map<std::pair<int, int>, OpenMesh::Vec3d> theirs;
    OpenMesh::Subdivider::Uniform::ModifiedButterflyT<Kernel, double> butterfly;
    butterfly.attach(kernel);
    butterfly(1);
    butterfly.detach();
    const int old = int(mesh.vertexCount());
    for (int v = old; v < int(kernel.n_vertices()); ++v) {  // an edge's vertex has exactly its two ends among the old vertices
        std::vector<int> ends;
        for (auto it = kernel.vv_iter(Kernel::VertexHandle(v)); it.is_valid(); ++it)
            if (it->idx() < old) ends.push_back(it->idx());
        if (ends.size() != 2) return 1e9;
        theirs[std::minmax(ends[0], ends[1])] = kernel.point(Kernel::VertexHandle(v));
    }
    const Mesh out = applied(id, mesh, "");
    std::map<int, std::vector<int>> ends;
    for (size_t f = 0; f < out.faceCount(); ++f)
        for (size_t k = 0; k < 3; ++k) {
            const int a = int(out.face(f)[k]), b = int(out.face(f)[(k + 1) % 3]);
            if (a >= old && b < old) ends[a].push_back(b);
            if (b >= old && a < old) ends[b].push_back(a);
        }
    double worst = 0;
    for (auto& [v, list] : ends) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        const OpenMesh::Vec3d p = theirs.at({list.at(0), list.at(1)});
        worst = std::max(worst, glm::length(glm::dvec3(out.positions()[size_t(v)]) - glm::dvec3(p[0], p[1], p[2])));
    }
    return ends.size() == theirs.size() ? worst / mesh.bounds().diagonal() : 1e9;
}

Mesh bent(uint32_t n)
{
    Polygons p = grid(n, false, false);
    for (glm::vec3& v : p.positions) v.z = 0.2f * std::sin(7 * v.x + 4 * v.y);
    return p.mesh();
}

TEST(Butterfly, AgreesWithOpenMesh)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    EXPECT_LT(differenceToOpenMesh(tetrahedron().mesh()), 1e-6) << "valence 3";
    EXPECT_LT(differenceToOpenMesh(grid(6, true, false).mesh()), 1e-6) << "valence 6";
    EXPECT_LT(differenceToOpenMesh(bent(5)), 1e-6) << "borders";
    EXPECT_LT(differenceToOpenMesh(meshOf(data / "meshes/closed_genus0/spot.obj")), 1e-6);
    EXPECT_LT(differenceToOpenMesh(meshOf(data / "meshes/closed_higher_genus/3holes.off")), 1e-6);
    EXPECT_LT(differenceToOpenMesh(meshOf(data / "meshes/disk/cat_head.obj")), 1e-6);
}

TEST(Butterfly, OldVerticesStay)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"closed_genus0/spot.obj", "disk/cat_head.obj", "nonmanifold/spider.obj", "quads/suzanne.obj"}) {
        const Mesh in = meshOf(data / "meshes" / name);
        for (const char* parameters : {"levels=2", "weights=eighth", "modified=false,levels=2"}) {
            const Mesh out = applied(id, in, parameters);
            ASSERT_GT(out.vertexCount(), in.vertexCount());
            for (size_t v = 0; v < in.vertexCount(); ++v) ASSERT_EQ(out.positions()[v], in.positions()[v]) << name;
        }
    }
}

TEST(Butterfly, RepeatsCubicsOnARegularGrid)
{
    Polygons p = grid(16, false, false);
    const auto cubic = [](double x, double y) { return x * x * x - 2 * x * x * y + 0.5 * x * y * y + y * y * y - x * y + 0.3; };
    for (glm::vec3& v : p.positions) v.z = float(cubic(v.x, v.y));
    const auto worst = [&](const char* parameters) {
        double most = 0;
        const Mesh out = applied(id, p.mesh(), parameters);
        for (const glm::vec3& v : out.positions())
            if (std::max(std::abs(v.x - 0.5f), std::abs(v.y - 0.5f)) < 0.25f) most = std::max(most, std::abs(double(v.z) - cubic(v.x, v.y)));
        return most;
    };
    EXPECT_LT(worst("levels=1"), 3e-7);
    EXPECT_LT(worst("levels=3"), 5e-7);
    EXPECT_GT(worst("weights=eighth"), 1e-4) << "the other weights do not";
}

TEST(Butterfly, EveryRowSumsToOne)
{
    const Mesh flat = bent(6);
    Array<glm::vec3> moved(flat.positions().begin(), flat.positions().end());
    for (glm::vec3& v : moved) v += glm::vec3(3, -2, 5);
    for (const char* parameters : {"levels=2", "levels=2,weights=eighth"}) {
        const Mesh a = applied(id, flat, parameters), b = applied(id, flat.withPositions(moved), parameters);
        for (size_t v = 0; v < a.vertexCount(); ++v) EXPECT_LT(glm::length(b.positions()[v] - a.positions()[v] - glm::vec3(3, -2, 5)), 1e-5f);
    }
}

TEST(Butterfly, CountsAndAttributes)
{
    const Mesh ball = tetrahedron().mesh();
    const TopologyReport r = topologyOf(applied(id, ball, "levels=3"));
    EXPECT_EQ(r.faces, 4u * 64);
    EXPECT_EQ(r.genus, 0);
    const Mesh plain = bent(4);
    Array<float> texcoord, crease(plain.cornerCount(), 0.f);
    for (size_t f = 0; f < plain.faceCount(); ++f)
        for (const uint32_t v : plain.face(f)) texcoord.insert(texcoord.end(), {plain.positions()[v].x + float(f), plain.positions()[v].y});
    const Mesh out = applied(id, plain.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord)), "levels=2");
    const Attribute* t = out.find("texcoord");
    ASSERT_NE(t, nullptr);
    for (size_t c = 0; c < plain.cornerCount(); ++c) EXPECT_EQ(t->at(16 * 3 * (c / 3) + 12 * (c % 3), 0), double(texcoord[2 * c]));
}

TEST(Butterfly, WhatIsNoSurfaceIsKept)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"fan3.obj", "hourglass_ico.obj", "moebius.obj", "beetle.obj", "teapot.obj", "spider.obj"}) {
        const Mesh mesh = meshOf(data / "meshes/nonmanifold" / name), out = applied(id, mesh, "");
        const TopologyReport a = topologyOf(mesh), b = topologyOf(out);
        EXPECT_EQ(out.faceCount(), 4 * a.triangles) << name;
        EXPECT_EQ(b.nonmanifoldEdges.size(), 2 * a.nonmanifoldEdges.size()) << name;
        EXPECT_LT(out.bounds().diagonal(), 1.5 * mesh.bounds().diagonal()) << name;
    }
}

}  // namespace
