// The mesh payload: half-edges, normals, topology, welding and strips against bare loops over the same arrays and against add_face.
// "ratio" is quickest run to quickest run of the reference named in the benchmark, both in this process.
#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>

#include "core/mesh/connectivity.h"
#include "core/mesh/halfedge.h"
#include "core/mesh/normals.h"
#include "core/mesh/stripify.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangle_adjacency.h"
#include "core/mesh/weighted_normals.h"
#include "core/repair/weld.h"

#include "bench/bench_meshes.h"

namespace mw::bench {

namespace {

/// The side against each side, by a bare counting sort of sides by their lower vertex. Knows nothing of polygons or third faces.
Array<uint32_t> bareOpposites(const Mesh& mesh)
{
    const uint32_t n = uint32_t(mesh.cornerCount()), *v = mesh.cornerVertex().data();
    struct Side {
        uint32_t other, corner;
    };
    Array<uint32_t> start(mesh.vertexCount() + 2, 0u), opposite(n, none);
    Array<Side> sorted(n);
    for (uint32_t c = 0; c < n; c += 3) {
        ++start[std::min(v[c], v[c + 1]) + 2];
        ++start[std::min(v[c + 1], v[c + 2]) + 2];
        ++start[std::min(v[c + 2], v[c]) + 2];
    }
    for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    const auto put = [&](uint32_t c, uint32_t a, uint32_t b) { sorted[start[std::min(a, b) + 1]++] = {std::max(a, b), c}; };
    for (uint32_t c = 0; c < n; c += 3) {
        put(c, v[c], v[c + 1]);
        put(c + 1, v[c + 1], v[c + 2]);
        put(c + 2, v[c + 2], v[c]);
    }
    for (size_t low = 0; low < mesh.vertexCount(); ++low)
        for (uint32_t i = start[low]; i < start[low + 1]; ++i)
            for (uint32_t j = i + 1; j < start[low + 1]; ++j)
                if (sorted[i].other == sorted[j].other) {
                    opposite[sorted[i].corner] = sorted[j].corner;
                    opposite[sorted[j].corner] = sorted[i].corner;
                    break;
                }
    return opposite;
}

/// Area-weighted normals with no thought of size or polygons.
Array<glm::vec3> bareNormals(const Mesh& mesh)
{
    const glm::vec3* p = mesh.positions().data();
    const uint32_t* v = mesh.cornerVertex().data();
    Array<glm::vec3> out(mesh.vertexCount(), glm::vec3(0));
    for (size_t c = 0; c < mesh.cornerCount(); c += 3) {
        const glm::vec3 a = p[v[c + 1]] - p[v[c]], b = p[v[c + 2]] - p[v[c]];
        const glm::vec3 n(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        for (size_t k = 0; k < 3; ++k) out[v[c + k]] += n;
    }
    for (glm::vec3& n : out) {
        const float s = n.x * n.x + n.y * n.y + n.z * n.z;
        n = s > 0 ? n * (1 / std::sqrt(s)) : n;
    }
    return out;
}

void addFaces(const Mesh& mesh)
{
    OpenMesh::PolyConnectivity k;
    k.reserve(mesh.vertexCount(), mesh.cornerCount() / 2 + 64, mesh.faceCount());
    for (size_t v = 0; v < mesh.vertexCount(); ++v) k.add_vertex();
    std::vector<OpenMesh::VertexHandle> face;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        face.clear();
        for (const uint32_t v : mesh.face(f)) face.emplace_back(int(v));
        k.add_face(face);
    }
}

/// Times `f` and gives its ratio to the reference.
template <class F, class Reference>
void compare(benchmark::State& state, const Mesh& mesh, const F& f, const Reference& reference)
{
    if (mesh.faceCount() == 0) {
        state.SkipWithError("needs MESHWRIGHT_DATA");
        return;
    }
    const double bare = quickest(5, [&] { benchmark::DoNotOptimize(reference(mesh)); });
    double best = 1e30;
    for (auto _ : state) best = std::min(best, quickest(1, f));
    state.counters["ratio"] = best / bare;
    state.counters["reference_ms"] = 1e3 * bare;
    state.counters["ns_a_face"] = 1e9 * best / double(mesh.faceCount());
}

const Mesh& chosen(const benchmark::State& state)
{
    return state.range(0) ? dragon() : scanLike();
}

template <class Op, class T, class P>
T ran(Op op, const Mesh& mesh, P parameters)
{
    RunOf<T> run(false, [&](Stage<T>& s) { return op(mesh, parameters, s); });
    while (run.advance()) continue;
    return std::any_cast<T>(run.snapshot().value);
}

void halfedgesToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(HalfedgeView(mesh).boundaryEdges); }, bareOpposites);
}

void halfedgesToAddFace(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    if (mesh.faceCount() == 0) {
        state.SkipWithError("needs MESHWRIGHT_DATA");
        return;
    }
    const double slow = quickest(2, [&] { addFaces(mesh); });
    double best = 1e30;
    for (auto _ : state) best = std::min(best, quickest(1, [&] { benchmark::DoNotOptimize(HalfedgeView(mesh).boundaryEdges); }));
    state.counters["ratio"] = best / slow;
    state.counters["reference_ms"] = 1e3 * slow;
}

void vertexNormalsToBareLoop(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    mesh.bounds();  // kept with the mesh
    mesh.isTriangles();
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(vertexNormalsOf(mesh)); }, bareNormals);
}

void angleNormalsToBareLoop(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(vertexNormalsOf(mesh, NormalWeight::Angle)); }, bareNormals);
}

void adjacencyToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(adjacencyIndices(mesh)); }, bareOpposites);
}

void edgesToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(edgesOf(mesh)); }, bareOpposites);
}

void ringsToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(ringsOf(mesh)); }, bareOpposites);
}

void topologyToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(topologyOf(mesh)); }, bareOpposites);
}

void stripsToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    if (mesh.faceCount() > 0) {
        const Table t = ran<decltype(&stripify), Table>(stripify, mesh, Stripify());
        for (const auto& [name, value] : t.summary)
            if (name == "saved per cent" || name == "strips") state.counters[name == "strips" ? "strips" : "saved_percent"] = value;
    }
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(ran<decltype(&stripify), Table>(stripify, mesh, Stripify())); }, bareOpposites);
}

void weldToCountingSort(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    Weld parameters;
    parameters.distance = state.range(1) ? 1e-4 * mesh.bounds().diagonal() : 0;
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(ran<decltype(&weld), Mesh>(weld, mesh, parameters)); }, bareOpposites);
}

void contentHashOfMesh(benchmark::State& state)
{
    const Mesh& mesh = chosen(state);
    for (auto _ : state) benchmark::DoNotOptimize(contentHash(mesh));
    state.SetBytesProcessed(int64_t(state.iterations() * mesh.bytes()));
}

BENCHMARK(halfedgesToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(halfedgesToAddFace)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(vertexNormalsToBareLoop)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(angleNormalsToBareLoop)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(adjacencyToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(edgesToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(ringsToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(topologyToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(stripsToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(weldToCountingSort)->ArgNames({"dragon", "near"})->ArgsProduct({{0, 1}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(contentHashOfMesh)->ArgName("dragon")->Arg(0)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
