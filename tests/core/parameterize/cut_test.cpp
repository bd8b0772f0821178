// Cuts by Euler's formula: one loop, one piece, no handle; and by counting vertices of small shapes by hand.
#include "core/parameterize/cut.h"

#include <gtest/gtest.h>

#include "core/mesh/cut_open.h"
#include "core/mesh/topology.h"
#include "core/parameterize/cut_graph.h"
#include "core/parameterize/embed_planar.h"
#include "core/scene/samples.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

Mesh source(const char* id, const char* parameters = "")
{
    return std::get<Mesh>(apply(operation(id), {}, parsed(operation(id).parameters, parameters)));
}

void expectDisk(const Mesh& mesh)
{
    const Mesh out = applied("cut", mesh, "");
    const TopologyReport& t = out.topology();
    EXPECT_EQ(t.euler, 1);
    EXPECT_EQ(t.components, 1u);
    EXPECT_EQ(t.boundaryLoops.size(), 1u);
    EXPECT_TRUE(t.manifold());
    EXPECT_EQ(out.faceCount(), mesh.faceCount());
    for (size_t c = 0; c < mesh.cornerCount(); ++c)
        ASSERT_EQ(out.positions()[out.cornerVertex()[c]], mesh.positions()[mesh.cornerVertex()[c]]) << "corner " << c;
    EXPECT_EQ(contentHash(applied("cut", out, "")), contentHash(out)) << "a disk stays";
    EXPECT_TRUE(foldedFaces(out, planarEmbedding(out, EdgeWeights::MeanValue)).empty()) << "and can be laid flat";
}

TEST(Cut, DataMeshesOfAnyGenusBecomeDisks)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name :
         {"closed_genus0/cube.off", "closed_genus0/tet.obj", "closed_genus0/dodecahedron_poly.obj", "closed_genus0/bumpy.off",
          "closed_genus0/spot.obj", "closed_genus0/bunny_3k.off", "closed_genus0/armadillo.obj", "closed_genus0/cheburashka.off",
          "closed_genus0/max_planck_5k.obj", "closed_genus0/fandisk.off", "closed_higher_genus/3holes.off", "closed_higher_genus/rocker-arm.obj",
          "boundary/hole_capsule.off", "boundary/intersection_quads.off", "disk/camelhead.off", "boundary/stanford-bunny.obj"}) {
        SCOPED_TRACE(name);
        expectDisk(meshOf(data / "meshes" / name));
    }
}

TEST(Cut, SourcesAndGearsBecomeDisks)
{
    for (const char* id : {"icosphere", "box", "torus", "cylinder", "cone", "uv-sphere", "grid"}) {
        SCOPED_TRACE(id);
        expectDisk(source(id));
    }
    expectDisk(source("cylinder", "caps=open"));
    const Scene gears = sampleScene("gears");
    size_t wheels = 0;
    for (const auto id : gears.meshes()) {
        const Mesh& wheel = gears.find(id)->base;
        EXPECT_GE(wheel.topology().genus.value_or(0), 5);
        expectDisk(wheel);
        ++wheels;
    }
    EXPECT_EQ(wheels, 3u);
}

/// A path of n edges inside a closed surface opens n - 1 vertices; the result has one loop of 2n edges.
TEST(Cut, AWayOfEdgesOpensOneLoop)
{
    const Mesh ball = source("icosphere", "subdivisions=3");
    const std::vector<uint32_t> path = edgePath(ball, 0, 3);
    ASSERT_GT(path.size(), 3u);
    const Mesh out = applied("cut", ball, "method=shortest,vertices=0;3");
    EXPECT_EQ(out.vertexCount(), ball.vertexCount() + path.size() - 2);
    EXPECT_EQ(out.topology().boundaryEdges, 2 * (path.size() - 1));
    EXPECT_EQ(out.topology().boundaryLoops.size(), 1u);
    EXPECT_EQ(applied("cut", ball, "method=shortest,vertices=3;0").vertexCount(), out.vertexCount());
}

TEST(Cut, WaysSayHowFarTheyAreAndHearACancel)
{
    const Mesh ball = source("icosphere", "subdivisions=3");
    const uint32_t start[] = {0};
    Progress progress;
    const EdgeDistances asked = edgeDistances(ball, start, none, &progress), alone = edgeDistances(ball, start);
    EXPECT_TRUE(std::equal(asked.distance.begin(), asked.distance.end(), alone.distance.begin(), alone.distance.end()));
    EXPECT_FLOAT_EQ(progress.fraction, 1);
    Progress cancelled;
    cancelled.cancelled = true;
    EXPECT_THROW(edgeDistances(ball, start, none, &cancelled), Cancelled);
}

TEST(Cut, OneEdgeInsideOpensNothingAndARingSeparates)
{
    const Mesh box = cube().mesh();
    EXPECT_EQ(applied("cut", box, "method=edges,edges=0~1").vertexCount(), 8u);
    EXPECT_EQ(applied("cut", box, "method=edges,edges=0~1;1~3").vertexCount(), 9u);
    const Mesh ring = applied("cut", box, "method=edges,edges=0~1;1~3;3~2;2~0");
    EXPECT_EQ(ring.vertexCount(), 12u);
    EXPECT_EQ(ring.topology().components, 2u);
    const Mesh all = applied("cut", box, "method=edges,edges=0~1;1~3;3~2;2~0;4~5;5~7;7~6;6~4;0~4;1~5;2~6;3~7");
    EXPECT_EQ(all.vertexCount(), 24u);
    EXPECT_EQ(all.topology().components, 6u);
}

TEST(Cut, SeamsAndAttributes)
{
    const Mesh box = source("box");
    const Mesh open = applied("cut", box, "method=seams");
    EXPECT_GT(open.vertexCount(), box.vertexCount());
    EXPECT_EQ(open.find("texcoord", Domain::Corner)->id(), box.find("texcoord", Domain::Corner)->id());
    Array<float> number;
    for (size_t v = 0; v < box.vertexCount(); ++v) number.push_back(float(v));
    const Mesh numbered = applied("cut", box.with(floatAttribute("number", Domain::Vertex, 1, number)), "method=seams");
    for (size_t c = 0; c < box.cornerCount(); ++c)
        EXPECT_EQ(numbered.find("number")->at(numbered.cornerVertex()[c], 0), double(box.cornerVertex()[c]));
}

TEST(Cut, WhatIsNotThereIsRefused)
{
    const Mesh box = cube().mesh();
    EXPECT_THROW(applied("cut", box, "method=edges,edges=0~7"), Error);
    EXPECT_THROW(applied("cut", box, "method=edges,edges=0~99"), Error);
    EXPECT_THROW(applied("cut", box, "method=shortest,vertices=0;99"), Error);
    EXPECT_THROW(applied("cut", box, "method=shortest,vertices=a"), Error);
    EXPECT_THROW(applied("cut", box, "method=seams"), Error) << "no texture coordinates";
    EXPECT_EQ(applied("cut", Mesh(), "").faceCount(), 0u);
}

}  // namespace
}  // namespace mw::test
