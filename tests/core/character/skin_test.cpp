// Morphing and linear blend skinning against closed forms.
#include "core/character/skin.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace mw {
namespace {

/// A triangle in the plane z = 0 with corner normals +z, four or more slots a vertex.
Mesh skinned(int slots, Array<int32_t> joints, Array<float> weights)
{
    Mesh m = Mesh::triangles(Array<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, Array<uint32_t>{0, 1, 2});
    m = m.with(integerAttribute("joints", Domain::Vertex, slots, std::move(joints)));
    m = m.with(floatAttribute("weights", Domain::Vertex, slots, std::move(weights)));
    return m.with(floatAttribute("normal", Domain::Corner, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

glm::vec3 vec(const Attribute& a, size_t i)
{
    return {a.at(i, 0), a.at(i, 1), a.at(i, 2)};
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-6f)
{
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

// The candy wrapper (7.12): half of a joint at rest, half of one turned by 180 degrees about x, shrinks y and z to nothing.
TEST(Skin, HalfTurnedByHalfATurnCollapses)
{
    const Mesh m = skinned(4, {0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0}, {.5f, .5f, 0, 0, .5f, .5f, 0, 0, 1, 0, 0, 0});
    MeshPose pose;
    pose.joints = {glm::mat4(1), glm::rotate(glm::mat4(1), glm::radians(180.f), glm::vec3(1, 0, 0)),
                   glm::translate(glm::mat4(1), glm::vec3(5, 6, 7))};
    const Mesh p = posed(m, pose);
    expectNear(p.positions()[0], {1, 0, 0});
    expectNear(p.positions()[1], {0, 0, 0});
    expectNear(p.positions()[2], {5, 6, 7});
    EXPECT_TRUE(p.find("joints") && p.find("weights"));
    EXPECT_EQ(p.cornerVertex().id(), m.cornerVertex().id());
}

// Under a matrix that is no rotation the normal stays at right angles to the surface it belongs to.
TEST(Skin, NormalsAreTurnedByTheInverseTransposeOfTheBlend)
{
    glm::mat4 a = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3))) * glm::scale(glm::mat4(1), glm::vec3(1, 3, 0.2f));
    glm::mat4 b = glm::scale(glm::mat4(1), glm::vec3(2, 0.5f, 1));
    b[2][0] = 0.8f;  // shears
    Mesh m = skinned(1, {0, 0, 0}, {1, 1, 1});
    m = m.with(integerAttribute("joints", Domain::Vertex, 4, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}));
    m = m.with(floatAttribute("weights", Domain::Vertex, 4, {.25f, .75f, 0, 0, .25f, .75f, 0, 0, .25f, .75f, 0, 0}));
    m = m.with(floatAttribute("tangent", Domain::Corner, 4, {1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}));
    MeshPose pose;
    pose.joints = {a, b};
    const Mesh p = posed(m, pose);
    const glm::mat4 blend = .25f * a + .75f * b;
    const Attribute &normal = *p.find("normal"), &tangent = *p.find("tangent");
    for (size_t c = 0; c < 3; ++c) {
        expectNear(vec(normal, c), glm::normalize(glm::inverseTranspose(glm::mat3(blend)) * glm::vec3(0, 0, 1)), 1e-5f);
        expectNear(vec(tangent, c), glm::normalize(glm::vec3(blend[0])), 1e-5f);
        EXPECT_EQ(tangent.at(c, 3), -1);
        EXPECT_NEAR(glm::dot(vec(normal, c), p.positions()[1] - p.positions()[0]), 0, 1e-5);
    }
}

TEST(Skin, AMirrorTurnsNormalsLikeTheInverseTranspose)
{
    const Mesh m = skinned(4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    MeshPose pose;
    pose.joints = {glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1))};
    expectNear(vec(*posed(m, pose).find("normal"), 0), {0, 0, 1});
    pose.joints = {glm::scale(glm::mat4(1), glm::vec3(1, 1, 0))};  // flat: no inverse, still a normal
    expectNear(vec(*posed(m, pose).find("normal"), 0), {0, 0, 1});
}

TEST(Skin, MoreThanFourWeightsAndNone)
{
    // Eight slots of 1/8 each, the joints moved by 1..8 along x: the mean is 4.5. The second vertex has no weights, the third an unknown slot.
    Array<int32_t> joints{0, 1, 2, 3, 4, 5, 6, 7, 0, 0, 0, 0, 0, 0, 0, 0, 99, 0, 0, 0, 0, 0, 0, 0};
    Array<float> weights(24, 0.f);
    std::fill_n(weights.begin(), 8, 0.125f);
    weights[16] = 1;
    MeshPose pose;
    for (int i = 1; i <= 8; ++i) pose.joints.push_back(glm::translate(glm::mat4(1), glm::vec3(i, 0, 0)));
    const Mesh p = posed(skinned(8, joints, weights), pose);
    expectNear(p.positions()[0], {5.5f, 0, 0});
    expectNear(p.positions()[1], {0, 1, 0});
    expectNear(p.positions()[2], {0, 0, 0});
}

TEST(Skin, MorphsThenSkins)
{
    Mesh m = skinned(4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    m = m.with(floatAttribute("morph:one", Domain::Vertex, 3, {1, 0, 0, 0, 0, 0, 0, 0, 0}));
    m = m.with(floatAttribute("morph:two", Domain::Vertex, 3, {0, 2, 0, 0, 0, 0, 0, 0, 4}));
    m = m.with(floatAttribute("morph-normal:two", Domain::Corner, 3, {0, 2, 0, 0, 0, 0, 0, 0, 0}));
    MeshPose pose;
    pose.joints = {glm::scale(glm::mat4(1), glm::vec3(10))};
    pose.morphWeights = {0.5f, -0.25f};
    const Mesh p = posed(m, pose);
    expectNear(p.positions()[0], {15, -5, 0});
    expectNear(p.positions()[1], {0, 10, 0});
    expectNear(p.positions()[2], {0, 0, -10});
    expectNear(vec(*p.find("normal"), 0), glm::normalize(glm::vec3(0, -0.5f, 1)));
    expectNear(vec(*p.find("normal"), 1), {0, 0, 1});
    pose.morphWeights = {1};  // the second one is 0
    pose.joints.clear();
    expectNear(posed(m, pose).positions()[0], {2, 0, 0});
    expectNear(posed(m, pose).positions()[2], {0, 0, 0});
}

}  // namespace
}  // namespace mw
