// Planar embeddings against CGAL's surface parameterization.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <complex>
#include <gtest/gtest.h>

#include "core/parameterize/embed_planar.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

namespace Unwrap = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Solver = CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;
using ByLength = Unwrap::Circular_border_arc_length_parameterizer_3<Surface>;
using InEqualSteps = Unwrap::Circular_border_uniform_parameterizer_3<Surface>;
using Places = std::vector<std::complex<double>>;

template <class Method>
Places cgalPlaces(const Mesh& mesh)
{
    Surface s;
    for (const glm::vec3& p : mesh.positions()) s.add_vertex({p.x, p.y, p.z});
    const auto& t = mesh.triangulation().vertices;
    for (size_t i = 0; i < t.size(); i += 3)
        s.add_face(Surface::Vertex_index(t[i]), Surface::Vertex_index(t[i + 1]), Surface::Vertex_index(t[i + 2]));
    auto uv = s.add_property_map<Surface::Vertex_index, Kernel::Point_2>("uv").first;
    Surface::Halfedge_index border;
    for (const auto h : s.halfedges())
        if (s.is_border(h)) border = h;
    EXPECT_EQ(Unwrap::parameterize(s, Method(), border, uv), Unwrap::OK);
    Places out;
    for (const auto v : s.vertices()) out.emplace_back(uv[v].x(), uv[v].y());
    return out;
}

/// The largest distance after the one turn, mirror and scale that takes our border to theirs, in radii of the circle.
double difference(const Places& theirs, const std::vector<glm::dvec2>& ours, const std::vector<uint32_t>& border)
{
    double best = 1e300;
    for (const bool mirrored : {false, true}) {
        const auto place = [&](uint32_t v) { return std::complex<double>(ours[v].x, mirrored ? -ours[v].y : ours[v].y); };
        std::complex<double> middle = 0, turn = 0;
        for (const uint32_t v : border) middle += theirs[v] / double(border.size());
        // Ours lie round 0: sum of conj(place) * place is known, so the factor is a quotient (least squares; the middle is the circle's).
        std::complex<double> mean = 0;
        for (const uint32_t v : border) mean += place(v) / double(border.size());
        double weight = 0;
        for (const uint32_t v : border) {
            turn += std::conj(place(v) - mean) * (theirs[v] - middle);
            weight += std::norm(place(v) - mean);
        }
        turn /= weight;
        double worst = 0;
        for (uint32_t v = 0; v < ours.size(); ++v) worst = std::max(worst, std::abs(turn * (place(v) - mean) + middle - theirs[v]) / std::abs(turn));
        best = std::min(best, worst);
    }
    return best;
}

void expectSame(const Mesh& mesh)
{
    const std::vector<uint32_t> border = diskOf(mesh).border;
    const auto ours = [&](EdgeWeights w, PlanarOutline o = PlanarOutline::Chord) { return planarEmbedding(mesh, w, o); };
    EXPECT_LT(
        difference(cgalPlaces<Unwrap::Barycentric_mapping_parameterizer_3<Surface, ByLength, Solver>>(mesh), ours(EdgeWeights::Uniform), border),
        1e-4);
    EXPECT_LT(
        difference(cgalPlaces<Unwrap::Mean_value_coordinates_parameterizer_3<Surface, ByLength, Solver>>(mesh), ours(EdgeWeights::MeanValue), border),
        1e-4);
    EXPECT_LT(
        difference(cgalPlaces<Unwrap::Discrete_conformal_map_parameterizer_3<Surface, ByLength, Solver>>(mesh), ours(EdgeWeights::Harmonic), border),
        1e-4);
    EXPECT_LT(difference(cgalPlaces<Unwrap::Barycentric_mapping_parameterizer_3<Surface, InEqualSteps, Solver>>(mesh),
                         ours(EdgeWeights::Uniform, PlanarOutline::Circle), border),
              1e-4);
}

TEST(EmbedPlanar, AgreesWithCgal)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"camelhead.off", "lilium.obj", "cat_head.obj", "hemisphere.off", "circle.obj", "planexy.off"}) {
        SCOPED_TRACE(name);
        expectSame(meshOf(data / "meshes/disk" / name));
    }
}

/// The two weights must differ, or the comparison would show nothing.
TEST(EmbedPlanar, TheWeightsOfCgalDiffer)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh mesh = meshOf(data / "meshes/disk/camelhead.off");
    const Places theirs = cgalPlaces<Unwrap::Mean_value_coordinates_parameterizer_3<Surface, ByLength, Solver>>(mesh);
    EXPECT_GT(difference(theirs, planarEmbedding(mesh, EdgeWeights::Uniform, PlanarOutline::Chord), diskOf(mesh).border), 0.1);
}

}  // namespace
}  // namespace mw::test
