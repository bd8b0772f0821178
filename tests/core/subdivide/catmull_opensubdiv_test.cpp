// Catmull-Clark against OpenSubdiv's uniform refinement: faces of any size, borders, creases that last and that fade, vertex by vertex.
#include <gtest/gtest.h>
#include <map>
#include <tuple>

#include "core/subdivide/carried.h"
#include "core/subdivide/catmull_level.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/core/subdivide/opensubdiv.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

struct Matched {
    std::vector<uint32_t> vertex, face;
};

/// Our vertex and face for each of theirs, matched through the tables of both, level by level: their child faces begin at other corners.
Matched matched(const OsdMesh& theirs, const Mesh& mesh, int levels, float lasting)
{
    CatmullLevel level = CatmullLevel::of(mesh, creaseOf(mesh), false, lasting);
    std::vector<uint32_t> ours(mesh.vertexCount()), face(mesh.faceCount());
    for (uint32_t v = 0; v < ours.size(); ++v) ours[v] = v;
    for (uint32_t f = 0; f < face.size(); ++f) face[f] = f;
    for (int n = 1; n <= levels; ++n) {
        const auto& coarse = theirs.refiner->GetLevel(n - 1);
        const auto& fine = theirs.refiner->GetLevel(n);
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> edgeOf;
        for (uint32_t e = 0; e < level.edges.size(); ++e) edgeOf[std::minmax(level.edges[e].a, level.edges[e].b)] = e;
        std::vector<uint32_t> next(size_t(fine.GetNumVertices()), none), nextFace(size_t(fine.GetNumFaces()), none);
        for (int v = 0; v < coarse.GetNumVertices(); ++v) next[size_t(coarse.GetVertexChildVertex(v))] = ours[size_t(v)];
        for (int e = 0; e < coarse.GetNumEdges(); ++e) {
            const auto ends = coarse.GetEdgeVertices(e);
            next[size_t(coarse.GetEdgeChildVertex(e))] =
                uint32_t(level.vertices) + edgeOf.at(std::minmax(ours[size_t(ends[0])], ours[size_t(ends[1])]));
        }
        for (int f = 0; f < coarse.GetNumFaces(); ++f) {
            const uint32_t mine = face[size_t(f)];
            next[size_t(coarse.GetFaceChildVertex(f))] = uint32_t(level.vertices + level.edges.size()) + mine;
            const auto children = coarse.GetFaceChildFaces(f);
            const auto corners = coarse.GetFaceVertices(f);
            for (int k = 0; k < children.size(); ++k)
                for (uint32_t c = level.firstCorner(mine); c < level.firstCorner(mine + 1); ++c)
                    if (level.vertex[c] == ours[size_t(corners[k])]) nextFace[size_t(children[k])] = c;
        }
        ours = next;
        face = nextFace;
        level = level.refined(false);
    }
    return {ours, face};
}

/// Largest distance between our vertices and theirs, over the size.
double difference(const Mesh& mesh, int levels, bool fading = false)
{
    const OsdMesh theirs(mesh, osd::Sdc::SCHEME_CATMARK, levels, !fading);
    const std::vector<uint32_t> ours = matched(theirs, mesh, levels, fading ? alwaysSharp : 1.f).vertex;
    const std::vector<OsdPoint> points = theirs.positions(mesh, levels);
    const std::string parameters = "levels=" + std::to_string(levels) + (fading ? ",fading=true" : "");
    const Mesh out = applied("subdivide-catmull-clark", mesh, parameters.c_str());
    if (out.vertexCount() != points.size()) return 1e9;
    double worst = 0;
    for (size_t v = 0; v < points.size(); ++v)
        worst = std::max(worst, glm::length(glm::dvec3(out.positions()[ours[v]]) - glm::dvec3(points[v].x, points[v].y, points[v].z)));
    return worst / mesh.bounds().diagonal();
}

TEST(CatmullOpenSubdiv, Models)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    EXPECT_LT(difference(meshOf(data / "meshes/closed_genus0/spot.obj"), 2), 1e-6);
    EXPECT_LT(difference(meshOf(data / "meshes/quads/horse_quad.obj"), 2), 1e-6);
    EXPECT_LT(difference(meshOf(data / "meshes/quads/suzanne.obj"), 3), 1e-6) << "triangles and quads, with borders";
    EXPECT_LT(difference(meshOf(data / "meshes/closed_genus0/dodecahedron_poly.obj"), 4), 1e-6);
    EXPECT_LT(difference(meshOf(data / "meshes/boundary/stanford-bunny.obj"), 1), 1e-6) << "with borders and vertices of no face";
    EXPECT_LT(difference(meshOf(data / "meshes/disk/cat_head.obj"), 3), 1e-6);
}

Mesh bentGrid(uint32_t n, bool quads)
{
    Polygons p = grid(n, false, quads);
    for (glm::vec3& v : p.positions) v.z = 0.2f * std::sin(7 * v.x + 4 * v.y);
    return p.mesh();
}

TEST(CatmullOpenSubdiv, SmallShapes)
{
    EXPECT_LT(difference(tetrahedron().mesh(), 4), 1e-6);
    EXPECT_LT(difference(cube().mesh(), 4), 1e-6);
    EXPECT_LT(difference(grid(7, true, true).mesh(), 3), 1e-6);
    EXPECT_LT(difference(bentGrid(1, true), 4), 1e-6);
    EXPECT_LT(difference(bentGrid(5, false), 3), 1e-6);
}

/// Sides along the lines x = 1/2 (from border to border) and y = 1/4 (a meeting, and a dart).
Mesh creased(const Mesh& bare, float across, float branch)
{
    Array<float> crease(bare.cornerCount(), 0.f);
    for (size_t f = 0; f < bare.faceCount(); ++f)
        for (uint32_t c = bare.faceStart()[f]; c < bare.faceStart()[f + 1]; ++c) {
            const uint32_t d = c + 1 == bare.faceStart()[f + 1] ? bare.faceStart()[f] : c + 1;
            const glm::vec3 a = bare.positions()[bare.cornerVertex()[c]], b = bare.positions()[bare.cornerVertex()[d]];
            if (a.x == 0.5f && b.x == 0.5f) crease[c] = across;
            if (a.y == 0.25f && b.y == 0.25f && std::max(a.x, b.x) <= 0.5f && std::min(a.x, b.x) >= 0.25f) crease[c] = branch;
        }
    return bare.with(floatAttribute("crease", Domain::Corner, 1, crease));
}

TEST(CatmullOpenSubdiv, CreasesDartsAndCorners)
{
    EXPECT_LT(difference(creased(bentGrid(8, true), 1, 1), 3), 1e-6);
    EXPECT_LT(difference(creased(bentGrid(8, false), 1, 1), 3), 1e-6);
    EXPECT_LT(difference(creased(bentGrid(8, true), 0.4f, 0.7f), 3), 1e-6) << "partly sharp";
}

TEST(CatmullOpenSubdiv, CreasesThatFade)
{
    EXPECT_LT(difference(creased(bentGrid(8, true), 2.5f, 1.5f), 4, true), 1e-6);
    EXPECT_LT(difference(creased(bentGrid(8, true), 1.3f, 2.f), 4, true), 1e-6) << "corners that become creases";
    EXPECT_LT(difference(creased(bentGrid(8, false), 1.f, 3.2f), 3, true), 1e-6);
}

/// Largest difference between the texture coordinates at our corners and theirs.
double textureDifference(const Mesh& mesh, int levels)
{
    const Attribute& texcoord = *mesh.find("texcoord");
    FaceVarying values;
    std::map<std::tuple<uint32_t, double, double>, int> number;
    for (uint32_t c = 0; c < mesh.cornerCount(); ++c) {
        const double u = texcoord.at(c, 0), v = texcoord.at(c, 1);
        const auto [i, fresh] = number.try_emplace({mesh.cornerVertex()[c], u, v}, int(values.values.size()));
        if (fresh) values.values.push_back({u, v, 0});
        values.index.push_back(i->second);
    }
    const OsdMesh theirs(mesh, osd::Sdc::SCHEME_CATMARK, levels, true, &values, osd::Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
    const Matched ours = matched(theirs, mesh, levels, 1);
    const std::vector<OsdPoint> points = theirs.faceVarying(values.values, levels);
    const Mesh out = applied("subdivide-catmull-clark", mesh, ("uv=smooth,levels=" + std::to_string(levels)).c_str());
    const Attribute& refined = *out.find("texcoord");
    const auto& level = theirs.refiner->GetLevel(levels);
    double worst = 0;
    for (int f = 0; f < level.GetNumFaces(); ++f) {
        const auto vertices = level.GetFaceVertices(f);
        const auto corners = level.GetFaceFVarValues(f);
        for (int k = 0; k < 4; ++k)
            for (uint32_t c = 4 * ours.face[size_t(f)]; c < 4 * ours.face[size_t(f)] + 4; ++c)
                if (out.cornerVertex()[c] == ours.vertex[size_t(vertices[k])]) {
                    const OsdPoint& p = points[size_t(corners[k])];
                    worst = std::max({worst, std::abs(refined.at(c, 0) - p.x), std::abs(refined.at(c, 1) - p.y)});
                }
    }
    return worst;
}

/// Charts right and left of x = 1/2; a slit from the border into the left one, which ends inside.
Mesh charted(const Mesh& mesh)
{
    Array<float> texcoord;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        glm::vec3 centre(0);
        for (const uint32_t v : mesh.face(f)) centre += mesh.positions()[v] / float(mesh.face(f).size());
        for (const uint32_t v : mesh.face(f)) {
            const glm::vec3 p = mesh.positions()[v];
            const bool slit = p.y == 0.5f && p.x < 0.25f && centre.y > 0.5f;
            texcoord.insert(texcoord.end(), {p.x + (centre.x > 0.5f ? 2.f : 0.f), p.y + 0.3f * p.z + (slit ? 0.1f : 0.f)});
        }
    }
    return mesh.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord));
}

TEST(CatmullOpenSubdiv, SmoothTextureCoordinatesOfCharts)
{
    EXPECT_LT(textureDifference(charted(bentGrid(8, true)), 3), 2e-6);
    EXPECT_LT(textureDifference(charted(bentGrid(8, false)), 2), 2e-6);
    EXPECT_LT(textureDifference(charted(creased(bentGrid(8, true), 0, 1)), 3), 2e-6) << "with creases";
}

TEST(CatmullOpenSubdiv, SmoothTextureCoordinates)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    EXPECT_LT(textureDifference(meshOf(data / "meshes/closed_genus0/spot.obj"), 2), 2e-6);
    EXPECT_LT(textureDifference(meshOf(data / "meshes/quads/cylinder.obj"), 2), 2e-6);
}

}  // namespace
