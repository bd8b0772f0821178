// decimate-quadric to 10 % of the faces against CGAL's Garland-Heckbert and meshoptimizer: CPU time and RMS distance (% of the box diagonal).
#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include "core/catalog/catalog.h"

#include "bench/bench_meshes.h"
#include "bench/simplify_peers.h"

namespace mw::bench {

namespace {

constexpr double ratio = 0.1;

Mesh own(const Mesh& mesh, const char* parameters)
{
    const Operation& op = operation("decimate-quadric");
    return std::get<Mesh>(apply(op, mesh, parsed(op.parameters, parameters)));
}

Mesh meshopt(const Mesh& mesh)
{
    const size_t target = size_t(ratio * double(mesh.faceCount())) * 3;
    Array<uint32_t> out(mesh.cornerCount());
    const size_t n = meshopt_simplify(out.data(), mesh.cornerVertex().data(), mesh.cornerCount(), &mesh.positions()[0].x, mesh.vertexCount(),
                                      sizeof(glm::vec3), target, 1.f, 0, nullptr);
    out.resize(n);
    return Mesh::triangles(mesh.positions(), std::move(out));
}

void report(benchmark::State& state, const Mesh& mesh, const Mesh& result, double seconds)
{
    state.counters["cpu_s"] = seconds;
    state.counters["faces"] = double(result.faceCount());
    state.counters["rms_percent"] = 100 * rmsDistance(mesh, result);
}

/// The peers' seconds on one of the two meshes, measured once in this process.
struct Peers {
    double cgal = 0, meshopt = 0;
};
Peers& peersOf(bool real)
{
    static Peers peers[2];
    return peers[real];
}

const Mesh& meshFor(benchmark::State& state, bool real)
{
    const Mesh& mesh = real ? dragon() : scanLike();
    if (!mesh.faceCount()) state.SkipWithError("MESHWRIGHT_DATA is not set");
    return mesh;
}

void decimateMeshopt(benchmark::State& state, bool real)
{
    const Mesh& mesh = meshFor(state, real);
    Mesh result;
    for (auto _ : state)
        if (mesh.faceCount()) peersOf(real).meshopt = quickest(2, [&] { result = meshopt(mesh); });
    if (mesh.faceCount()) report(state, mesh, result, peersOf(real).meshopt);
}

void decimateCgal(benchmark::State& state, bool real)
{
    const Mesh& mesh = meshFor(state, real);
    Mesh result;
    for (auto _ : state)
        if (mesh.faceCount()) result = cgalGarlandHeckbert(mesh, ratio, peersOf(real).cgal);
    if (mesh.faceCount()) report(state, mesh, result, peersOf(real).cgal);
}

void decimateOwn(benchmark::State& state, bool real, const char* parameters)
{
    const Mesh& mesh = meshFor(state, real);
    Mesh result;
    double seconds = 0;
    for (auto _ : state)
        if (mesh.faceCount()) seconds = quickest(2, [&] { result = own(mesh, parameters); });
    if (!mesh.faceCount()) return;
    report(state, mesh, result, seconds);
    if (peersOf(real).cgal > 0) state.counters["of_cgal"] = seconds / peersOf(real).cgal;
    if (peersOf(real).meshopt > 0) state.counters["of_meshopt"] = seconds / peersOf(real).meshopt;
}

/// How the time grows: tori of 10 thousand to 1 million triangles.
void decimateGrowth(benchmark::State& state)
{
    const uint32_t sides = uint32_t(state.range(0));
    const Mesh mesh = scanMesh(2 * sides, sides);
    double seconds = 0;
    for (auto _ : state) seconds = quickest(2, [&] { own(mesh, "ratio=0.1"); });
    state.counters["cpu_us_per_face"] = 1e6 * seconds / double(mesh.faceCount());
    state.counters["faces"] = double(mesh.faceCount());
}

BENCHMARK_CAPTURE(decimateMeshopt, scan, false)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateCgal, scan, false)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateOwn, scan, false, "ratio=0.1")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateOwn, scan_memory_sum, false, "ratio=0.1,memory=sum")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateMeshopt, dragon, true)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateCgal, dragon, true)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decimateOwn, dragon, true, "ratio=0.1")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateGrowth)->Arg(50)->Arg(160)->Arg(500)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
