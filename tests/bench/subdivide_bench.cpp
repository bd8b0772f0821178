// subdivide-loop against OpenSubdiv 3.5: topology and first evaluation to a mesh of four million triangles.
#include <benchmark/benchmark.h>
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

/// Refines and evaluates; the last level holds faces only, as one that is drawn or written.
size_t openSubdiv(const Mesh& mesh, int levels)
{
    const std::vector<int> sizes(mesh.faceCount(), 3), vertices(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    osd::Far::TopologyDescriptor d;
    d.numVertices = int(mesh.vertexCount());
    d.numFaces = int(mesh.faceCount());
    d.numVertsPerFace = sizes.data();
    d.vertIndicesPerFace = vertices.data();
    osd::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
    const std::unique_ptr<osd::Far::TopologyRefiner> refiner(Factory::Create(d, Factory::Options(osd::Sdc::SCHEME_LOOP, options)));
    refiner->RefineUniform(osd::Far::TopologyRefiner::UniformOptions(levels));
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

void loopAgainstOpenSubdiv(benchmark::State& state)
{
    const int levels = int(state.range(1));
    const Mesh mesh = scanMesh(2 * uint32_t(state.range(0)), uint32_t(state.range(0)));
    const Operation& op = operation("subdivide-loop");
    const ParameterValues values = parsed(op.parameters, "levels=" + std::to_string(levels));
    double peer = 0, own = 0;
    size_t triangles = 0;
    for (auto _ : state) {
        peer = quickest(3, [&] { benchmark::DoNotOptimize(openSubdiv(mesh, levels)); });
        own = quickest(3, [&] { triangles = std::get<Mesh>(apply(op, mesh, values)).faceCount(); });
    }
    state.counters["triangles"] = double(triangles);
    state.counters["cpu_s"] = own;
    state.counters["opensubdiv_s"] = peer;
    state.counters["of_opensubdiv"] = own / peer;
}

BENCHMARK(loopAgainstOpenSubdiv)->Args({130, 3})->Args({512, 1})->Args({40, 3})->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace mw::bench
