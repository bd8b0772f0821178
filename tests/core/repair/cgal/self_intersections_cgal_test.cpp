// Self-intersections against CGAL's, pair by pair; and the sign of orientations against exact rational numbers.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "core/math/predicates.h"
#include "core/math/random.h"
#include "core/mesh/topology.h"
#include "core/repair/self_intersections.h"
#include "tests/core/repair/repair_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Its triangles as CGAL holds them, in the same order. A manifold, oriented mesh.
Surface surfaceOf(const Mesh& mesh)
{
    Surface s;
    for (const glm::vec3& p : mesh.positions()) s.add_vertex({p.x, p.y, p.z});
    const auto& t = mesh.triangulation().vertices;
    for (size_t i = 0; i < t.size(); i += 3) {
        const auto f = s.add_face(Surface::Vertex_index(t[i]), Surface::Vertex_index(t[i + 1]), Surface::Vertex_index(t[i + 2]));
        EXPECT_NE(f, Surface::null_face());
    }
    return s;
}

std::vector<FacePair> cgalPairs(const Surface& s)
{
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(s, std::back_inserter(found));
    std::vector<FacePair> out;
    for (const auto& [a, b] : found)
        if (a != b) out.push_back(std::minmax(uint32_t(a), uint32_t(b)));  // a face with itself: it has no area
    std::sort(out.begin(), out.end());
    return out;
}

Mesh asTriangles(const Mesh& mesh)
{
    return Mesh::triangles(mesh.positions(), mesh.triangulation().vertices);
}

void expectSamePairs(const Mesh& mesh)
{
    const std::vector<FacePair> expected = cgalPairs(surfaceOf(mesh));
    const std::vector<FacePair> found = selfIntersectionsOf(mesh, {.byPlace = false, .most = size_t(1) << 30});
    EXPECT_EQ(found, expected) << found.size() << " found, " << expected.size() << " expected";
}

TEST(SelfIntersections, EveryMeshAgreesWithCgalPairByPair)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t tried = 0, pairs = 0;
    for (const auto& file : meshFiles(data, {"meshes"}, size_t(5) << 20)) {
        SCOPED_TRACE(file.string());
        const std::optional<Mesh> mesh = readableMesh(file);
        if (!mesh) continue;
        // As CGAL's mesh wants it: triangles, manifold, oriented.
        const Mesh clean = applied("repair", applied("orient", asTriangles(applied("repair", *mesh, "")), "cut=true"), "");
        expectSamePairs(clean);
        pairs += selfIntersectionsOf(clean, {.byPlace = false}).size();
        ++tried;
    }
    EXPECT_GT(tried, 40u);
    EXPECT_GT(pairs, 1000u);
}

/// Every position relation by chance: corners on a grid of few places, so that triangles touch, overlap in a plane, share corners and sides.
TEST(SelfIntersections, SmallGridsAgreeWithCgalPairByPair)
{
    Random random(7);
    for (int round = 0; round < 300; ++round) {
        const int side = 2 + round % 3, count = 40;
        Array<glm::vec3> points;
        Array<uint32_t> triangles;
        for (int t = 0; t < count; ++t) {
            for (int k = 0; k < 3; ++k) {
                const auto coordinate = [&] { return float(int(random.uniform() * side)); };
                const float x = coordinate(), y = coordinate(), z = round % 4 == 0 ? 0 : coordinate();
                triangles.push_back(uint32_t(points.size()));
                points.emplace_back(x, y, z);
            }
        }
        SCOPED_TRACE(round);
        expectSamePairs(Mesh::triangles(points, triangles));
    }
}

/// The same with common vertices: a sphere whose vertices are moved to a coarse grid.
TEST(SelfIntersections, CrumpledSpheresAgreeWithCgalPairByPair)
{
    for (const float cells : {2.f, 3.f, 5.f, 9.f, 30.f}) {
        const Mesh sphere = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(3)}}));
        Array<glm::vec3> points;
        for (const glm::vec3& p : sphere.positions())
            points.push_back(glm::vec3(std::round(p.x * cells), std::round(p.y * cells), std::round(p.z * cells)));
        SCOPED_TRACE(cells);
        expectSamePairs(sphere.withPositions(points));
    }
}

TEST(Orientation, MatchesRationalNumbers)
{
    using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        glm::vec3 p[4];
        for (glm::vec3& q : p)
            for (int k = 0; k < 3; ++k) {
                const double wide = std::ldexp(random.uniform() - 0.5, int(random.uniform() * 80) - 40);
                q[k] = i % 3 == 0 ? float(wide) : i % 3 == 1 ? float(0.1 * int(random.uniform() * 4)) : float(12 + 1e-6 * int(random.uniform() * 9));
            }
        Exact::Point_3 e[4];
        for (int k = 0; k < 4; ++k) e[k] = Exact::Point_3(p[k].x, p[k].y, p[k].z);
        const int expected = -int(CGAL::orientation(e[0], e[1], e[2], e[3]));
        ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), expected);
        ASSERT_EQ(exactOrientation(p[0], p[1], p[2], p[3]), expected);
        const Exact::Point_2 a(p[0].x, p[0].y), b(p[1].x, p[1].y), c(p[2].x, p[2].y);
        ASSERT_EQ(orientation(glm::vec2(p[0]), glm::vec2(p[1]), glm::vec2(p[2])), int(CGAL::orientation(a, b, c)));
    }
}

/// What repair, orient and fill-holes make is a valid solid for CGAL, too: closed, bounding a volume where nothing intersects.
TEST(RepairedMesh, IsAValidMeshForCgal)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const auto& file : meshFiles(data, {"meshes"}, size_t(5) << 20)) {
        SCOPED_TRACE(file.string());
        const std::optional<Mesh> mesh = readableMesh(file);
        if (!mesh) continue;
        // Triangles from the start: polygons that share three vertices may be a manifold which their triangles are not.
        const Mesh clean = applied("repair", asTriangles(applied("repair", *mesh, "")), "");
        const Mesh solid = applied("fill-holes", applied("orient", clean, "cut=true"), "");
        const Surface s = surfaceOf(solid);
        EXPECT_TRUE(s.is_valid(false));
        EXPECT_TRUE(CGAL::is_closed(s));
        if (selfIntersectionsOf(solid, {.byPlace = false}).empty() && solid.topology().components == 1 && enclosedVolume(solid) != 0) {
            EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_outward_oriented(s));
        }
    }
}

}  // namespace
}  // namespace mw::test
