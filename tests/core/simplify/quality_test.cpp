// The quick qualities of decimate-quadric: what must stay on every closed mesh there is, attributes on large meshes that are cut into regions, the
// same bytes with one thread and with two, and bad input. Distances are compared with CGAL's in cgal/.
#include <gtest/gtest.h>
#include <numbers>
#include <tbb/global_control.h>

#include "core/mesh/topology.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

using namespace mw;
using namespace mw::test;

namespace {

const char* const qualities[] = {"fast", "balanced", "best"};

Mesh simplified(const Mesh& mesh, const std::string& quality, const std::string& more)
{
    return applied("decimate-quadric", mesh, ("quality=" + quality + "," + more).c_str());
}

TEST(DecimateQuality, ClosedMeshesKeepGenusAndGetNoFolds)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    size_t meshes = 0;
    for (const char* folder : {"closed_genus0", "closed_higher_genus"})
        for (const auto& file : std::filesystem::directory_iterator(data / "meshes" / folder)) {
            if (file.path().extension() != ".off" && file.path().extension() != ".obj") continue;
            const Mesh read = meshOf(file.path());
            if (!read.isTriangles()) continue;
            const Mesh mesh = Mesh::triangles(read.positions(), read.cornerVertex());  // without the seams of its texture
            const TopologyReport& before = mesh.topology();
            if (!before.manifold()) continue;
            ++meshes;
            for (const char* quality : qualities)
                for (const double ratio : {0.1, 0.01}) {
                    if (mesh.faceCount() > 50'000 && (ratio == 0.1) != (quality == std::string("fast"))) continue;  // enough of it
                    const Mesh out = simplified(mesh, quality, "ratio=" + std::to_string(ratio));
                    const std::string name = file.path().filename().string() + " " + quality + " " + std::to_string(ratio);
                    const TopologyReport& after = out.topology();
                    EXPECT_TRUE(after.manifold()) << name;
                    EXPECT_EQ(after.euler, before.euler) << name;
                    EXPECT_EQ(after.components, before.components) << name;
                    EXPECT_EQ(after.inconsistentEdges.size(), 0u) << name;
                    EXPECT_EQ(after.degenerateFaces.size(), 0u) << name;
                    EXPECT_LE(folds(out), folds(mesh)) << name;
                    const size_t wanted = size_t(std::llround(ratio * double(mesh.faceCount())));
                    EXPECT_LE(out.faceCount(), std::max<size_t>(wanted, 120 + 30 * size_t(before.genus.value_or(0)))) << name;
                    EXPECT_GE(out.faceCount() + 1, wanted) << name;
                }
        }
    EXPECT_GE(meshes, 10u);
}

/// A bumpy torus with a texture whose seams run once round each way, colours, normals, weights and a material.
Mesh dressedTorus(uint32_t n)
{
    Polygons p = grid(n, true, false);
    for (uint32_t v = 0; v < p.positions.size(); ++v) {
        const double u = 2 * std::numbers::pi * (v % n) / n, w = 2 * std::numbers::pi * (v / n) / n;
        p.positions[v] *= float(1 + 0.02 * std::sin(5 * u) * std::sin(3 * w));
    }
    const Mesh bare = p.mesh();
    Array<float> texcoord, normal, color, weights;
    Array<int32_t> joints, material;
    const auto& corners = bare.cornerVertex();
    for (size_t f = 0; f < bare.faceCount(); ++f) {
        const uint32_t cell = uint32_t(f / 2), x = cell % n, y = cell / n;
        material.push_back(y < n / 2 ? 0 : 1);
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = corners[3 * f + k], vx = v % n, vy = v / n;
            texcoord.push_back(float(vx == 0 && x == n - 1 ? n : vx) / float(n));
            texcoord.push_back(float(vy == 0 && y == n - 1 ? n : vy) / float(n));
            const glm::vec3& m = bare.vertexNormals()[v];
            normal.insert(normal.end(), {m.x, m.y, m.z});
        }
    }
    for (const glm::vec3& q : bare.positions()) {
        color.insert(color.end(), {q.x / 10 + 0.5f, q.y / 10 + 0.5f, q.z / 10 + 0.5f});
        joints.insert(joints.end(), {2, 5, 0, 0});
        weights.insert(weights.end(), {q.x / 10 + 0.5f, 0.5f - q.x / 10, 0, 0});
    }
    return bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
        .with(floatAttribute("normal", Domain::Corner, 3, normal))
        .with(floatAttribute("color", Domain::Vertex, 3, color))
        .with(integerAttribute("joints", Domain::Vertex, 4, joints))
        .with(floatAttribute("weights", Domain::Vertex, 4, weights))
        .with(integerAttribute("material", Domain::Face, 1, material));
}

/// Where the texture of dressedTorus has a place.
glm::dvec3 placeOf(double u, double v)
{
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v, bump = 1 + 0.02 * std::sin(5 * a) * std::sin(3 * b);
    return bump * glm::dvec3((3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b));
}

void expectDressed(const Mesh& out, double tolerance)
{
    const Attribute &t = *out.find("texcoord"), &normal = *out.find("normal"), &color = *out.find("color"), &joints = *out.find("joints"),
                    &weights = *out.find("weights"), &material = *out.find("material");
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(out.topology().genus.value_or(-1), 1);
    double seam = 0;
    size_t off = 0;
    for (size_t f = 0; f < out.faceCount(); ++f) {
        const auto at = [&](size_t k, int c) { return t.at(3 * f + k, c); };
        glm::dvec3 middle(0), place(0);
        double u = 0, v = 0;
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p(out.positions()[out.face(f)[k]]);
            EXPECT_LT(glm::length(placeOf(at(k, 0), at(k, 1)) - p), tolerance) << "corner " << 3 * f + k;
            EXPECT_TRUE(material.at(f, 0) == 0 ? at(k, 1) < 0.5 + 2e-3 : at(k, 1) > 0.5 - 2e-3) << "a face reaches over the edge of a material";
            const size_t j = (k + 1) % 3;
            if (at(k, 0) < 4e-3 && at(j, 0) < 4e-3) seam += std::abs(at(k, 1) - at(j, 1));
            middle += p / 3.0, u += at(k, 0) / 3, v += at(k, 1) / 3;
            glm::dvec3 n(normal.at(3 * f + k, 0), normal.at(3 * f + k, 1), normal.at(3 * f + k, 2));
            EXPECT_NEAR(glm::length(n), 1, 1e-4);
        }
        place = placeOf(u, v);
        off += glm::length(place - middle) > 5 * tolerance;
    }
    EXPECT_EQ(off, 0u) << "faces whose texture does not belong to their place";
    EXPECT_NEAR(seam, 1, 0.06) << "the seam still runs once round";
    for (size_t i = 0; i < out.vertexCount(); ++i) {
        const glm::dvec3 p(out.positions()[i]);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(color.at(i, c), p[c] / 10 + 0.5, tolerance);
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            sum += weights.at(i, k);
            if (joints.at(i, k) == 2) {
                EXPECT_NEAR(weights.at(i, k), p.x / 10 + 0.5, tolerance);
            }
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

TEST(DecimateQuality, CarriesTextureSeamsColoursAndWeights)
{
    const Mesh mesh = dressedTorus(120);
    for (const char* quality : {"textbook", "fast", "balanced", "best"}) {
        SCOPED_TRACE(quality);
        const Mesh out = simplified(mesh, quality, "ratio=0.1");
        EXPECT_EQ(out.faceCount(), mesh.faceCount() / 10);
        expectDressed(out, 0.03);
    }
}

TEST(DecimateQuality, RegionsAndThreadsGiveTheSameBytes)
{
    const Mesh mesh = dressedTorus(380);  // 288,800 triangles: two regions
    for (const char* quality : qualities) {
        uint64_t hash[2];
        for (const size_t threads : {1, 2}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const Mesh out = simplified(mesh, quality, "ratio=0.05");
            hash[threads - 1] = contentHash(out);
            if (threads == 2 && quality == std::string("balanced")) expectDressed(out, 0.03);
        }
        EXPECT_EQ(hash[0], hash[1]) << quality;
    }
}

TEST(DecimateQuality, StopsAtAnyCount)
{
    const Mesh mesh = dressedTorus(60);
    for (const char* quality : qualities) {
        EXPECT_EQ(simplified(mesh, quality, "ratio=1").faceCount(), mesh.faceCount());
        EXPECT_EQ(simplified(mesh, quality, "stop=faces,faces=1000000").faceCount(), mesh.faceCount());
        EXPECT_EQ(simplified(mesh, quality, "stop=faces,faces=501").faceCount(), 500u);
        EXPECT_TRUE(simplified(mesh, quality, "ratio=0").topology().manifold()) << "as far as it goes";
        const Mesh ends = simplified(mesh, quality, "ratio=0.2,optimal=false");
        for (const glm::vec3& p : ends.positions()) {
            float nearest = 1e30f;
            for (const glm::vec3& q : mesh.positions()) nearest = std::min(nearest, glm::length(p - q));
            ASSERT_LT(nearest, 2e-6f) << "an end is kept";
        }
    }
}

// Fins, doubled and turned faces, faces without area, vertices twice in a face, loose points.
TEST(DecimateQuality, BadPlacesStayAndDoNotSpread)
{
    const Mesh good = grid(40, true, false).mesh();
    Array<glm::vec3> positions(good.positions().begin(), good.positions().end());
    Array<uint32_t> corners(good.cornerVertex().begin(), good.cornerVertex().end());
    for (uint32_t i = 0; i < 30; ++i) {
        const uint32_t* t = good.cornerVertex().data() + 3 * (97 * i);
        positions.push_back(1.1f * positions[t[0]]);
        switch (i % 5) {
            case 0:
                corners.insert(corners.end(), {t[0], t[1], uint32_t(positions.size() - 1)});
                break;
            case 1:
                corners.insert(corners.end(), {t[0], t[1], t[2]});
                break;
            case 2:
                corners.insert(corners.end(), {t[2], t[1], t[0]});
                break;
            case 3:
                corners.insert(corners.end(), {t[0], t[0], t[1]});
                break;
            default:
                break;
        }
    }
    const Mesh bad = Mesh::triangles(positions, corners);
    const TopologyReport& before = bad.topology();
    for (const char* quality : qualities) {
        const Mesh out = simplified(bad, quality, "ratio=0.3");
        const TopologyReport& after = out.topology();
        EXPECT_LE(out.faceCount(), bad.faceCount() / 2) << quality;
        EXPECT_EQ(after.nonmanifoldEdges.size(), before.nonmanifoldEdges.size()) << quality;
        EXPECT_EQ(after.degenerateFaces.size(), before.degenerateFaces.size()) << quality;
        EXPECT_EQ(after.isolatedVertices.size(), before.isolatedVertices.size()) << quality;
    }
}

// A hub of many faces: lists by vertex must not be compared each with each.
TEST(DecimateQuality, HubsTakeNoLongerThanOthers)
{
    const uint32_t n = 50'000;
    Polygons cone;
    cone.positions.emplace_back(0, 0, 1);
    for (uint32_t i = 0; i < n; ++i) cone.positions.emplace_back(std::cos(6.283185 * i / n), std::sin(6.283185 * i / n), 0);
    for (uint32_t i = 0; i < n; ++i) cone.face({0, 1 + i, 1 + (i + 1) % n});
    EXPECT_TRUE(simplified(cone.mesh(), "fast", "ratio=0.5").topology().manifold());
}

TEST(DecimateOpenMesh, ReachesTheCountAndKeepsPositions)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh mesh = meshOf(data / "meshes/closed_higher_genus/rocker-arm.obj");
    const Mesh out = applied("decimate-openmesh", mesh, "ratio=0.1");
    EXPECT_LE(out.faceCount(), 2009u);
    EXPECT_GE(out.faceCount(), 2007u);
    EXPECT_TRUE(out.topology().manifold());
    EXPECT_EQ(out.topology().genus.value_or(-1), 1);
    EXPECT_TRUE(out.attributes().empty());
    for (const glm::vec3& p : out.positions()) ASSERT_TRUE(std::find(mesh.positions().begin(), mesh.positions().end(), p) != mesh.positions().end());
    EXPECT_EQ(applied("decimate-openmesh", grid(20, true, true).mesh(), "stop=faces,faces=200").faceCount(), 200u) << "quads are cut first";
    EXPECT_THROW(applied("decimate-openmesh", meshOf(data / "meshes/nonmanifold/beetle.obj"), ""), Error);
}

}  // namespace
