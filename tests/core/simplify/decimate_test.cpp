// Simplification on real meshes: what must stay (manifold, genus, borders, seams), what must be reached, and that watching changes nothing.
#include <gtest/gtest.h>
#include <set>

#include "core/mesh/topology.h"
#include "core/simplify/decimate_quadric.h"
#include "core/steps/stepper.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

Mesh wave(uint32_t n)
{
    Polygons p = grid(n, false, false);
    for (glm::vec3& v : p.positions) v.z = 0.05f * std::sin(6 * v.x) * std::cos(5 * v.y);
    return p.mesh();
}

void expectSameTopology(const Mesh& before, const Mesh& after, const char* name)
{
    const TopologyReport a = topologyOf(before), b = topologyOf(after);
    EXPECT_TRUE(b.manifold()) << name;
    EXPECT_EQ(a.euler, b.euler) << name;
    EXPECT_EQ(a.genus, b.genus) << name;
    EXPECT_EQ(a.components, b.components) << name;
    EXPECT_EQ(a.boundaryLoops.size(), b.boundaryLoops.size()) << name;
    EXPECT_EQ(b.degenerateFaces.size(), 0u) << name;
    EXPECT_EQ(b.inconsistentEdges.size(), 0u) << name;
}

TEST(Decimate, KeepsManifoldsAndReachesTheCount)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name :
         {"boundary/stanford-bunny.obj", "closed_genus0/fandisk.off", "closed_higher_genus/rocker-arm.obj", "closed_higher_genus/3holes.off"}) {
        const Mesh mesh = meshOf(data / "meshes" / name);
        for (const char* parameters :
             {"ratio=0.1", "ratio=0.05,optimal=false", "ratio=0.1,quality=textbook", "ratio=0.05,quality=textbook,memory=sum"}) {
            const Mesh out = applied("decimate-quadric", mesh, parameters);
            const size_t wanted = size_t(std::llround(std::stod(std::string(parameters).substr(6)) * double(mesh.faceCount())));
            EXPECT_LE(out.faceCount(), wanted) << name << " " << parameters;
            EXPECT_GE(out.faceCount() + 1, wanted) << name << " " << parameters;
            expectSameTopology(mesh, out, name);
            EXPECT_LE(folds(out), folds(mesh)) << name << " " << parameters;
        }
    }
}

TEST(Decimate, TorusKeepsItsHole)
{
    const Mesh mesh = grid(60, true, true).mesh();
    const Mesh out = applied("decimate-quadric", mesh, "stop=faces,faces=300");
    expectSameTopology(mesh, out, "torus");
    EXPECT_EQ(out.faceCount(), 300u);
    EXPECT_LT(farthest(mesh, out), 0.2);
    EXPECT_TRUE(topologyOf(applied("decimate-quadric", mesh, "ratio=0")).manifold()) << "as far as it goes";
}

void expectSteppedIsTheSame(const Mesh& mesh, const char* parameters, std::initializer_list<const char*> wanted)
{
    const Operation& op = operation("decimate-quadric");
    const ParameterValues values = parsed(op.parameters, parameters);
    const uint64_t atOnce = contentHash(apply(op, mesh, values));
    Stepper s(stepping(op, mesh, values));
    std::set<std::string> phases;
    while (s.forward()) {
        phases.insert(s.step().phase);
        const Mesh now = std::get<Mesh>(valueOf(s.value()));
        for (const Focus& f : s.step().focus) {
            if (f.kind == ElementKind::Vertex || f.kind == ElementKind::Edge) {
                ASSERT_LT(f.index, now.vertexCount());
            }
            if (f.kind == ElementKind::Edge) {
                ASSERT_LT(f.other, now.vertexCount());
            }
            if (f.kind == ElementKind::Face) {
                ASSERT_LT(f.index, now.faceCount());
            }
        }
    }
    EXPECT_EQ(contentHash(valueOf(s.value())), atOnce) << parameters;
    for (const char* p : wanted) EXPECT_TRUE(phases.contains(p)) << parameters << " " << p;
}

TEST(Decimate, SteppedIsTheSameAsUnwatched)
{
    expectSteppedIsTheSame(wave(12), "quality=textbook", {"build", "pick", "collapse", "update"});
    for (const char* quality : {"quality=fast", "quality=balanced", "quality=best"})
        expectSteppedIsTheSame(wave(12), quality, {"sort", "due", "collapsed"});
}

TEST(Decimate, BordersStay)
{
    Polygons p = grid(30, false, false);
    const Mesh out = applied("decimate-quadric", p.mesh(), "ratio=0.02");
    EXPECT_NEAR(surfaceArea(out), surfaceArea(p.mesh()), 1e-4 * surfaceArea(p.mesh())) << "a flat square stays that square";
    const Mesh curved = wave(30);
    EXPECT_LT(farthest(curved, applied("decimate-quadric", curved, "ratio=0.2")), 0.01 * curved.bounds().diagonal());
}

TEST(Decimate, ErrorIsRespected)
{
    const Mesh mesh = wave(40);
    size_t last = mesh.faceCount();
    for (const char* parameters : {"stop=error,error=0.0005", "stop=error,error=0.002", "stop=error,error=0.01"}) {
        const Mesh out = applied("decimate-quadric", mesh, parameters);
        const double bound = std::stod(std::string(parameters).substr(17)) * mesh.bounds().diagonal();
        EXPECT_LE(farthest(mesh, out), bound) << parameters;
        EXPECT_LE(farthest(out, mesh), bound) << parameters;
        EXPECT_LT(out.faceCount(), last) << parameters;
        last = out.faceCount();
    }
}

/// Two charts: the left half and, mirrored and moved, the right half; and a material for each.
Mesh twoCharts(uint32_t n)
{
    Mesh mesh = wave(n);
    Array<float> texcoord;
    Array<int32_t> material;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        float x = 0;
        for (const uint32_t v : mesh.face(f)) x += mesh.positions()[v].x / 3;
        const bool left = x < 0.5f;
        material.push_back(left ? 0 : 1);
        for (const uint32_t v : mesh.face(f)) {
            const glm::vec3 p = mesh.positions()[v];
            texcoord.push_back(left ? p.x : 3 - p.x);
            texcoord.push_back(p.y);
        }
    }
    return mesh.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord)).with(integerAttribute("material", Domain::Face, 1, material));
}

TEST(Decimate, SeamsAndMaterialsStay)
{
    const uint32_t n = 40;
    const Mesh out = applied("decimate-quadric", twoCharts(n), "ratio=0.05");
    EXPECT_LE(out.faceCount(), size_t(2 * n * n / 20));
    const Attribute *t = out.find("texcoord", Domain::Corner), *m = out.find("material", Domain::Face);
    ASSERT_TRUE(t && m);
    for (size_t f = 0; f < out.faceCount(); ++f)
        for (size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = out.positions()[out.face(f)[k]];
            const bool left = m->at(f, 0) == 0;
            EXPECT_NEAR(t->at(3 * f + k, 0), left ? p.x : 3 - p.x, 0.01);
            EXPECT_NEAR(t->at(3 * f + k, 1), p.y, 0.01);
            EXPECT_TRUE(left ? p.x < 0.5 + 1e-3 : p.x > 0.5 - 1e-3) << "no face reaches over the seam";
        }
}

TEST(Decimate, CreasesAndMorphsAndSkinsFollow)
{
    const uint32_t n = 20;
    const Mesh bare = wave(n);
    Array<float> crease(bare.cornerCount(), 0.f), delta, weights;
    Array<int32_t> joints;
    for (size_t c = 0; c < bare.cornerCount(); ++c) {
        const uint32_t a = bare.cornerVertex()[c], b = bare.cornerVertex()[c % 3 == 2 ? c - 2 : c + 1];
        if (bare.positions()[a].x == 0.5f && bare.positions()[b].x == 0.5f) crease[c] = 2;
    }
    for (const glm::vec3& p : bare.positions()) {
        delta.insert(delta.end(), {p.y, p.x, 1});
        joints.insert(joints.end(), {3, 7, 0, 0});
        weights.insert(weights.end(), {p.x, 1 - p.x, 0, 0});
    }
    const Mesh mesh = bare.with(floatAttribute("crease", Domain::Corner, 1, crease))
                          .with(floatAttribute("morph:a", Domain::Vertex, 3, delta))
                          .with(integerAttribute("joints", Domain::Vertex, 4, joints))
                          .with(floatAttribute("weights", Domain::Vertex, 4, weights));
    const Mesh out = applied("decimate-quadric", mesh, "ratio=0.1");
    double length = 0;
    const Attribute *c = out.find("crease"), *d = out.find("morph:a"), *j = out.find("joints"), *w = out.find("weights");
    ASSERT_TRUE(c && d && j && w);
    for (size_t i = 0; i < out.cornerCount(); ++i) {
        if (!(c->at(i, 0) > 0)) continue;
        const glm::vec3 a = out.positions()[out.cornerVertex()[i]], b = out.positions()[out.cornerVertex()[i % 3 == 2 ? i - 2 : i + 1]];
        EXPECT_NEAR(a.x, 0.5f, 1e-3);
        length += double(std::abs(a.y - b.y)) / 2;  // both sides of an edge
    }
    EXPECT_NEAR(length, 1, 1e-3) << "the crease still runs from border to border";
    for (size_t v = 0; v < out.vertexCount(); ++v) {
        const glm::vec3 p = out.positions()[v];
        EXPECT_NEAR(d->at(v, 1), p.x, 0.02);
        EXPECT_NEAR(d->at(v, 2), 1, 1e-5);
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            sum += w->at(v, k);
            if (j->at(v, k) == 3) {
                EXPECT_NEAR(w->at(v, k), p.x, 0.02);
            }
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

TEST(Decimate, WhatIsNoSurfaceStays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"fan3.obj", "hourglass_ico.obj", "cow.obj", "beetle.obj", "spider.obj"}) {
        const Mesh mesh = meshOf(data / "meshes/nonmanifold" / name);
        const Mesh out = applied("decimate-quadric", mesh, "ratio=0.2");
        const TopologyReport a = topologyOf(mesh), b = topologyOf(out);
        EXPECT_EQ(a.nonmanifoldEdges.size(), b.nonmanifoldEdges.size()) << name;
        EXPECT_EQ(a.nonmanifoldVertices.size(), b.nonmanifoldVertices.size()) << name;
        EXPECT_EQ(a.components, b.components) << name;
    }
}

}  // namespace
