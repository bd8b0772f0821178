// Spherical embeddings by what must hold of them: on the sphere, covered once, nothing folded over; texture coordinates without wraps.
#include "core/parameterize/embed_spherical.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

#include "core/io/io.h"
#include "core/mesh/topology.h"
#include "core/metrics/uv_layout.h"
#include "core/parameterize/sphere_hierarchy.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"
#include "tests/longest_pull.h"

namespace mw::test {
namespace {

/// Sum of the solid angles of all triangles (Van Oosterom and Strackee 1983), signed: 4 pi when the sphere is covered once.
double covered(const Mesh& mesh, const std::vector<glm::dvec3>& p)
{
    const auto& t = mesh.triangulation().vertices;
    double sum = 0;
    for (size_t i = 0; i < t.size(); i += 3) {
        const glm::dvec3 &a = p[t[i]], &b = p[t[i + 1]], &c = p[t[i + 2]];
        sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
    return sum;
}

Mesh source(const char* id, const char* parameters = "")
{
    return std::get<Mesh>(apply(operation(id), {}, parsed(operation(id).parameters, parameters)));
}

void expectEmbedded(const Mesh& mesh, EdgeWeights weights)
{
    const std::vector<glm::dvec3> places = sphericalEmbedding(mesh, weights, 20);
    for (const glm::dvec3& p : places) ASSERT_NEAR(glm::length(p), 1, 1e-12);
    EXPECT_EQ(foldedFaces(mesh, places).size(), 0u);
    EXPECT_NEAR(covered(mesh, places), 4 * std::numbers::pi, 1e-6);
}

TEST(EmbedSpherical, DataMeshesCoverTheSphereOnce)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"cube.off", "tet.obj", "dodecahedron_poly.obj", "bumpy.off", "spot.obj", "cheburashka.off", "bunny_3k.off",
                             "fandisk.off", "max_planck_5k.obj", "armadillo.obj"}) {
        SCOPED_TRACE(name);
        expectEmbedded(meshOf(data / "meshes/closed_genus0" / name), EdgeWeights::Uniform);
    }
    const Mesh bunny = meshOf(data / "meshes/closed_genus0/bunny_3k.off");
    for (const EdgeWeights w : {EdgeWeights::Wachspress, EdgeWeights::Harmonic, EdgeWeights::MeanValue}) expectEmbedded(bunny, w);
}

TEST(EmbedSpherical, SourcesCoverTheSphereOnce)
{
    for (const char* id : {"icosphere", "box", "uv-sphere", "cone", "cylinder"}) {
        SCOPED_TRACE(id);
        expectEmbedded(source(id), EdgeWeights::MeanValue);
    }
}

/// What is on the sphere already goes straight out: coordinates by (3.48).
TEST(EmbedSpherical, ProjectionOfASphereIsTheSphere)
{
    const Mesh ball = source("icosphere", "subdivisions=3,radius=2.5");
    const Mesh out = applied("embed-spherical", ball, "start=projection,iterations=0");
    const UvLayout layout = uvLayoutOf(out, 0);
    EXPECT_TRUE(layout.folded.empty());
    for (size_t c = 0; c < ball.cornerCount(); ++c) {
        const glm::dvec3 p = glm::dvec3(ball.positions()[ball.cornerVertex()[c]]) / 2.5;
        EXPECT_NEAR(layout.corners[c].y, std::asin(p.y) / std::numbers::pi + 0.5, 1e-6);
        if (std::abs(p.y) > 0.9999) continue;
        const double u = layout.corners[c].x * 2 * std::numbers::pi;
        EXPECT_NEAR(std::sin(u) * std::sqrt(1 - p.y * p.y), p.x, 1e-5);
        EXPECT_NEAR(std::cos(u) * std::sqrt(1 - p.y * p.y), p.z, 1e-5);
    }
}

/// No face goes the long way round; corners lie between 0 and 2, and each face begins within 0 to 1.
TEST(EmbedSpherical, NoFaceWraps)
{
    for (const char* with : {"", "start=projection,iterations=0"}) {
        const Mesh out = applied("embed-spherical", source("uv-sphere", "segments=24,rings=12"), with);
        const UvLayout layout = uvLayoutOf(out, 0);
        for (size_t f = 0; f < out.faceCount(); ++f) {
            float low = 9, high = -9;
            for (uint32_t c = out.faceStart()[f]; c < out.faceStart()[f + 1]; ++c) {
                low = std::min(low, layout.corners[c].x);
                high = std::max(high, layout.corners[c].x);
            }
            EXPECT_GE(low, 0);
            EXPECT_LE(low, 1);
            EXPECT_LT(high - low, 0.75) << f;
        }
    }
    // The longitudes of a sphere with poles at vertices: nothing is turned over, and triangles at the poles are as wide as the quads below them.
    const Mesh out = applied("embed-spherical", source("uv-sphere", "segments=24,rings=12"), "start=projection,iterations=0");
    EXPECT_TRUE(uvLayoutOf(out, 0).folded.empty());
    EXPECT_EQ(uvLayoutOf(out, 0).seams, 12u + 2 * 23u) << "one line from pole to pole, and the sides of the triangles there";
}

/// The mean of all vertices is the centre in the end, whatever the start.
TEST(EmbedSpherical, RoundsCentreTheVertices)
{
    const Mesh ball = source("icosphere", "subdivisions=2");
    Array<glm::vec3> long_(ball.positions().begin(), ball.positions().end());
    for (glm::vec3& p : long_) p = p * glm::vec3(1, 3, 0.7f) + glm::vec3(5, p.y * p.y, 0);
    const Mesh mesh = ball.withPositions(long_);
    for (const char* start : {"start=hierarchy", "start=projection"}) {
        const Mesh out = applied("embed-spherical", mesh, (std::string("output=sphere,iterations=2000,tolerance=1e-9,") + start).c_str());
        glm::dvec3 sum(0), centre(0);
        for (size_t v = 0; v < mesh.vertexCount(); ++v) {
            sum += glm::dvec3(out.positions()[v]);
            centre += glm::dvec3(mesh.positions()[v]);
        }
        const double radius = std::sqrt(surfaceArea(mesh) / (4 * std::numbers::pi));
        EXPECT_LT(glm::length(sum - centre) / double(mesh.vertexCount()) / radius, 0.02) << start;
        EXPECT_EQ(out.find("folded"), nullptr) << start;
    }
}

/// A shape with long arms: projected it folds over, from the hierarchy it does not.
TEST(EmbedSpherical, FoldsOfTheProjectionAreCounted)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh spot = meshOf(data / "meshes/closed_genus0/spot.obj");
    const Mesh projected = applied("embed-spherical", spot, "start=projection,iterations=0");
    const Attribute* folded = projected.find("folded", Domain::Face);
    ASSERT_NE(folded, nullptr);
    int count = 0;
    for (const int32_t f : folded->integers()) count += f;
    EXPECT_GT(count, 50);
    EXPECT_EQ(applied("embed-spherical", spot, "").find("folded"), nullptr);
}

TEST(EmbedSpherical, OtherThanSpheresAreRefusedWithARemedy)
{
    const auto expectRefused = [](const Mesh& mesh, const std::string& word) {
        try {
            sphericalEmbedding(mesh);
            ADD_FAILURE() << word;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    expectRefused(source("torus"), "genus 1");
    expectRefused(source("grid"), "Fill holes");
    expectRefused(Mesh(), "no faces");
    Polygons two = tetrahedron();
    for (const glm::vec3 p : {glm::vec3(5, 0, 0), glm::vec3(6, 0, 0), glm::vec3(5, 1, 0), glm::vec3(5, 0, 1)}) two.positions.push_back(p);
    expectRefused(two.face({4, 6, 5}).face({4, 5, 7}).face({4, 7, 6}).face({5, 6, 7}).mesh(), "2 pieces");
}

/// Taking out and putting back ends where it began.
TEST(EmbedSpherical, CancelIsHeardAllAlong)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Imported in = readFile(data / "meshes/closed_genus0/armadillo.obj");
    Stage<Mesh> stage(false);
    const test::Pulls pulls = test::pulled(embedSpherical(in.scene.find(in.scene.meshes().front())->base, {}, stage));
    EXPECT_GT(pulls.count, 200u);
    EXPECT_LT(pulls.share(), 0.25) << pulls.longest << " of " << pulls.all << " s";
}

TEST(SphereHierarchy, EveryVertexComesBack)
{
    const Mesh mesh = source("icosphere", "subdivisions=2");
    SphereHierarchy h(mesh);
    size_t removed = 0, inserted = 0;
    while (h.removeNext()) ++removed;
    EXPECT_EQ(removed, mesh.vertexCount() - 4);
    EXPECT_EQ(h.left(), 4u);
    while (h.insertNext()) {
        ++inserted;
        EXPECT_GT(h.room(), 0);
    }
    EXPECT_EQ(inserted, removed);
    const auto rings = orderedRings(mesh);
    for (const auto& ring : rings) EXPECT_TRUE(ring.size() == 5 || ring.size() == 6);
    EXPECT_EQ(foldedFaces(mesh, h.places()).size(), 0u);
}

}  // namespace
}  // namespace mw::test
