// decimate-quadric against meshoptimizer and CGAL: CPU time of everything from arrays to arrays, and RMS distance (% of the box diagonal), on five
// meshes, to 10 % and to 1 % of the faces; two threads; attributes; growth.
#include <benchmark/benchmark.h>
#include <map>
#include <meshoptimizer.h>
#include <tbb/global_control.h>

#include "core/catalog/catalog.h"
#include "tests/core/algorithm_meshes.h"

#include "bench/bench_meshes.h"
#include "bench/simplify_peers.h"

namespace mw::bench {

namespace {

const char* const meshNames[] = {"scan", "dragon", "armadillo", "bunny", "fandisk"};
const char* const qualities[] = {"fast", "balanced", "best", "textbook"};

/// Of those names, bare; an empty mesh without the data.
const Mesh& meshNamed(int which)
{
    static std::map<int, Mesh> read;
    if (const auto known = read.find(which); known != read.end()) return known->second;
    static const std::map<int, const char*> files{
        {2, "closed_genus0/armadillo.obj"}, {3, "boundary/stanford-bunny.obj"}, {4, "closed_genus0/fandisk.off"}};
    const char* data = std::getenv("MESHWRIGHT_DATA");
    Mesh mesh = which == 0 ? scanLike() : which == 1 ? dragon() : Mesh();
    if (which > 1 && data) mesh = test::meshOf(std::filesystem::path(data) / "meshes" / files.at(which));
    return read[which] = mesh.faceCount() ? Mesh::triangles(mesh.positions(), mesh.cornerVertex()) : Mesh();
}

double wallSeconds()
{
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

Mesh own(const Mesh& mesh, const std::string& parameters)
{
    const Operation& op = operation("decimate-quadric");
    return std::get<Mesh>(apply(op, mesh, parsed(op.parameters, parameters)));
}

Mesh meshopt(const Mesh& mesh, double ratio)
{
    const size_t target = size_t(ratio * double(mesh.faceCount())) * 3;
    Array<uint32_t> out(mesh.cornerCount());
    const size_t n = meshopt_simplify(out.data(), mesh.cornerVertex().data(), mesh.cornerCount(), &mesh.positions()[0].x, mesh.vertexCount(),
                                      sizeof(glm::vec3), target, 1.f, 0, nullptr);
    out.resize(n);
    return Mesh::triangles(mesh.positions(), std::move(out));
}

std::string parametersOf(int64_t quality, int64_t percent)
{
    return std::string("quality=") + qualities[quality] + ",ratio=" + (percent == 10 ? "0.1" : "0.01");
}

/// The middle one of some ratios of one to the other, taken in turn: the machine drifts.
template <class F, class G>
double medianRatio(int runs, const F& one, const G& other, double& seconds)
{
    std::vector<double> ratios;
    seconds = 1e30;
    for (int i = 0; i < runs; ++i) {
        const double theirs = quickest(1, other), ours = quickest(1, one);
        ratios.push_back(ours / theirs);
        seconds = std::min(seconds, ours);
    }
    std::nth_element(ratios.begin(), ratios.begin() + runs / 2, ratios.end());
    return ratios[size_t(runs / 2)];
}

/// range: mesh, percent, quality.
void decimateOwn(benchmark::State& state)
{
    const Mesh& mesh = meshNamed(int(state.range(0)));
    if (!mesh.faceCount()) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const std::string parameters = parametersOf(state.range(2), state.range(1));
    state.SetLabel(std::string(meshNames[state.range(0)]) + " " + parameters);
    Mesh result;
    double seconds = 0, share = 0;
    for (auto _ : state)
        share = medianRatio(
            5, [&] { result = own(mesh, parameters); }, [&] { benchmark::DoNotOptimize(meshopt(mesh, double(state.range(1)) / 100)); }, seconds);
    state.counters["cpu_s"] = seconds;
    state.counters["of_meshopt"] = share;
    state.counters["faces"] = double(result.faceCount());
    state.counters["rms_percent"] = 100 * rmsDistance(mesh, result);
}

/// range: mesh, percent, 0 meshoptimizer or 1 CGAL's Lindstrom-Turk.
void decimatePeer(benchmark::State& state)
{
    const Mesh& mesh = meshNamed(int(state.range(0)));
    if (!mesh.faceCount()) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    const double ratio = double(state.range(1)) / 100;
    state.SetLabel(std::string(meshNames[state.range(0)]) + (state.range(2) ? " Lindstrom-Turk" : " meshoptimizer"));
    Mesh result;
    double seconds = 0;
    for (auto _ : state) {
        if (state.range(2))
            result = cgalLindstromTurk(mesh, ratio, seconds);
        else
            seconds = quickest(2, [&] { result = meshopt(mesh, ratio); });
    }
    state.counters["cpu_s"] = seconds;
    state.counters["faces"] = double(result.faceCount());
    state.counters["rms_percent"] = 100 * rmsDistance(mesh, result);
}

/// Time on the wall with two threads, as a share of one thread's. range: quality.
void decimateTwoThreads(benchmark::State& state)
{
    const Mesh& mesh = scanLike();
    const std::string parameters = parametersOf(state.range(0), 10);
    std::vector<double> shares;
    for (auto _ : state)
        for (int i = 0; i < 7; ++i) {
            double seconds[2];
            for (const size_t threads : {1, 2}) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
                const double start = wallSeconds();
                benchmark::DoNotOptimize(own(mesh, parameters));
                seconds[threads - 1] = wallSeconds() - start;
            }
            shares.push_back(seconds[1] / seconds[0]);
        }
    std::nth_element(shares.begin(), shares.begin() + 3, shares.end());
    state.SetLabel(parameters);
    state.counters["of_one_thread"] = shares[3];
}

/// Texture coordinates with two seams, normals, colours and weights.
Mesh dressed(const Mesh& bare)
{
    Array<float> texcoord, normal, color, weights;
    Array<int32_t> joints;
    const uint32_t sides = 512, rings = uint32_t(bare.vertexCount()) / sides;
    for (size_t f = 0; f < bare.faceCount(); ++f)
        for (const uint32_t v : bare.face(f)) {
            const uint32_t i = v / sides, j = v % sides, cell = uint32_t(f / 2);
            texcoord.push_back(float(i == 0 && cell / sides == rings - 1 ? rings : i) / float(rings));
            texcoord.push_back(float(j == 0 && cell % sides == sides - 1 ? sides : j) / float(sides));
            const glm::vec3& n = bare.vertexNormals()[v];
            normal.insert(normal.end(), {n.x, n.y, n.z});
        }
    for (const glm::vec3& p : bare.positions()) {
        color.insert(color.end(), {p.x, p.y, p.z});
        joints.insert(joints.end(), {0, 1, 2, 3});
        weights.insert(weights.end(), {0.4f, 0.3f, 0.2f, 0.1f});
    }
    return bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
        .with(floatAttribute("normal", Domain::Corner, 3, normal))
        .with(floatAttribute("color", Domain::Vertex, 3, color))
        .with(integerAttribute("joints", Domain::Vertex, 4, joints))
        .with(floatAttribute("weights", Domain::Vertex, 4, weights));
}

void decimateAttributes(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Mesh& bare = scanLike();
    const Mesh mesh = dressed(bare);
    const std::string parameters = parametersOf(state.range(0), 10);
    double seconds = 0;
    for (auto _ : state)
        state.counters["of_bare"] = medianRatio(
            5, [&] { benchmark::DoNotOptimize(own(mesh, parameters)); }, [&] { benchmark::DoNotOptimize(own(bare, parameters)); }, seconds);
    state.SetLabel(parameters);
    state.counters["cpu_s"] = seconds;
}

/// How the time grows: tori of 10 thousand to 1 million triangles.
void decimateGrowth(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const uint32_t sides = uint32_t(state.range(0));
    const Mesh mesh = scanMesh(2 * sides, sides);
    const std::string parameters = parametersOf(state.range(1), 10);
    double seconds = 0;
    for (auto _ : state) seconds = quickest(3, [&] { own(mesh, parameters); });
    state.SetLabel(parameters);
    state.counters["cpu_us_per_face"] = 1e6 * seconds / double(mesh.faceCount());
    state.counters["faces"] = double(mesh.faceCount());
}

BENCHMARK(decimatePeer)->ArgsProduct({{0, 1, 2, 3, 4}, {10, 1}, {0, 1}})->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateOwn)->ArgsProduct({{0, 1, 2, 3, 4}, {10, 1}, {0, 1, 2}})->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateOwn)->Args({0, 10, 3})->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateTwoThreads)->DenseRange(0, 2)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateAttributes)->DenseRange(0, 2)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(decimateGrowth)->ArgsProduct({{50, 160, 500}, {0, 1, 3}})->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
