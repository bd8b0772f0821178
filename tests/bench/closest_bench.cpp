// Closest points of a surface against CGAL's tree: making it, and asking for points near the surface and far from it. CPU time, all threads together.
#include <benchmark/benchmark.h>
#include <cmath>

#include "core/mesh/triangle_tree.h"

#include "bench/bench_meshes.h"
#include "bench/simplify_peers.h"

namespace mw::bench {

namespace {

/// Each n-th vertex, moved along its normal by a share of the box diagonal.
std::vector<glm::dvec3> pointsNear(const Mesh& mesh, double share, size_t every)
{
    std::vector<glm::dvec3> out;
    const double by = share * mesh.bounds().diagonal();
    for (size_t v = 0; v < mesh.vertexCount(); v += every) out.push_back(glm::dvec3(mesh.positions()[v]) + by * glm::dvec3(mesh.vertexNormals()[v]));
    return out;
}

void closest(benchmark::State& state, const Mesh& mesh, double share)
{
    if (mesh.faceCount() == 0) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    mesh.triangulation();
    const std::vector<glm::dvec3> points = pointsNear(mesh, share, 7);
    double peerMake = 0, peerAsk = 0, make = 1e9, ask = 1e9, sum = 0;
    const double peerSum = cgalClosest(mesh, points, peerMake, peerAsk);
    for (auto _ : state) {
        make = std::min(make, quickest(1, [&] { benchmark::DoNotOptimize(TriangleTree(mesh).size()); }));
        const TriangleTree tree(mesh);
        ask = std::min(ask, quickest(1, [&] {
                           sum = 0;
                           for (const ClosestPoint& c : closestPoints(tree, points)) sum += std::sqrt(c.distance2);
                       }));
    }
    if (std::abs(sum - peerSum) > 1e-6 * (1 + peerSum)) state.SkipWithError("the two do not agree");
    state.counters["make_s"] = make;
    state.counters["make_ratio"] = make / peerMake;
    state.counters["us_a_point"] = 1e6 * ask / double(points.size());
    state.counters["ask_ratio"] = ask / peerAsk;
}

}  // namespace

BENCHMARK_CAPTURE(closest, scan_near, scanLike(), 1e-4)->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK_CAPTURE(closest, scan_far, scanLike(), 0.02)->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK_CAPTURE(closest, dragon_near, dragon(), 1e-4)->Unit(benchmark::kMillisecond)->Iterations(2);

}  // namespace mw::bench
