// Repair, orient, fill-holes, normalise: on small meshes of known answer, and by invariants on every mesh of the data set.
#include <cmath>
#include <gtest/gtest.h>

#include "core/math/random.h"
#include "core/mesh/topology.h"
#include "core/repair/boundary.h"
#include "tests/core/repair/repair_meshes.h"
#include "tests/data.h"
#include "tests/mesh_checks.h"

namespace mw::test {
namespace {

Mesh triangles(std::initializer_list<glm::vec3> points, std::initializer_list<uint32_t> indices)
{
    return Mesh::triangles(Array<glm::vec3>(points), Array<uint32_t>(indices));
}

/// Two cubes with one common edge: shared vertices 6 and 7 of the first are 0 and 1 of the second.
Mesh cubesOnAnEdge()
{
    Polygons p = cube();
    const uint32_t base = 8;
    for (int i = 2; i < 8; ++i) p.positions.emplace_back(1 + (i >> 2), 1 + (i >> 1 & 1), i & 1);
    const auto at = [&](uint32_t i) { return i < 2 ? 6 + i : base + i - 2; };
    const Polygons second = cube();
    for (size_t f = 0; f + 1 < second.start.size(); ++f) {
        for (uint32_t c = second.start[f]; c < second.start[f + 1]; ++c) p.corners.push_back(at(second.corners[c]));
        p.start.push_back(uint32_t(p.corners.size()));
    }
    return p.mesh();
}

TEST(Repair, TwoCubesOnOneEdgeBecomeTwoCubes)
{
    const Mesh joined = cubesOnAnEdge();
    ASSERT_EQ(joined.topology().nonmanifoldEdges.size(), 1u);
    const Mesh out = applied("repair", joined, "");
    const TopologyReport& r = out.topology();
    EXPECT_TRUE(r.manifold() && r.closed && r.consistentlyOriented);
    EXPECT_EQ(r.components, 2u);
    EXPECT_EQ(r.euler, 4);
    EXPECT_EQ(out.faceCount(), 12u);
    EXPECT_NEAR(enclosedVolume(out), 2, 1e-6);
}

TEST(Repair, ThreeFacesOnAnEdgeLoseNoneAndTwoStayTogether)
{
    const Mesh fan = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {0, 1, 2, 1, 0, 3, 0, 1, 4});
    const Mesh out = applied("repair", fan, "");
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(out.faceCount(), 3u);
    EXPECT_EQ(out.topology().components, 2u);
    EXPECT_EQ(out.vertexCount(), 7u);
    EXPECT_EQ(out.cornerVertex()[0], 0u) << "the flat pair keeps the edge";
    EXPECT_EQ(out.cornerVertex()[4], 0u);
}

/// A disk of faces that is glued to itself along an edge: the faces there part although they hang together round both ends.
TEST(Repair, AnEdgeWhoseFacesHangTogetherRoundItsEndsIsSplit)
{
    Polygons p = Polygons::points(12);
    p.face({0, 1, 2}).face({1, 0, 3}).face({0, 1, 4}).face({1, 0, 5});
    p.face({0, 2, 6}).face({0, 6, 4}).face({1, 3, 7}).face({1, 7, 5}).face({2, 1, 8}).face({8, 1, 5});
    const Mesh mesh = p.mesh();
    ASSERT_FALSE(mesh.topology().manifold());
    const Mesh out = applied("repair", mesh, "");
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(out.faceCount(), mesh.faceCount());
}

TEST(Repair, EachFlagDoesItsOwnAlone)
{
    Polygons p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}};
    p.face({0, 1, 2}).face({0, 3, 4}).face({2, 1, 0}).face({0, 0, 1});
    const Mesh mesh = p.mesh();
    const std::string off = "split-edges=false,split-vertices=false,drop-degenerate=false,drop-duplicates=false,drop-isolated=false";
    EXPECT_EQ(contentHash(applied("repair", mesh, off.c_str())), contentHash(mesh));
    const auto only = [&](const std::string& flag) {
        std::string text = off;
        return applied("repair", mesh, text.replace(text.find(flag + "=false"), flag.size() + 6, flag + "=true").c_str());
    };
    EXPECT_EQ(only("drop-degenerate").faceCount(), 3u);
    EXPECT_EQ(only("drop-duplicates").faceCount(), 3u);
    EXPECT_EQ(only("drop-isolated").vertexCount(), 5u);
    const Mesh all = applied("repair", mesh, "");
    EXPECT_EQ(all.faceCount(), 2u);
    EXPECT_EQ(all.vertexCount(), 6u) << "one copy more, one loose vertex less";
    EXPECT_TRUE(all.topology().manifold());
}

TEST(Repair, AnOutlineWithABridgeToItsHoleKeepsItsArea)
{
    Polygons p;
    p.positions = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
    p.face({0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
    const Mesh out = applied("repair", p.mesh(), "");
    EXPECT_TRUE(out.topology().degenerateFaces.empty() && out.topology().manifold());
    EXPECT_NEAR(surfaceArea(out), 8, 1e-6);
    EXPECT_EQ(out.topology().euler, 0) << "an annulus";
    EXPECT_EQ(out.topology().boundaryLoops.size(), 2u);
}

TEST(Repair, WeldingClosesACrackAndLeavesWhatWouldPinch)
{
    const Mesh apart =
        triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {0, 1, 2, 4, 3, 5, 6, 7, 8});
    const Mesh out = applied("repair", apart, "weld=true");
    EXPECT_EQ(out.vertexCount(), 7u) << "two joined; the tip of the third triangle would make two fans";
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(contentHash(applied("repair", out, "weld=true")), contentHash(out));
}

TEST(Repair, TinyPiecesGoTheLargestStays)
{
    Polygons p = tetrahedron();
    const Polygons other = tetrahedron();
    for (const glm::vec3& v : other.positions) p.positions.push_back(5.f + 0.01f * v);
    for (size_t f = 0; f < 4; ++f) {
        for (uint32_t c = 3 * uint32_t(f); c < 3 * uint32_t(f) + 3; ++c) p.corners.push_back(4 + other.corners[c]);
        p.start.push_back(uint32_t(p.corners.size()));
    }
    EXPECT_EQ(applied("repair", p.mesh(), "").faceCount(), 8u);
    EXPECT_EQ(applied("repair", p.mesh(), "drop-tiny=true").faceCount(), 4u);
    EXPECT_EQ(applied("repair", p.mesh(), "drop-tiny=true,tiny-share=1").faceCount(), 4u);
    EXPECT_EQ(applied("repair", p.mesh(), "drop-tiny=true,tiny-share=0.0001").faceCount(), 8u);
}

TEST(Repair, PointsWithoutFacesStay)
{
    const Mesh points(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}}, Array<uint32_t>{0u}, Array<uint32_t>{});
    EXPECT_EQ(applied("repair", points, "").vertexCount(), 2u);
}

TEST(Repair, AttributesGoWithTheirElements)
{
    const Mesh bow = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {0, 1, 2, 0, 3, 4})
                         .with(floatAttribute("weight", Domain::Vertex, 1, {1, 2, 3, 4, 5}))
                         .with(floatAttribute("texcoord", Domain::Corner, 2, {0, 0, 1, 0, 0, 1, 5, 5, 6, 5, 5, 6}))
                         .with(integerAttribute("material", Domain::Face, 1, {7, 8}));
    const Mesh out = applied("repair", bow, "");
    EXPECT_TRUE(checkMesh(out));
    ASSERT_EQ(out.vertexCount(), 6u);
    EXPECT_EQ(out.find("weight")->at(5, 0), 1) << "the copy has the value of its vertex";
    EXPECT_EQ(out.find("texcoord")->at(3, 0), 5);
    EXPECT_EQ(out.find("material")->integers()[1], 8);
}

TEST(Orient, TurnedFacesOfASphereAreTurnedBack)
{
    const Mesh damaged = std::get<Mesh>(apply(operation("damaged-sphere"), {}, {{"holes", int64_t(0)}, {"turned", 0.4}}));
    ASSERT_FALSE(damaged.topology().consistentlyOriented);
    const Mesh out = applied("orient", damaged, "");
    EXPECT_TRUE(out.topology().consistentlyOriented);
    EXPECT_GT(enclosedVolume(out), 3.9);
    EXPECT_EQ(out.faceCount(), damaged.faceCount());
}

TEST(Orient, InsideOutIsSeenBySignedVolume)
{
    Polygons p = tetrahedron();
    for (size_t i = 0; i < p.corners.size(); i += 3) std::swap(p.corners[i + 1], p.corners[i + 2]);
    ASSERT_LT(enclosedVolume(p.mesh()), 0);
    EXPECT_NEAR(enclosedVolume(applied("orient", p.mesh(), "")), 1.0 / 6, 1e-6);
    EXPECT_NEAR(enclosedVolume(applied("orient", p.mesh(), "outside=majority")), -1.0 / 6, 1e-6);
    EXPECT_NEAR(enclosedVolume(applied("orient", p.mesh(), "outside=keep-first")), -1.0 / 6, 1e-6);
}

TEST(Orient, AMoebiusStripKeepsOneCut)
{
    const Mesh strip = moebius(20).mesh();
    ASSERT_FALSE(strip.topology().orientable);
    const Mesh out = applied("orient", strip, "");
    EXPECT_EQ(out.topology().inconsistentEdges.size(), 1u) << "one cut across";
    const Mesh cut = applied("orient", strip, "cut=true");
    EXPECT_TRUE(cut.topology().orientable && cut.topology().consistentlyOriented && cut.topology().manifold());
    EXPECT_EQ(cut.vertexCount(), strip.vertexCount() + 2);
    EXPECT_EQ(cut.topology().boundaryLoops.size(), 1u);
    EXPECT_EQ(cut.topology().euler, 1) << "a disk";
}

TEST(Orient, CornersNormalsAndCreasesFollowTheFlip)
{
    // The second quad runs the wrong way. A crease lies on its side from corner 1 to corner 2.
    Polygons p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {3, 0, 0}, {3, 1, 0}};
    p.face({0, 1, 2, 3}).face({1, 2, 5, 4}).face({4, 6, 7, 5});
    Array<float> texcoord, normal, crease;
    for (uint32_t v : p.corners) texcoord.insert(texcoord.end(), {p.positions[v].x, p.positions[v].y});
    for (uint32_t c = 0; c < 12; ++c) normal.insert(normal.end(), {0, 0, c >= 4 && c < 8 ? -1.f : 1.f});
    for (uint32_t c = 0; c < 12; ++c) crease.push_back(c == 5 ? 2.f : 0.f);  // from vertex 2 to vertex 5
    const Mesh mesh = p.mesh()
                          .with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
                          .with(floatAttribute("normal", Domain::Corner, 3, normal))
                          .with(floatAttribute("crease", Domain::Corner, 1, crease));
    const Mesh out = applied("orient", mesh, "");
    ASSERT_TRUE(out.topology().consistentlyOriented);
    for (uint32_t c = 0; c < 12; ++c) {
        const glm::vec3 at = out.positions()[out.cornerVertex()[c]];
        EXPECT_EQ(out.find("texcoord")->at(c, 0), at.x);
        EXPECT_EQ(out.find("texcoord")->at(c, 1), at.y);
        EXPECT_EQ(out.find("normal")->at(c, 2), 1);
        const uint32_t next = c % 4 == 3 ? c - 3 : c + 1;
        const bool creased = std::minmax(out.cornerVertex()[c], out.cornerVertex()[next]) == std::pair<const uint32_t&, const uint32_t&>(2u, 5u);
        if (c / 4 == 1) {
            EXPECT_EQ(out.find("crease")->at(c, 0), creased ? 2 : 0) << c;
        }
    }
}

TEST(FillHoles, ACubeWithoutItsLidIsClosedFlat)
{
    Polygons p = cube();
    p.corners.resize(20);
    p.start.resize(6);
    const Mesh out = applied("fill-holes", p.mesh(), "");
    EXPECT_TRUE(out.topology().closed && out.topology().manifold() && out.topology().consistentlyOriented);
    EXPECT_EQ(out.faceCount(), 7u);
    EXPECT_NEAR(enclosedVolume(out), 1, 1e-6);
    EXPECT_NEAR(surfaceArea(out), 6, 1e-6);
}

/// A flat hole has many triangulations of equal bend: the least area is that of the hole itself, however concave.
TEST(FillHoles, AConcaveFlatHoleGetsItsOwnArea)
{
    // A star-shaped tube: outline in the plane, extruded downwards; bottom rim kept by keep-largest being equal, so both are filled.
    Polygons p;
    const uint32_t n = 24;
    double area = 0;
    for (uint32_t i = 0; i < n; ++i) {
        const double r = i % 2 ? 1 : 2, u = 2 * M_PI * i / n;
        p.positions.emplace_back(r * std::cos(u), r * std::sin(u), 0);
        p.positions.emplace_back(r * std::cos(u), r * std::sin(u), -1);
        area += std::sin(2 * M_PI / n);  // half of 1 * 2 * sin: one triangle to the centre
    }
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        p.face({2 * i, 2 * i + 1, 2 * j + 1, 2 * j});
    }
    const Mesh out = applied("fill-holes", p.mesh(), "");
    EXPECT_TRUE(out.topology().closed && out.topology().manifold());
    EXPECT_NEAR(enclosedVolume(out), area, 1e-4);
    EXPECT_NEAR(surfaceArea(out) - surfaceArea(p.mesh()), 2 * area, 1e-4);
}

TEST(FillHoles, LargerThanTheTableAllows)
{
    Polygons p;
    const uint32_t n = 5000;
    for (uint32_t i = 0; i < n; ++i)
        for (const float z : {0.f, -1.f}) p.positions.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), z);
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t j = (i + 1) % n;
        p.face({2 * i, 2 * i + 1, 2 * j + 1, 2 * j});
    }
    const Mesh out = applied("fill-holes", p.mesh(), "");
    EXPECT_TRUE(out.topology().closed && out.topology().manifold() && out.topology().consistentlyOriented);
    EXPECT_NEAR(enclosedVolume(out), M_PI, 1e-3);
    EXPECT_EQ(out.faceCount(), n + 2 * (n - 2));
}

TEST(FillHoles, ALoneTriangleIsNotDoubled)
{
    const Mesh out = applied("fill-holes", triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}), "");
    EXPECT_TRUE(out.topology().closed && out.topology().manifold() && out.topology().duplicateFaces.empty());
    EXPECT_EQ(out.topology().euler, 2);
}

/// Four triangles round a vertex, every second one missing: two holes that touch there, and one outline round all.
TEST(FillHoles, HolesThatTouchAtAVertexAreFilledOneByOne)
{
    Polygons p = grid(4, false, true);
    std::vector<uint32_t> gone{5, 10};  // two quads that share one vertex
    Polygons q;
    q.positions = p.positions;
    for (uint32_t f = 0; f < 16; ++f) {
        if (f == gone[0] || f == gone[1]) continue;
        for (uint32_t c = 4 * f; c < 4 * f + 4; ++c) q.corners.push_back(p.corners[c]);
        q.start.push_back(uint32_t(q.corners.size()));
    }
    const auto loops = boundaryLoopsOf(q.mesh());
    ASSERT_EQ(loops.size(), 3u);
    const Mesh out = applied("fill-holes", q.mesh(), "max-edges=4");
    EXPECT_EQ(out.topology().boundaryLoops.size(), 1u);
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(out.topology().euler, 1);
    EXPECT_NEAR(surfaceArea(out), surfaceArea(p.mesh()), 1e-5);
}

TEST(FillHoles, TheLargestLoopAndLargeOnesStay)
{
    const Mesh damaged = std::get<Mesh>(apply(operation("damaged-sphere"), {}, {{"holes", int64_t(2)}, {"turned", 0.0}, {"seed", int64_t(3)}}));
    const Mesh mesh = applied("repair", damaged, "");
    ASSERT_EQ(mesh.topology().boundaryLoops.size(), 2u);
    EXPECT_EQ(applied("fill-holes", mesh, "keep-largest=true").topology().boundaryLoops.size(), 1u);
    EXPECT_EQ(applied("fill-holes", mesh, "max-edges=3").topology().boundaryLoops.size(), 2u);
    EXPECT_EQ(applied("fill-holes", mesh, "").topology().boundaryLoops.size(), 0u);
}

/// The vertices of a hole in a sphere come back to the sphere, at the density around.
TEST(FillHoles, AFairSurfaceGoesOnRound)
{
    const Mesh damaged =
        std::get<Mesh>(apply(operation("damaged-sphere"), {}, {{"subdivisions", int64_t(4)}, {"holes", int64_t(0)}, {"turned", 0.0}}));
    Array<uint32_t> cap;
    for (size_t f = 0; f < damaged.faceCount(); ++f) {
        const auto v = damaged.face(f);
        if (damaged.positions()[v[0]].y < 0.9f) cap.insert(cap.end(), v.begin(), v.end());
    }
    const Mesh open = applied("repair", Mesh::triangles(damaged.positions(), cap), "");
    const Mesh flat = applied("fill-holes", open, ""), round = applied("fill-holes", open, "method=fair");
    EXPECT_TRUE(round.topology().closed && round.topology().manifold() && round.topology().consistentlyOriented);
    EXPECT_EQ(round.topology().euler, 2);
    EXPECT_GT(round.vertexCount(), flat.vertexCount() + 20);
    double worst = 0;
    for (size_t v = open.vertexCount(); v < round.vertexCount(); ++v) worst = std::max(worst, std::abs(glm::length(round.positions()[v]) - 1.0));
    EXPECT_LT(worst, 0.02) << "the flat one is off by 0.1 in the middle";
    EXPECT_LT(std::abs(enclosedVolume(round) - enclosedVolume(damaged)), 0.2 * std::abs(enclosedVolume(flat) - enclosedVolume(damaged)));
}

TEST(Normalise, FitsBoxAndSphereAndStandsOnTheFloor)
{
    const Mesh mesh = grid(6, true, false).mesh();
    const Bounds box = applied("normalise", mesh, "size=2").bounds();
    EXPECT_NEAR(std::max({box.size().x, box.size().y, box.size().z}), 2, 1e-6);
    EXPECT_NEAR(glm::length(box.centre()), 0, 1e-6);
    const Mesh ball = applied("normalise", mesh, "fit=sphere,centre=centroid");
    double farthest = 0;
    for (const glm::vec3& p : ball.positions()) farthest = std::max(farthest, double(glm::length(p)));
    EXPECT_NEAR(farthest, 0.5, 1e-6);
    EXPECT_NEAR(applied("normalise", mesh, "floor=true").bounds().min.y, 0, 1e-6);
    EXPECT_EQ(contentHash(applied("normalise", mesh, "fit=keep,centre=keep")), contentHash(mesh));
    const Mesh point(Array<glm::vec3>{{4, 5, 6}}, Array<uint32_t>{0u}, Array<uint32_t>{});
    EXPECT_EQ(applied("normalise", point, "").positions()[0], glm::vec3(0));
}

/// Faces by chance over few vertices, some of them at one place: every way to be wrong, all at once.
Mesh soup(Random& random)
{
    const auto below = [&](uint32_t n) { return uint32_t(random.uniform() * n); };
    Polygons p;
    const uint32_t vertices = 4 + below(12), faces = 1 + below(24);
    const int places = 2 + int(below(3));
    for (uint32_t v = 0; v < vertices; ++v) p.positions.emplace_back(below(places), below(places), below(places));
    for (uint32_t f = 0; f < faces; ++f) {
        const uint32_t corners = random.uniform() < 0.8 ? 3 : 1 + below(6);
        for (uint32_t c = 0; c < corners; ++c) p.corners.push_back(below(vertices));
        p.start.push_back(uint32_t(p.corners.size()));
    }
    return p.mesh();
}

TEST(RepairOfSoups, EverySoupBecomesACleanClosedManifold)
{
    Random random(11);
    for (int round = 0; round < 2000; ++round) {
        SCOPED_TRACE(round);
        const Mesh mesh = soup(random);
        for (const char* how : {"", "weld=true"}) {
            SCOPED_TRACE(how);
            const Mesh mended = applied("repair", mesh, how);
            ASSERT_TRUE(checkMesh(mended));
            const TopologyReport& r = mended.topology();
            ASSERT_TRUE(r.manifold() && r.degenerateFaces.empty() && r.duplicateFaces.empty() && r.isolatedVertices.empty());
            ASSERT_EQ(contentHash(applied("repair", mended, "")), contentHash(mended));
            const Mesh oriented = applied("orient", mended, "cut=true");
            ASSERT_TRUE(oriented.topology().consistentlyOriented && oriented.topology().manifold());
            ASSERT_EQ(oriented.faceCount(), mended.faceCount());
            for (const char* method : {"method=flat", "method=fair"}) {
                const Mesh filled = applied("fill-holes", oriented, method);
                ASSERT_TRUE(checkMesh(filled));
                const TopologyReport& f = filled.topology();
                ASSERT_TRUE(f.manifold() && f.consistentlyOriented && f.degenerateFaces.empty()) << method;
                ASSERT_TRUE(f.closed || filled.faceCount() == 0) << method;
            }
        }
        // As it comes, not repaired first: a result, whatever it is.
        ASSERT_TRUE(checkMesh(applied("fill-holes", mesh, "")));
        ASSERT_TRUE(checkMesh(applied("orient", mesh, "cut=true")));
    }
}

size_t facesLeft(const Mesh& mesh)
{
    const TopologyReport& r = mesh.topology();
    return mesh.faceCount() - r.degenerateFaces.size() - r.duplicateFaces.size();
}

/// Every mesh: what each operation promises.
TEST(RepairOnData, EveryMeshBecomesACleanClosedManifold)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t tried = 0;
    for (const auto& file : meshFiles(data, {"meshes", "malformed"}, size_t(5) << 20)) {
        SCOPED_TRACE(file.string());
        const std::optional<Mesh> mesh = readableMesh(file);
        if (!mesh) continue;
        ++tried;
        const Mesh mended = applied("repair", *mesh, "");
        EXPECT_TRUE(checkMesh(mended));
        const TopologyReport& r = mended.topology();
        EXPECT_TRUE(r.manifold() && r.degenerateFaces.empty() && r.duplicateFaces.empty());
        EXPECT_TRUE(r.isolatedVertices.empty() || !mended.lines().empty());
        EXPECT_GE(mended.faceCount(), facesLeft(*mesh)) << "no face is lost that need not go";
        EXPECT_NEAR(surfaceArea(mended), surfaceArea(applied("repair", *mesh, "split-edges=false,split-vertices=false")), 1e-9 * surfaceArea(*mesh));
        EXPECT_EQ(contentHash(applied("repair", mended, "")), contentHash(mended)) << "a second run changes nothing";

        const Mesh oriented = applied("orient", mended, "cut=true");
        EXPECT_TRUE(oriented.topology().consistentlyOriented && oriented.topology().manifold());
        EXPECT_EQ(oriented.faceCount(), mended.faceCount());
        EXPECT_EQ(contentHash(applied("orient", oriented, "cut=true")), contentHash(oriented));

        for (const char* method : {"method=flat", "method=fair"}) {
            const Mesh filled = applied("fill-holes", oriented, method);
            EXPECT_TRUE(checkMesh(filled));
            const TopologyReport& f = filled.topology();
            EXPECT_TRUE(f.manifold() && f.consistentlyOriented && f.duplicateFaces.empty() && f.degenerateFaces.empty()) << method;
            EXPECT_TRUE(f.closed || filled.faceCount() == 0);
            EXPECT_EQ(f.euler, oriented.topology().euler + long(oriented.topology().boundaryLoops.size())) << "each loop filled adds one";
        }
    }
    EXPECT_GT(tried, 40u);
}

}  // namespace
}  // namespace mw::test
