// Catmull-Clark: values of the book, counts, attributes, and input that is no surface. OpenSubdiv has a test of its own.
#include <gtest/gtest.h>

#include "core/mesh/topology.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

constexpr const char* id = "subdivide-catmull-clark";

TEST(CatmullClark, TheCubeOfTheBook)
{
    Polygons p = cube();
    for (glm::vec3& v : p.positions) v = 2.f * v - 1.f;
    const double corner[] = {0.5556, 0.5093, 0.5015};
    const size_t counts[][3] = {{26, 48, 24}, {98, 192, 96}, {386, 768, 384}};
    for (int level = 1; level <= 3; ++level) {
        const Mesh out = applied(id, p.mesh(), ("levels=" + std::to_string(level)).c_str());
        const TopologyReport r = topologyOf(out);
        EXPECT_EQ(r.vertices, counts[level - 1][0]);
        EXPECT_EQ(r.edges, counts[level - 1][1]);
        EXPECT_EQ(r.faces, counts[level - 1][2]);
        EXPECT_EQ(r.vertexValences.at(3), 8u);
        EXPECT_EQ(r.vertexValences.size(), 2u) << "all others have valence 4";
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(out.positions()[7][k], corner[level - 1], 5e-5);
    }
    const Mesh far = applied(id, p.mesh(), "levels=6");
    EXPECT_NEAR(far.positions()[7][0], 0.5, 2e-4);
}

TEST(CatmullClark, AFaceOfNCornersGivesNQuads)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh ball = meshOf(data / "meshes/closed_genus0/dodecahedron_poly.obj"), out = applied(id, ball, "");
    EXPECT_EQ(out.faceCount(), 60u);
    EXPECT_EQ(topologyOf(out).faceSizes, (std::map<size_t, size_t>{{4, 60}}));
    EXPECT_EQ(topologyOf(out).vertexValences, (std::map<size_t, size_t>{{3, 20}, {4, 30}, {5, 12}}));
}

TEST(CatmullClark, ABicubicSurfaceInTheRegularPart)
{
    // Its limit on a regular grid is the uniform bicubic B-spline, which repeats lines and, of squares, x^2 + 1/3 of a cell.
    Polygons p = grid(12, false, true);
    for (glm::vec3& v : p.positions) v.z = (v.x - 0.5f) * (v.x - 0.5f);
    const Mesh out = applied(id, p.mesh(), "levels=5");
    const double cell = 1.0 / 12;
    for (size_t v = 0; v < out.vertexCount(); ++v) {
        const glm::dvec3 q = out.positions()[v];
        if (std::max(std::abs(q.x - 0.5), std::abs(q.y - 0.5)) < 0.3) {
            EXPECT_NEAR(q.z, (q.x - 0.5) * (q.x - 0.5) + cell * cell / 3, 1e-4 * cell);
        }
    }
}

TEST(CatmullClark, AttributesFollow)
{
    const Mesh bare = grid(5, false, true).mesh();
    Array<float> place, texcoord, weights;
    Array<int32_t> joints, material;
    for (const glm::vec3& v : bare.positions()) {
        place.insert(place.end(), {v.x, v.y, v.z});
        joints.insert(joints.end(), {2, 5});
        weights.insert(weights.end(), {v.x, 1 - v.x});
    }
    for (size_t f = 0; f < bare.faceCount(); ++f) {
        material.push_back(int32_t(f));
        for (const uint32_t v : bare.face(f)) texcoord.insert(texcoord.end(), {bare.positions()[v].x + float(f), bare.positions()[v].y});
    }
    const Mesh mesh = bare.with(floatAttribute("morph:x", Domain::Vertex, 3, place))
                          .with(integerAttribute("joints", Domain::Vertex, 2, joints))
                          .with(floatAttribute("weights", Domain::Vertex, 2, weights))
                          .with(integerAttribute("material", Domain::Face, 1, material))
                          .with(floatAttribute("texcoord", Domain::Corner, 2, texcoord));
    const Mesh out = applied(id, mesh, "levels=2");
    const Attribute *m = out.find("morph:x"), *w = out.find("weights"), *j = out.find("joints"), *f = out.find("material"), *t = out.find("texcoord");
    ASSERT_TRUE(m && w && j && f && t);
    for (size_t v = 0; v < out.vertexCount(); ++v) {
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(m->at(v, k), out.positions()[v][k], 1e-5);
        for (int k = 0; k < 2; ++k)
            if (w->at(v, k) > 0) {
                EXPECT_NEAR(w->at(v, k), j->at(v, k) == 2 ? out.positions()[v].x : 1 - out.positions()[v].x, 1e-5);
            }
    }
    for (size_t i = 0; i < out.faceCount(); ++i) {
        EXPECT_EQ(f->at(i, 0), double(i / 16));
        for (size_t c = 4 * i; c < 4 * i + 4; ++c) {  // every face is a chart; a face's values stay within it
            EXPECT_GE(t->at(c, 0), f->at(i, 0));
            EXPECT_LE(t->at(c, 0), f->at(i, 0) + 1);
        }
    }
    for (uint32_t c = 0; c < bare.cornerCount(); ++c) EXPECT_EQ(t->at(16 * size_t(c), 0), double(texcoord[2 * c])) << "corners keep their values";
}

TEST(CatmullClark, WhatIsNoSurfaceIsKept)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"fan3.obj", "hourglass_ico.obj", "moebius.obj", "beetle.obj", "teapot.obj", "spider.obj", "concave_polygon.obj"}) {
        const Mesh mesh = meshOf(data / "meshes/nonmanifold" / name), out = applied(id, mesh, "");
        EXPECT_EQ(out.faceCount(), mesh.cornerCount()) << name;
        const TopologyReport before = topologyOf(mesh);  // leaves degenerate faces out; their pieces need not be degenerate
        if (before.degenerateFaces.empty()) {
            EXPECT_EQ(topologyOf(out).nonmanifoldEdges.size(), 2 * before.nonmanifoldEdges.size()) << name;
        }
        const Bounds box = mesh.bounds(), after = out.bounds();
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(after.min[k], box.min[k] - 1e-5) << name;
            EXPECT_LE(after.max[k], box.max[k] + 1e-5) << name;
        }
    }
}

TEST(CatmullClark, TooMuchIsRefused)
{
    EXPECT_THROW(applied(id, grid(200, true, true).mesh(), "levels=6"), Error);
}

}  // namespace
