// CGAL: its simplification, and its tree for distances.
#include "bench/simplify_peers.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <glm/geometric.hpp>
#include <random>

#include "bench/bench_meshes.h"

namespace mw::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace sms = CGAL::Surface_mesh_simplification;

Surface surfaceOf(const Mesh& mesh)
{
    Surface s;
    s.reserve(uint32_t(mesh.vertexCount()), uint32_t(mesh.cornerCount() / 2), uint32_t(mesh.faceCount()));
    for (const glm::vec3& p : mesh.positions()) s.add_vertex({p.x, p.y, p.z});
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto c = mesh.face(f);
        s.add_face(Surface::Vertex_index(c[0]), Surface::Vertex_index(c[1]), Surface::Vertex_index(c[2]));
    }
    return s;
}

Mesh meshOf(Surface& s)
{
    s.collect_garbage();
    Array<glm::vec3> positions;
    Array<uint32_t> corners;
    for (const auto v : s.vertices()) positions.emplace_back(s.point(v).x(), s.point(v).y(), s.point(v).z());
    for (const auto f : s.faces())
        for (const auto v : vertices_around_face(s.halfedge(f), s)) corners.push_back(uint32_t(v));
    return Mesh::triangles(std::move(positions), std::move(corners));
}

/// Points spread evenly over the area, always the same ones.
std::vector<Kernel::Point_3> spread(const Mesh& mesh, size_t samples)
{
    std::vector<double> upTo;
    double area = 0;
    const auto corner = [&](size_t f, size_t k) { return glm::dvec3(mesh.positions()[mesh.face(f)[k]]); };
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        upTo.push_back(area += glm::length(glm::cross(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0))));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Kernel::Point_3> points;
    for (size_t i = 0; i < samples; ++i) {
        const size_t f = std::min<size_t>(size_t(std::lower_bound(upTo.begin(), upTo.end(), unit(random) * area) - upTo.begin()), upTo.size() - 1);
        double a = unit(random), b = unit(random);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const glm::dvec3 p = (1 - a - b) * corner(f, 0) + a * corner(f, 1) + b * corner(f, 2);
        points.emplace_back(p.x, p.y, p.z);
    }
    return points;
}

double meanSquare(const Mesh& from, const Mesh& to, size_t samples)
{
    using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
    const Surface surface = surfaceOf(to);
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(faces(surface).first, faces(surface).second, surface);
    tree.accelerate_distance_queries();
    double sum = 0;
    for (const auto& p : spread(from, samples)) sum += tree.squared_distance(p);
    return sum / double(samples);
}

}  // namespace

Mesh cgalGarlandHeckbert(const Mesh& mesh, double ratio, double& seconds)
{
    Surface s = surfaceOf(mesh);
    seconds = quickest(1, [&] {
        using Policies = sms::GarlandHeckbert_plane_policies<Surface, Kernel>;
        const Policies policies(s);
        const sms::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
        const sms::Count_ratio_stop_predicate<Surface> stop(ratio);
        sms::edge_collapse(s, stop, CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
    });
    return meshOf(s);
}

Mesh cgalLindstromTurk(const Mesh& mesh, double ratio, double& seconds)
{
    Surface s = surfaceOf(mesh);
    seconds = quickest(1, [&] {
        const sms::Count_ratio_stop_predicate<Surface> stop(ratio);
        sms::edge_collapse(s, stop,
                           CGAL::parameters::get_cost(sms::LindstromTurk_cost<Surface>()).get_placement(sms::LindstromTurk_placement<Surface>()));
    });
    return meshOf(s);
}

double rmsDistance(const Mesh& a, const Mesh& b, size_t samples)
{
    return std::sqrt(std::max(meanSquare(a, b, samples), meanSquare(b, a, samples))) / a.bounds().diagonal();
}

double cgalClosest(const Mesh& mesh, const std::vector<glm::dvec3>& points, double& makeSeconds, double& askSeconds)
{
    using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
    const Surface surface = surfaceOf(mesh);
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(faces(surface).first, faces(surface).second, surface);
    makeSeconds = quickest(1, [&] {
        tree.build();
        tree.accelerate_distance_queries();
    });
    double sum = 0;
    askSeconds = quickest(1, [&] {
        for (const glm::dvec3& p : points) sum += std::sqrt(CGAL::to_double(tree.squared_distance({p.x, p.y, p.z})));
    });
    return sum;
}

}  // namespace mw::bench
