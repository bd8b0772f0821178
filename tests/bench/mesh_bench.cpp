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
#include "core/metrics/edge_dihedral.h"
#include "core/metrics/valence.h"
#include "core/metrics/vertex_planarity.h"
#include "core/metrics/vertex_quadric.h"
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

/// How far each vertex is off the mean plane of its faces, as a share of its longest side; with no thought of borders or polygons.
Array<double> barePlanarity(const Mesh& mesh)
{
    struct Sum {
        glm::dvec3 normal{0}, point{0};
        double area = 0, longest = 0;
    };
    const glm::vec3* p = mesh.positions().data();
    const uint32_t* v = mesh.cornerVertex().data();
    Array<Sum> sums(mesh.vertexCount(), Sum());
    for (size_t c = 0; c < mesh.cornerCount(); c += 3) {
        const glm::dvec3 corner[3] = {p[v[c]], p[v[c + 1]], p[v[c + 2]]};
        const glm::dvec3 twice = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double area = glm::length(twice) / 2;
        const glm::dvec3 centroid = (corner[0] + corner[1] + corner[2]) / 3.0;
        for (size_t k = 0; k < 3; ++k) {
            Sum& s = sums[v[c + k]];
            const glm::dvec3 a = corner[(k + 1) % 3] - corner[k], b = corner[(k + 2) % 3] - corner[k];
            s.normal += twice;
            s.point += area * centroid;
            s.area += area;
            s.longest = std::max({s.longest, glm::dot(a, a), glm::dot(b, b)});
        }
    }
    Array<double> out(mesh.vertexCount());
    for (size_t i = 0; i < out.size(); ++i) {
        const Sum& s = sums[i];
        out[i] = std::abs(glm::dot(s.normal, glm::dvec3(p[i]) - s.point / s.area)) / (glm::length(s.normal) * std::sqrt(s.longest));
    }
    return out;
}

/// Sums of squared distances to the planes of the faces, at the mean of the neighbours (each counted by its faces).
Array<double> bareQuadrics(const Mesh& mesh)
{
    struct Sum {
        double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, bx = 0, by = 0, bz = 0, c = 0, faces = 0;
        glm::dvec3 ring{0};
    };
    const glm::vec3* p = mesh.positions().data();
    const uint32_t* v = mesh.cornerVertex().data();
    Array<Sum> sums(mesh.vertexCount(), Sum());
    for (size_t f = 0; f < mesh.cornerCount(); f += 3) {
        const glm::dvec3 corner[3] = {p[v[f]], p[v[f + 1]], p[v[f + 2]]};
        const glm::dvec3 n = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
        const double d = -glm::dot(n, corner[0]);
        for (size_t k = 0; k < 3; ++k) {
            Sum& s = sums[v[f + k]];
            s.xx += n.x * n.x, s.xy += n.x * n.y, s.xz += n.x * n.z, s.yy += n.y * n.y, s.yz += n.y * n.z, s.zz += n.z * n.z;
            s.bx += d * n.x, s.by += d * n.y, s.bz += d * n.z, s.c += d * d;
            s.ring += corner[(k + 1) % 3] + corner[(k + 2) % 3];
            s.faces += 1;
        }
    }
    Array<double> out(mesh.vertexCount());
    for (size_t i = 0; i < out.size(); ++i) {
        const Sum& s = sums[i];
        const glm::dvec3 q = s.ring / (2 * s.faces);
        out[i] = s.xx * q.x * q.x + s.yy * q.y * q.y + s.zz * q.z * q.z + s.c +
                 2 * (s.xy * q.x * q.y + s.xz * q.x * q.z + s.yz * q.y * q.z + s.bx * q.x + s.by * q.y + s.bz * q.z);
    }
    return out;
}

/// The angle between the faces of each side and its length, the other side by a counting sort.
Array<double> bareDihedrals(const Mesh& mesh)
{
    const Array<uint32_t> opposite = bareOpposites(mesh);
    const glm::vec3* p = mesh.positions().data();
    const uint32_t* v = mesh.cornerVertex().data();
    Array<glm::dvec3> normals(mesh.faceCount());
    for (size_t f = 0; f < normals.size(); ++f)
        normals[f] =
            glm::normalize(glm::cross(glm::dvec3(p[v[3 * f + 1]]) - glm::dvec3(p[v[3 * f]]), glm::dvec3(p[v[3 * f + 2]]) - glm::dvec3(p[v[3 * f]])));
    Array<double> out(2 * mesh.cornerCount());
    for (size_t c = 0; c < opposite.size(); ++c) {
        if (opposite[c] == none || opposite[c] < c) continue;
        out[2 * c] = std::acos(std::clamp(glm::dot(normals[c / 3], normals[opposite[c] / 3]), -1.0, 1.0));
        out[2 * c + 1] = glm::distance(glm::dvec3(p[v[c]]), glm::dvec3(p[v[c % 3 == 2 ? c - 2 : c + 1]]));
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

/// Queries; what the mesh keeps for all of them (rings, edges) is there.
template <class Op, class P, class Reference>
void queryToBareLoop(benchmark::State& state, Op op, P parameters, const Reference& reference)
{
    const Mesh& mesh = chosen(state);
    if (mesh.faceCount() > 0) {
        mesh.rings();
        mesh.edges();
    }
    compare(
        state, mesh, [&] { benchmark::DoNotOptimize(ran<Op, Table>(op, mesh, parameters)); }, reference);
}

void planarityToBareLoop(benchmark::State& state)
{
    queryToBareLoop(state, &vertexPlanarity, VertexPlanarity(), barePlanarity);
}

void vertexQuadricToBareLoop(benchmark::State& state)
{
    queryToBareLoop(state, &vertexQuadric, VertexQuadric(), bareQuadrics);
}

void dihedralToBareLoop(benchmark::State& state)
{
    queryToBareLoop(state, &edgeDihedral, EdgeDihedral(), bareDihedrals);
}

void valenceToCountingSort(benchmark::State& state)
{
    queryToBareLoop(state, &vertexValence, VertexValence(), bareOpposites);
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
BENCHMARK(planarityToBareLoop)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(vertexQuadricToBareLoop)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(dihedralToBareLoop)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(valenceToCountingSort)->ArgName("dragon")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(contentHashOfMesh)->ArgName("dragon")->Arg(0)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
