// Heights at 4096 x 4096: made, painted, made into a mesh.
#include <benchmark/benchmark.h>

#include "core/catalog/catalog.h"
#include "core/terrain/brush.h"

namespace mw::bench {

namespace {

HeightMap made(const char* source, const char* parameters)
{
    const Operation& op = operation(source);
    return std::get<HeightMap>(apply(op, {}, parsed(op.parameters, parameters)));
}

void make(benchmark::State& state, const char* source, const char* parameters)
{
    size_t samples = 0;
    for (auto _ : state) {
        const HeightMap m = made(source, parameters);
        samples += size_t(m.width()) * m.height();
    }
    state.counters["Msamples/s"] = benchmark::Counter(double(samples) * 1e-6, benchmark::Counter::kIsRate);
}

Terrain large()
{
    Terrain t;
    t.map = made("diamond-square", "size=4097");
    return t;
}

/// One dab of 85 m on 1000 m: 340 000 samples in 49 tiles.
void dab(benchmark::State& state)
{
    Terrain t = large();
    double x = -300;
    for (auto _ : state) {
        double carry = -1;
        const glm::dvec2 place(x, 20);
        t.map = stroked(t, Brush{}, std::span(&place, 1), carry);
        x = x > 300 ? -300 : x + 17;
    }
}

void ray(benchmark::State& state)
{
    const Terrain t = large();
    double z = -400;
    for (auto _ : state) {
        benchmark::DoNotOptimize(t.meet({-600, 200, z}, {1, -0.12, 0.2}));
        z = z > 300 ? -400 : z + 7;
    }
}

void mesh(benchmark::State& state)
{
    const Terrain t = large();
    double error = 0;
    for (auto _ : state) {
        const Mesh m = terrainMesh(t, size_t(state.range(0)));
        state.PauseTiming();
        error = terrainMeshError(t, m);
        state.ResumeTiming();
    }
    state.counters["error m"] = error;
}

BENCHMARK_CAPTURE(make, perlin6, "perlin", "size=4096,octaves=6,normalise=none")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make, perlin6Stretched, "perlin", "size=4096,octaves=6")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make, diamondSquare, "diamond-square", "size=4097")->Unit(benchmark::kMillisecond);
BENCHMARK(dab)->Unit(benchmark::kMillisecond);
BENCHMARK(ray)->Unit(benchmark::kMicrosecond);
BENCHMARK(mesh)->Arg(50'000)->Arg(500'000)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
