// Distances of surfaces against CGAL: of vertices by its tree, Hausdorff by its bounds, root mean squares by points that CGAL chooses.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

Surface surfaceOf(const Mesh& mesh)
{
    Surface s;
    for (const glm::vec3& p : mesh.positions()) s.add_vertex({p.x, p.y, p.z});
    const auto& t = mesh.triangulation().vertices;
    for (size_t i = 0; i < t.size(); i += 3)
        s.add_face(Surface::Vertex_index(t[i]), Surface::Vertex_index(t[i + 1]), Surface::Vertex_index(t[i + 2]));
    return s;
}

double rmsByCgal(const Surface& from, const Tree& to)
{
    std::vector<Kernel::Point_3> points;
    processing::sample_triangle_mesh(
        from, std::back_inserter(points),
        CGAL::parameters::random_seed(3).number_of_points_on_faces(40000).do_sample_vertices(false).do_sample_edges(false));
    double sum = 0;
    for (const auto& p : points) sum += to.squared_distance(p);
    return std::sqrt(sum / double(points.size()));
}

TEST(DistanceCgal, OfASimplifiedMeshToItsOriginal)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh original = meshOf(data / "meshes/closed_genus0/fandisk.off"), coarse = applied("decimate-quadric", original, "ratio=0.05");
    const Operation& op = operation("distance");
    const Table t = std::get<Table>(apply(op, coarse, {{"samples", int64_t(100000)}}, nullptr, {{"other", original}}));
    std::map<std::string, double> got(t.summary.begin(), t.summary.end());

    const Surface a = surfaceOf(coarse), b = surfaceOf(original);
    Tree toA(faces(a).begin(), faces(a).end(), a), toB(faces(b).begin(), faces(b).end(), b);
    toA.accelerate_distance_queries();
    toB.accelerate_distance_queries();
    const double diagonal = original.bounds().diagonal();
    EXPECT_NEAR(got["diagonal"], diagonal, 1e-12);
    for (size_t v = 0; v < coarse.vertexCount(); ++v) {
        const glm::vec3 p = coarse.positions()[v];
        const double expected = std::sqrt(toB.squared_distance({p.x, p.y, p.z}));
        EXPECT_NEAR(t.columns[1].values[v], expected, 1e-9 * diagonal);
        EXPECT_NEAR(t.columns[0].values[v], 100 * expected / diagonal, 1e-7);
    }
    EXPECT_NEAR(got["rms to other"], rmsByCgal(a, toB), 0.02 * got["rms to other"]);
    EXPECT_NEAR(got["rms from other"], rmsByCgal(b, toA), 0.02 * got["rms from other"]);
    // Never above the true one, and below it by no more than the spacing of the points.
    const double bound = 2e-3 * diagonal, far = processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(a, b, bound),
                 back = processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(b, a, bound);
    EXPECT_LE(got["hausdorff to other"], far + bound);
    EXPECT_GE(got["hausdorff to other"], far - bound - got["spacing"]);
    EXPECT_LE(got["hausdorff from other"], back + bound);
    EXPECT_GE(got["hausdorff from other"], back - bound - got["spacing"]);
    EXPECT_EQ(got["hausdorff"], std::max(got["hausdorff to other"], got["hausdorff from other"]));
}

}  // namespace
}  // namespace mw::test
