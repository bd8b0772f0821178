// Morphs between real meshes: both ends are the inputs to the last digit, by distances of points that neither end was made from.
#include <algorithm>
#include <gtest/gtest.h>

#include "core/catalog/others.h"
#include "core/io/io.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangle_tree.h"
#include "core/morph/morph.h"
#include "core/morph/target.h"
#include "tests/data.h"
#include "tests/longest_pull.h"
#include "tests/mesh_checks.h"

namespace mw {
namespace {

Mesh read(const std::filesystem::path& file)
{
    const Imported in = readFile(file);
    return in.scene.find(in.scene.meshes().front())->base;
}

/// The greatest distance of corners, middles of edges and of faces of a from b, as a share of the size of b.
double farthest(const Mesh& a, const Mesh& b)
{
    const TriangleTree tree(b);
    const Mesh::Triangulation& t = a.triangulation();
    std::vector<glm::dvec3> points;
    for (size_t i = 0; i < t.vertices.size(); i += 3) {
        const glm::dvec3 p(a.positions()[t.vertices[i]]), q(a.positions()[t.vertices[i + 1]]), r(a.positions()[t.vertices[i + 2]]);
        for (const glm::dvec3& x : {p, (p + q) / 2.0, (p + q + r) / 3.0}) points.push_back(x);
    }
    double worst = 0;
    for (const ClosestPoint& c : closestPoints(tree, points)) worst = std::max(worst, c.distance2);
    return std::sqrt(worst) / b.bounds().diagonal();
}

/// `size`: of the larger of the two meshes against that of b. A target is kept as displacement in floats, so that is what it is exact to.
void expectSameSurface(const Mesh& a, const Mesh& b, double size = 1)
{
    EXPECT_LT(farthest(a, b), 5e-7 * size);
    EXPECT_LT(farthest(b, a), 5e-7 * size);
    EXPECT_NEAR(surfaceArea(a), surfaceArea(b), 1e-5 * surfaceArea(b));
    if (b.topology().closed) {
        EXPECT_NEAR(enclosedVolume(a), enclosedVolume(b), 1e-5 * enclosedVolume(b));
    }
}

Mesh expectMorph(const Mesh& a, const Mesh& b, const char* parameters)
{
    const Operation& op = operation("morph");
    const Mesh m = std::get<Mesh>(apply(op, a, parsed(op.parameters, parameters), nullptr, {{"other", b}}));
    EXPECT_TRUE(test::checkMesh(m));
    const TopologyReport& t = m.topology();
    EXPECT_TRUE(t.manifold());
    EXPECT_TRUE(t.consistentlyOriented);
    EXPECT_EQ(t.euler, a.topology().euler);
    EXPECT_EQ(t.closed, a.topology().closed);
    EXPECT_TRUE(t.degenerateFaces.empty());
    EXPECT_TRUE(t.duplicateFaces.empty());
    expectSameSurface(m, a);
    expectSameSurface(towardsTarget(m, 1), b, 1 + a.bounds().diagonal() / b.bounds().diagonal());
    return m;
}

TEST(MorphPairs, SphericalOfClosedMeshes)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/closed_genus0" / name); };
    expectMorph(mesh("bunny_3k.off"), mesh("spot.obj"), "other=x");
    expectMorph(mesh("tet.obj"), mesh("bumpy.off"), "other=x,method=spherical");
    expectMorph(mesh("cube.off"), mesh("dodecahedron_poly.obj"), "other=x,method=spherical");
}

TEST(MorphPairs, SphericalOfHeads)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/closed_genus0" / name); };
    expectMorph(mesh("max_planck_5k.obj"), mesh("cheburashka.off"), "other=x");
}

TEST(MorphPairs, BarycentricOfDisks)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/disk" / name); };
    expectMorph(mesh("cat_head.obj"), mesh("hemisphere.off"), "other=x");
    expectMorph(mesh("planexy.off"), mesh("woody.obj"), "other=x,align=none");
}

TEST(MorphPairs, BarycentricOfHeadAndFlower)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/disk" / name); };
    expectMorph(mesh("camelhead.off"), mesh("lilium.obj"), "other=x");
}

/// About 1.3 s of work: less than 0.2 s between two looks at whether to go on.
TEST(MorphPairs, CancelIsHeardAllAlong)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/closed_genus0" / name); };
    Morph p;
    p.method = Morph::Method::Spherical;
    p.other = {.name = "x", .mesh = mesh("cheburashka.off")};
    Stage<Mesh> stage(false);
    const test::Pulls pulls = test::pulled(morph(mesh("armadillo.obj"), p, stage));
    EXPECT_GT(pulls.count, 500u);
    EXPECT_LT(pulls.share(), 0.25) << pulls.longest << " of " << pulls.all << " s";
}

TEST(MorphPairs, BarycentricOfMadeDisks)
{
    // Squares, with corners on corners and edges on edges.
    const Mesh coarse = *meshOfSource("grid:columns=3,rows=3"), fine = *meshOfSource("grid:columns=6,rows=6"),
               wide = *meshOfSource("grid:columns=5,rows=4,width=4");
    expectMorph(coarse, fine, "other=x,align=none");
    expectMorph(fine, coarse, "other=x");
    expectMorph(fine, wide, "other=x");
    const Mesh one = *meshOfSource("grid:columns=1,rows=1");
    expectMorph(one, wide, "other=x");
    expectMorph(Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Array<uint32_t>{0, 1, 2}), wide, "other=x");
}

}  // namespace
}  // namespace mw
