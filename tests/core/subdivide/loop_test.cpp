// Loop subdivision: closed forms, counts, attributes, and input that is no surface.
#include <gtest/gtest.h>
#include <set>

#include "core/mesh/topology.h"
#include "core/steps/stepper.h"
#include "core/subdivide/subdivide_loop.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

Mesh bentGrid(uint32_t n)
{
    Polygons p = grid(n, false, false);
    for (glm::vec3& v : p.positions) v.z = 0.2f * std::sin(7 * v.x + 4 * v.y);
    return p.mesh();
}

TEST(Loop, WeightsAreThoseOfTheBook)
{
    EXPECT_NEAR(loopWeight(SubdivideLoop::Weights::Loop, 6), 1.0 / 16, 1e-15);
    EXPECT_NEAR(loopWeight(SubdivideLoop::Weights::Loop, 3), 3.0 / 16, 1e-15);
    EXPECT_NEAR(loopWeight(SubdivideLoop::Weights::Warren, 6), 1.0 / 16, 1e-15);
    EXPECT_NEAR(loopWeight(SubdivideLoop::Weights::Warren, 3), 3.0 / 16, 1e-15);
    EXPECT_NEAR(loopWeight(SubdivideLoop::Weights::Warren, 5), 3.0 / 40, 1e-15);
    EXPECT_EQ(loopWeight(SubdivideLoop::Weights::Loop, 0), 0);
}

TEST(Loop, OneLevelOfATetrahedron)
{
    const Mesh in = tetrahedron().mesh(), out = applied("subdivide-loop", in, "weights=warren");
    ASSERT_EQ(out.vertexCount(), 10u);
    ASSERT_EQ(out.faceCount(), 16u);
    glm::dvec3 sum(0);
    for (const glm::vec3& p : in.positions()) sum += p;
    for (size_t v = 0; v < 4; ++v) {
        const glm::dvec3 p = in.positions()[v], expected = 7.0 / 16 * p + 3.0 / 16 * (sum - p);
        EXPECT_LT(glm::length(glm::dvec3(out.positions()[v]) - expected), 1e-6);
    }
    for (size_t e = 4; e < 10; ++e) {  // 3/8 of two, 1/8 of the other two: the sum over 8 and a quarter of the two
        const glm::dvec3 rest = glm::dvec3(out.positions()[e]) - sum / 8.0;
        bool found = false;
        for (size_t a = 0; a < 4; ++a)
            for (size_t b = 0; b < a; ++b) found = found || glm::length(rest - 0.25 * glm::dvec3(in.positions()[a] + in.positions()[b])) < 1e-6;
        EXPECT_TRUE(found);
    }
}

TEST(Loop, CountsAndTopology)
{
    const Mesh torus = grid(6, true, true).mesh();
    const Mesh out = applied("subdivide-loop", torus, "levels=3");
    const TopologyReport r = topologyOf(out);
    EXPECT_EQ(out.faceCount(), 72u * 64);
    EXPECT_EQ(r.genus, 1);
    EXPECT_TRUE(r.manifold() && r.closed && r.consistentlyOriented);
    const TopologyReport open = topologyOf(applied("subdivide-loop", bentGrid(3), "levels=2"));
    EXPECT_EQ(open.boundaryLoops.size(), 1u);
    EXPECT_EQ(open.boundaryEdges, 48u);
}

TEST(Loop, BorderCornersOnRequest)
{
    const Mesh in = bentGrid(4);
    const Mesh smooth = applied("subdivide-loop", in, ""), sharp = applied("subdivide-loop", in, "corners=sharp,levels=3");
    size_t kept = 0;
    for (size_t v = 0; v < in.vertexCount(); ++v) kept += sharp.positions()[v] == in.positions()[v];
    EXPECT_EQ(kept, 2u) << "two corners of the square belong to one triangle only";
    for (size_t v = 0; v < in.vertexCount(); ++v) EXPECT_NE(smooth.positions()[v], in.positions()[v]);
}

TEST(Loop, AttributesFollow)
{
    const Mesh bare = bentGrid(6);
    Array<float> place, texcoord, weights, crease(bare.cornerCount(), 0.f);
    Array<int32_t> joints, material;
    for (const glm::vec3& p : bare.positions()) {
        place.insert(place.end(), {p.x, p.y, p.z});
        joints.insert(joints.end(), {2, 5});
        weights.insert(weights.end(), {p.x, 1 - p.x});
    }
    for (size_t f = 0; f < bare.faceCount(); ++f) material.push_back(int32_t(f));
    for (const uint32_t v : bare.cornerVertex()) texcoord.insert(texcoord.end(), {bare.positions()[v].x, bare.positions()[v].y});
    crease[0] = 1;
    const Mesh mesh = bare.with(floatAttribute("morph:x", Domain::Vertex, 3, place))
                          .with(integerAttribute("joints", Domain::Vertex, 2, joints))
                          .with(floatAttribute("weights", Domain::Vertex, 2, weights))
                          .with(integerAttribute("material", Domain::Face, 1, material))
                          .with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
                          .with(floatAttribute("crease", Domain::Corner, 1, crease));
    const Mesh out = applied("subdivide-loop", mesh, "levels=2");
    const Attribute *m = out.find("morph:x"), *w = out.find("weights"), *j = out.find("joints"), *f = out.find("material"), *t = out.find("texcoord"),
                    *c = out.find("crease");
    ASSERT_TRUE(m && w && j && f && t && c);
    for (size_t v = 0; v < out.vertexCount(); ++v) {
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(m->at(v, k), out.positions()[v][k], 1e-5);
        for (int k = 0; k < 2; ++k)
            if (w->at(v, k) > 0) {
                EXPECT_NEAR(w->at(v, k), j->at(v, k) == 2 ? out.positions()[v].x : 1 - out.positions()[v].x, 1e-5);
            }
    }
    size_t creased = 0;
    for (size_t i = 0; i < out.faceCount(); ++i) {
        EXPECT_EQ(f->at(i, 0), double(i / 16));
        for (size_t k = 0; k < 3; ++k) creased += c->at(3 * i + k, 0) > 0;
    }
    EXPECT_EQ(creased, 4u) << "one side becomes four";
    // Linear in the old face: its own corners keep their values.
    for (size_t corner = 0; corner < bare.cornerCount(); ++corner)
        EXPECT_EQ(t->at(16 * 3 * (corner / 3) + 12 * (corner % 3), 0), double(texcoord[2 * corner])) << corner;
}

TEST(Loop, SteppedIsTheSameAsUnwatched)
{
    const Operation& op = operation("subdivide-loop");
    const Mesh mesh = bentGrid(3);
    const ParameterValues values = parsed(op.parameters, "levels=2");
    Stepper s(stepping(op, mesh, values));
    std::set<std::string> phases;
    while (s.forward()) phases.insert(s.step().phase);
    EXPECT_EQ(contentHash(valueOf(s.value())), contentHash(apply(op, mesh, values)));
    for (const char* p : {"edge", "vertex", "split"}) EXPECT_TRUE(phases.contains(p)) << p;
}

TEST(Loop, TooMuchIsRefused)
{
    const Mesh big = grid(400, false, false).mesh();
    EXPECT_THROW(applied("subdivide-loop", big, "levels=6"), Error);
}

TEST(Loop, WhatIsNoSurfaceIsKept)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"fan3.obj", "hourglass_ico.obj", "moebius.obj", "beetle.obj", "teapot.obj", "spider.obj", "concave_polygon.obj"}) {
        const Mesh mesh = meshOf(data / "meshes/nonmanifold" / name), out = applied("subdivide-loop", mesh, "");
        const TopologyReport a = topologyOf(mesh), b = topologyOf(out);
        EXPECT_EQ(out.faceCount(), 4 * a.triangles) << name;
        EXPECT_EQ(b.nonmanifoldEdges.size(), 2 * a.nonmanifoldEdges.size()) << name;
        const Bounds before = mesh.bounds(), after = out.bounds();
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(after.min[k], before.min[k] - 1e-5) << name;
            EXPECT_LE(after.max[k], before.max[k] + 1e-5) << name;
        }
    }
}

TEST(Loop, OnlyPositionsChange)
{
    // A second run on the same faces takes its tables from the first; it must give what a first one gives.
    for (const char* id : {"subdivide-loop", "subdivide-catmull-clark"}) {
        const Mesh bare = bentGrid(6);
        Array<float> texcoord;
        for (const uint32_t v : bare.cornerVertex()) texcoord.insert(texcoord.end(), {bare.positions()[v].x, bare.positions()[v].y});
        const Mesh mesh = bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord));
        Array<glm::vec3> moved(mesh.positions().begin(), mesh.positions().end());
        moved[17] += glm::vec3(0.1f, 0, 0.5f);
        const Mesh first = applied(id, mesh, "levels=3"), again = applied(id, mesh.withPositions(moved), "levels=3");
        EXPECT_EQ(again.cornerVertex().id(), first.cornerVertex().id()) << "nothing is made twice";
        EXPECT_EQ(again.find("texcoord")->id(), first.find("texcoord")->id());
        const Mesh unknown = Mesh(moved, Array<uint32_t>(mesh.faceStart().begin(), mesh.faceStart().end()),
                                  Array<uint32_t>(mesh.cornerVertex().begin(), mesh.cornerVertex().end()))
                                 .with(floatAttribute("texcoord", Domain::Corner, 2, texcoord));
        EXPECT_EQ(contentHash(again), contentHash(applied(id, unknown, "levels=3")));
        EXPECT_NE(applied(id, mesh, "levels=2").vertexCount(), first.vertexCount());
        const Mesh other = applied(id, mesh.with(floatAttribute("texcoord", Domain::Corner, 2, Array<float>(texcoord.size(), 0.f))), "levels=3");
        EXPECT_EQ(other.find("texcoord")->at(5, 0), 0);
    }
}

TEST(Loop, SmoothTextureCoordinatesMoveWithThePlaces)
{
    const Mesh bare = bentGrid(6);
    Array<float> texcoord;
    for (const uint32_t v : bare.cornerVertex()) texcoord.insert(texcoord.end(), {bare.positions()[v].x, bare.positions()[v].z});
    const Mesh mesh = bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord));
    const Mesh out = applied("subdivide-loop", mesh, "levels=2,uv=smooth,corners=sharp");
    for (size_t c = 0; c < out.cornerCount(); ++c) {
        EXPECT_NEAR(out.find("texcoord")->at(c, 0), out.positions()[out.cornerVertex()[c]].x, 1e-6);
        EXPECT_NEAR(out.find("texcoord")->at(c, 1), out.positions()[out.cornerVertex()[c]].z, 1e-6);
    }
    // Every face a chart of its own: nothing to be smooth with, corners stay.
    Array<float> apart = texcoord;
    for (size_t c = 0; c < bare.cornerCount(); ++c) apart[2 * c] += float(c / 3);
    const Mesh charts = bare.with(floatAttribute("texcoord", Domain::Corner, 2, apart));
    const Mesh cut = applied("subdivide-loop", charts, "levels=2,uv=smooth");
    for (size_t c = 0; c < bare.cornerCount(); ++c) EXPECT_EQ(cut.find("texcoord")->at(16 * 3 * (c / 3) + 12 * (c % 3), 0), double(apart[2 * c]));
}

}  // namespace
