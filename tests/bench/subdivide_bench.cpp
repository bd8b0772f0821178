// Loop and Catmull-Clark subdivision against OpenSubdiv 3.5: a first build to a mesh, and positions alone once more.
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include "core/catalog/catalog.h"

#include "bench/bench_meshes.h"

namespace mw::bench {

namespace {

namespace osd = OpenSubdiv;

struct Point {
    float x, y, z;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const Point& p, float w)
    {
        x += w * p.x;
        y += w * p.y;
        z += w * p.z;
    }
};

/// Uniform refinement, creases of the attribute with it; the last level holds faces only, as one that is drawn or written. With `seams` the corners'
/// values are a face-varying channel.
struct Peer {
    std::unique_ptr<osd::Far::TopologyRefiner> refiner;
    std::vector<Point> corners;
    int levels;

    Peer(const Mesh& mesh, bool loop, int n, bool seams) : levels(n)
    {
        std::vector<int> sizes(mesh.faceCount()), vertices(mesh.cornerVertex().begin(), mesh.cornerVertex().end()), creases, channel;
        std::vector<float> sharpness;
        const Attribute *crease = mesh.find("crease"), *texcoord = seams ? mesh.find("texcoord") : nullptr;
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            const uint32_t first = mesh.faceStart()[f], size = mesh.faceStart()[f + 1] - first;
            sizes[f] = int(size);
            for (uint32_t k = 0; crease && k < size; ++k)
                if (crease->at(first + k, 0) >= 1) {
                    creases.insert(creases.end(), {vertices[first + k], vertices[first + (k + 1) % size]});
                    sharpness.push_back(10);
                }
        }
        osd::Far::TopologyDescriptor d;
        d.numVertices = int(mesh.vertexCount());
        d.numFaces = int(mesh.faceCount());
        d.numVertsPerFace = sizes.data();
        d.vertIndicesPerFace = vertices.data();
        d.numCreases = int(sharpness.size());
        d.creaseVertexIndexPairs = creases.data();
        d.creaseWeights = sharpness.data();
        osd::Far::TopologyDescriptor::FVarChannel values;
        if (texcoord) {
            std::map<std::pair<double, double>, int> number;
            for (size_t c = 0; c < mesh.cornerCount(); ++c) {
                const auto [i, fresh] = number.try_emplace({texcoord->at(c, 0), texcoord->at(c, 1)}, int(number.size()));
                if (fresh) corners.push_back({float(texcoord->at(c, 0)), float(texcoord->at(c, 1)), 0});
                channel.push_back(i->second);
            }
            values.numValues = int(corners.size());
            values.valueIndices = channel.data();
            d.numFVarChannels = 1;
            d.fvarChannels = &values;
        }
        osd::Sdc::Options options;
        options.SetVtxBoundaryInterpolation(osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
        options.SetFVarLinearInterpolation(osd::Sdc::Options::FVAR_LINEAR_ALL);
        using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
        refiner.reset(Factory::Create(d, Factory::Options(loop ? osd::Sdc::SCHEME_LOOP : osd::Sdc::SCHEME_CATMARK, options)));
        refiner->RefineUniform(osd::Far::TopologyRefiner::UniformOptions(levels));
    }
    size_t positions(const Mesh& mesh) const
    {
        const osd::Far::PrimvarRefiner primvar(*refiner);
        std::vector<Point> points;
        for (const glm::vec3& p : mesh.positions()) points.push_back({p.x, p.y, p.z});
        for (int n = 1; n <= levels; ++n) {
            std::vector<Point> next(size_t(refiner->GetLevel(n).GetNumVertices()));
            primvar.Interpolate(n, points, next);
            points.swap(next);
        }
        return points.size();
    }
    size_t texcoords() const
    {
        const osd::Far::PrimvarRefiner primvar(*refiner);
        std::vector<Point> values = corners;
        for (int n = 1; n <= levels && !corners.empty(); ++n) {
            std::vector<Point> next(size_t(refiner->GetLevel(n).GetNumFVarValues(0)));
            primvar.InterpolateFaceVarying(n, values, next, 0);
            values.swap(next);
        }
        return values.size();
    }
};

/// The same arrays anew, as a mesh that nobody has subdivided yet.
Mesh unknown(const Mesh& mesh)
{
    Mesh out(mesh.positions(), Array<uint32_t>(mesh.faceStart().begin(), mesh.faceStart().end()),
             Array<uint32_t>(mesh.cornerVertex().begin(), mesh.cornerVertex().end()));
    for (const Attribute& a : mesh.attributes()) out = out.with(a);
    return out;
}

void against(benchmark::State& state, const char* operationId, const Mesh& mesh, int levels)
{
    const Operation& op = operation(operationId);
    const ParameterValues values = parsed(op.parameters, "levels=" + std::to_string(levels));
    const bool loop = op.id == "subdivide-loop", seams = mesh.find("texcoord") != nullptr;
    double peer = 0, own = 0, peerAgain = 0, ownAgain = 0;
    Mesh out;
    for (auto _ : state) {
        peer = quickest(3, [&] {
            const Peer p(mesh, loop, levels, seams);
            benchmark::DoNotOptimize(p.positions(mesh) + p.texcoords());
        });
        out = Mesh();
        own = quickest(5, [&] { out = std::get<Mesh>(apply(op, unknown(mesh), values)); });
        const Peer again(mesh, loop, levels, seams);
        peerAgain = quickest(5, [&] { benchmark::DoNotOptimize(again.positions(mesh)); });
        Mesh moved = mesh;
        out = std::get<Mesh>(apply(op, moved, values));
        ownAgain = quickest(7, [&] {
            moved = moved.withPositions(Array<glm::vec3>(moved.positions().begin(), moved.positions().end()));
            out = std::get<Mesh>(apply(op, moved, values));
        });
    }
    state.counters["faces"] = double(out.faceCount());
    state.counters["cpu_s"] = own;
    state.counters["of_opensubdiv"] = own / peer;
    state.counters["again_s"] = ownAgain;
    state.counters["again_of_opensubdiv"] = ownAgain / peerAgain;
    state.counters["ns_a_face"] = 1e9 * own / double(out.faceCount());
}

void loopOfScan(benchmark::State& state)
{
    against(state, "subdivide-loop", scanMesh(2 * uint32_t(state.range(0)), uint32_t(state.range(0))), int(state.range(1)));
}

/// Files of the test data; skipped without them.
void file(benchmark::State& state, const char* operationId, const char* name, int levels, bool bare)
{
    const char* data = std::getenv("MESHWRIGHT_DATA");
    const std::filesystem::path path = std::filesystem::path(data ? data : "") / "meshes" / name;
    if (!data || !std::filesystem::exists(path)) {
        state.SkipWithError("MESHWRIGHT_DATA is not set");
        return;
    }
    const Scene scene = readFile(path).scene;
    Mesh mesh = scene.find(scene.meshes().at(0))->base;
    if (bare) mesh = Mesh(mesh.positions(), mesh.faceStart(), mesh.cornerVertex());
    against(state, operationId, mesh, levels);
}

/// Edges sharp at random, in a share of thousandths: creases, darts and corners of all kinds.
void catmullWithCreases(benchmark::State& state)
{
    const Mesh bare = scanMesh(2 * uint32_t(state.range(0)), uint32_t(state.range(0)));
    Array<float> crease(bare.cornerCount());
    const uint32_t sharp = uint32_t(65536 * state.range(2) / 2000);  // of each of the two sides
    uint32_t seed = 1;
    for (float& c : crease) c = (seed = seed * 1664525u + 1013904223u) >> 16 < sharp ? 1.f : 0.f;
    against(state, "subdivide-catmull-clark", bare.with(floatAttribute("crease", Domain::Corner, 1, std::move(crease))), int(state.range(1)));
}

BENCHMARK(loopOfScan)->Args({20, 3})->Args({65, 3})->Args({200, 3})->Args({512, 1})->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(file, loop_bunny, "subdivide-loop", "boundary/stanford-bunny.obj", 3, true)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(file, catmull_spot, "subdivide-catmull-clark", "closed_genus0/spot.obj", 4, true)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(file, catmull_spot_seams, "subdivide-catmull-clark", "closed_genus0/spot.obj", 4, false)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(file, catmull_mixed, "subdivide-catmull-clark", "quads/suzanne.obj", 5, true)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(catmullWithCreases)->Args({40, 3, 10})->Args({40, 3, 100})->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
