// Closest points against CGAL's tree, on scanned and modelled meshes.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>
#include <random>

#include "core/mesh/triangle_tree.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 pointOf(const glm::dvec3& p)
{
    return {p.x, p.y, p.z};
}

/// Triangles with an area: CGAL's distance does not take others.
Triangles trianglesOf(const Mesh& mesh)
{
    Triangles out;
    const Shared<uint32_t>& v = mesh.triangulation().vertices;
    for (size_t i = 0; i < v.size(); i += 3) {
        const Kernel::Triangle_3 t(pointOf(mesh.positions()[v[i]]), pointOf(mesh.positions()[v[i + 1]]), pointOf(mesh.positions()[v[i + 2]]));
        if (t.squared_area() > 0) out.push_back(t);
    }
    return out;
}

TEST(TriangleTreeCgal, SameDistances)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name :
         {"closed_genus0/fandisk.off", "disk/camelhead.off", "boundary/intersection_quads.off", "closed_higher_genus/3holes.off"}) {
        SCOPED_TRACE(name);
        const Mesh mesh = meshOf(data / "meshes" / name);
        const TriangleTree tree(mesh);
        const Triangles triangles = trianglesOf(mesh);
        Tree cgal(triangles.begin(), triangles.end());
        cgal.accelerate_distance_queries();
        const Bounds box = mesh.bounds();
        std::mt19937 r(17);
        std::uniform_real_distribution<double> u(-0.3, 1.3);
        for (int i = 0; i < 500; ++i) {
            const double x = u(r), y = u(r), z = u(r);
            const glm::dvec3 p = box.min + glm::dvec3(x, y, z) * box.size();
            const double expected = std::sqrt(cgal.squared_distance(pointOf(p)));
            EXPECT_NEAR(std::sqrt(tree.closest(p).distance2), expected, 1e-9 * box.diagonal());
        }
    }
}

}  // namespace
}  // namespace mw::test
