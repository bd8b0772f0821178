// Simplifying a character: weights stay weights, the texture stays where it was, and the walk stays the walk.
#include <cmath>

#include "core/catalog/catalog.h"
#include "core/io/io.h"
#include "core/math/closest.h"
#include "core/scene/scene_pose.h"

#include "data.h"

namespace mw::test {
namespace {

/// Distance of a point to a mesh of triangles, and its texture coordinates there.
struct Nearest {
    double distance = 1e300;
    uint32_t face = 0;
    glm::dvec3 weight{0};
};
Nearest nearest(const glm::dvec3& p, const Mesh& m)
{
    Nearest best;
    for (uint32_t f = 0; f < m.faceCount(); ++f) {
        const auto v = m.face(f);
        const glm::dvec3 a(m.positions()[v[0]]), b(m.positions()[v[1]]), c(m.positions()[v[2]]);
        const glm::dvec3 w = closestOnTriangle(p, a, b, c);
        const double d = glm::length(w.x * a + w.y * b + w.z * c - p);
        if (d < best.distance) best = {d, f, w};
    }
    return best;
}

double farthest(const Mesh& from, const Mesh& to)
{
    double worst = 0;
    for (const glm::vec3& p : from.positions()) worst = std::max(worst, nearest(p, to).distance);
    return worst;
}

glm::dvec2 textureAt(const Mesh& m, uint32_t face, const glm::dvec3& weight)
{
    const Attribute& t = *m.find("texcoord", Domain::Corner);
    glm::dvec2 sum(0);
    for (uint32_t k = 0; k < 3; ++k) sum += weight[int(k)] * glm::dvec2(t.at(3 * face + k, 0), t.at(3 * face + k, 1));
    return sum;
}

struct Man {
    Scene scene;
    NodeId node;
    Mesh full, small;
    explicit Man(const std::filesystem::path& data) : scene(readFile(data / "characters/cesium_man.gltf").scene)
    {
        for (const NodeId id : scene.nodes())
            if (scene.find(scene.node(id).mesh)) node = id;
        full = scene.find(scene.node(node).mesh)->base;
        small = std::get<Mesh>(apply(operation("decimate-quadric"), full, {{"ratio", 0.3}}));
    }
    Mesh posedAt(const Mesh& m, double time) const
    {
        const ScenePose pose = poseAt(scene, *scene.find(scene.clips().at(0)), time);
        return posed(m, *meshPose(scene, node, m, pose, worldMatrices(scene, pose)));
    }
};

TEST(DecimatedCharacter, KeepsWeights)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Man man(data);
    EXPECT_LT(man.small.faceCount(), man.full.faceCount() * 0.31);
    const Attribute &weights = *man.small.find("weights", Domain::Vertex), &joints = *man.small.find("joints", Domain::Vertex);
    ASSERT_EQ(weights.size(), man.small.vertexCount());
    const size_t slots = man.scene.find(man.scene.node(man.node).skin)->joints.size();
    for (size_t v = 0; v < weights.size(); ++v) {
        double sum = 0;
        for (int k = 0; k < weights.components; ++k) {
            EXPECT_GE(weights.at(v, k), 0);
            EXPECT_TRUE(joints.at(v, k) >= 0 && joints.at(v, k) < double(slots));
            sum += weights.at(v, k);
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

// The middle of each new face shows the piece of the picture that the old surface showed there, also beside seams.
TEST(DecimatedCharacter, KeepsTheTextureAndItsSeams)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Man man(data);
    size_t off = 0;
    for (uint32_t f = 0; f < man.small.faceCount(); ++f) {
        const auto v = man.small.face(f);
        const glm::dvec3 third(1 / 3.0);
        const glm::dvec3 middle =
            (glm::dvec3(man.small.positions()[v[0]]) + glm::dvec3(man.small.positions()[v[1]]) + glm::dvec3(man.small.positions()[v[2]])) / 3.0;
        const Nearest n = nearest(middle, man.full);
        off += glm::length(textureAt(man.small, f, third) - textureAt(man.full, n.face, n.weight)) > 0.02;
    }
    EXPECT_LE(off, man.small.faceCount() / 50);
}

TEST(DecimatedCharacter, WalksAsBefore)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Man man(data);
    const double last = duration(*man.scene.find(man.scene.clips().at(0)));
    for (int i = 0; i < 10; ++i) {
        const Mesh full = man.posedAt(man.full, last * i / 9), small = man.posedAt(man.small, last * i / 9);
        const double size = full.bounds().diagonal();
        EXPECT_LE(farthest(small, full), 0.01 * size) << "at " << last * i / 9;
        EXPECT_LE(farthest(full, small), 0.025 * size) << "at " << last * i / 9;
    }
}

}  // namespace
}  // namespace mw::test
