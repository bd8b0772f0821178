// Loop subdivision against OpenSubdiv's uniform refinement: borders, creases, darts and corners, vertex by vertex.
#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include "core/subdivide/loop_level.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;
namespace osd = OpenSubdiv;

namespace {

struct Point {
    double x = 0, y = 0, z = 0;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const Point& p, float w)
    {
        x += double(w) * p.x;
        y += double(w) * p.y;
        z += double(w) * p.z;
    }
};

std::unique_ptr<osd::Far::TopologyRefiner> refinerOf(const Mesh& mesh)
{
    std::vector<int> sizes(mesh.faceCount(), 3), vertices(mesh.cornerVertex().begin(), mesh.cornerVertex().end()), creases;
    std::vector<float> weights;
    if (const Attribute* c = mesh.find("crease", Domain::Corner))
        for (size_t i = 0; i < mesh.cornerCount(); ++i)
            if (c->at(i, 0) >= 0.5) {
                creases.insert(creases.end(), {vertices[i], vertices[i % 3 == 2 ? i - 2 : i + 1]});
                weights.push_back(10);
            }
    osd::Far::TopologyDescriptor d;
    d.numVertices = int(mesh.vertexCount());
    d.numFaces = int(mesh.faceCount());
    d.numVertsPerFace = sizes.data();
    d.vertIndicesPerFace = vertices.data();
    d.numCreases = int(weights.size());
    d.creaseVertexIndexPairs = creases.data();
    d.creaseWeights = weights.data();
    osd::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
    return std::unique_ptr<osd::Far::TopologyRefiner>(Factory::Create(d, Factory::Options(osd::Sdc::SCHEME_LOOP, options)));
}

/// Largest distance between our vertices and theirs, over the size. Vertices are matched through the tables of both, level by level.
double difference(const Mesh& mesh, int levels)
{
    auto refiner = refinerOf(mesh);
    refiner->RefineUniform(osd::Far::TopologyRefiner::UniformOptions(levels));
    const osd::Far::PrimvarRefiner primvar(*refiner);
    const Attribute* crease = mesh.find("crease", Domain::Corner);
    LoopLevel level = LoopLevel::of(mesh, crease ? crease->floats() : std::span<const float>(), SubdivideLoop::Corners::Smooth);
    std::vector<Point> theirs;
    for (const glm::vec3& p : mesh.positions()) theirs.push_back({p.x, p.y, p.z});
    std::vector<uint32_t> ours(theirs.size());
    for (uint32_t v = 0; v < ours.size(); ++v) ours[v] = v;

    for (int n = 1; n <= levels; ++n) {
        const auto& coarse = refiner->GetLevel(n - 1);
        std::vector<Point> points(size_t(refiner->GetLevel(n).GetNumVertices()));
        primvar.Interpolate(n, theirs, points);
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> edgeOf;
        for (uint32_t e = 0; e < level.edges.size(); ++e) edgeOf[std::minmax(level.edges[e].a, level.edges[e].b)] = e;
        std::vector<uint32_t> matched(points.size(), none);
        for (int v = 0; v < coarse.GetNumVertices(); ++v) matched[size_t(coarse.GetVertexChildVertex(v))] = ours[size_t(v)];
        for (int e = 0; e < coarse.GetNumEdges(); ++e) {
            const auto ends = coarse.GetEdgeVertices(e);
            const auto found = edgeOf.find(std::minmax(ours[size_t(ends[0])], ours[size_t(ends[1])]));
            if (found == edgeOf.end()) return 1e9;
            matched[size_t(coarse.GetEdgeChildVertex(e))] = uint32_t(level.vertices) + found->second;
        }
        ours = matched;
        theirs = points;
        level = level.refined(false);
    }
    const Mesh out = applied("subdivide-loop", mesh, ("levels=" + std::to_string(levels)).c_str());
    if (out.vertexCount() != theirs.size()) return 1e9;
    double worst = 0;
    for (size_t v = 0; v < theirs.size(); ++v) {
        const glm::dvec3 p = out.positions()[ours[v]];
        worst = std::max(worst, glm::length(p - glm::dvec3(theirs[v].x, theirs[v].y, theirs[v].z)));
    }
    return worst / mesh.bounds().diagonal();
}

TEST(LoopOpenSubdiv, Scans)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    EXPECT_LT(difference(meshOf(data / "meshes/closed_genus0/spot.obj"), 3), 1e-6);
    EXPECT_LT(difference(meshOf(data / "meshes/boundary/stanford-bunny.obj"), 1), 1e-6) << "with borders and vertices of no face";
    EXPECT_LT(difference(meshOf(data / "meshes/disk/cat_head.obj"), 3), 1e-6);
    EXPECT_LT(difference(meshOf(data / "meshes/closed_higher_genus/3holes.off"), 2), 1e-6);
}

Mesh bentGrid(uint32_t n)
{
    Polygons p = grid(n, false, false);
    for (glm::vec3& v : p.positions) v.z = 0.2f * std::sin(7 * v.x + 4 * v.y);
    return p.mesh();
}

TEST(LoopOpenSubdiv, SmallShapes)
{
    EXPECT_LT(difference(tetrahedron().mesh(), 4), 1e-6);
    EXPECT_LT(difference(grid(7, true, false).mesh(), 3), 1e-6);
    EXPECT_LT(difference(bentGrid(1), 4), 1e-6);
    EXPECT_LT(difference(bentGrid(6), 4), 1e-6);
}

TEST(LoopOpenSubdiv, CreasesDartsAndCorners)
{
    const Mesh bare = bentGrid(8);
    Array<float> crease(bare.cornerCount(), 0.f);
    for (size_t c = 0; c < bare.cornerCount(); ++c) {
        const glm::vec3 a = bare.positions()[bare.cornerVertex()[c]], b = bare.positions()[bare.cornerVertex()[c % 3 == 2 ? c - 2 : c + 1]];
        const bool across = a.x == 0.5f && b.x == 0.5f;                                                                 // from border to border
        const bool branch = a.y == 0.25f && b.y == 0.25f && std::max(a.x, b.x) <= 0.5f && std::min(a.x, b.x) >= 0.25f;  // a meeting, and a dart
        if (across || branch) crease[c] = 1;
    }
    EXPECT_LT(difference(bare.with(floatAttribute("crease", Domain::Corner, 1, crease)), 4), 1e-6);
}

}  // namespace
