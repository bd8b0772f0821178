// Another numbering of the same mesh: nothing is lost, and neighbours lie together.
#include "core/mesh/reorder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

#include "core/catalog/catalog.h"
#include "core/mesh/topology.h"

using namespace mw;

namespace {

std::vector<uint32_t> shuffledNumbers(size_t n, uint32_t seed)
{
    std::vector<uint32_t> out(n);
    std::iota(out.begin(), out.end(), 0u);
    std::shuffle(out.begin(), out.end(), std::mt19937(seed));
    return out;
}

/// The mesh with vertices, and if asked faces, in random order. Vertex attribute "place" and face attribute "middle" repeat where things are.
Mesh shuffled(const Mesh& m, bool faces)
{
    const std::vector<uint32_t> v = shuffledNumbers(m.vertexCount(), 1), f = shuffledNumbers(m.faceCount(), 2);
    Array<glm::vec3> p(m.vertexCount());
    Array<float> place(3 * m.vertexCount()), middle;
    for (size_t i = 0; i < v.size(); ++i) {
        p[v[i]] = m.positions()[i];
        for (int k = 0; k < 3; ++k) place[3 * v[i] + size_t(k)] = m.positions()[i][k];
    }
    Array<uint32_t> corners;
    for (size_t i = 0; i < f.size(); ++i) {
        float x = 0;
        for (const uint32_t c : m.face(faces ? f[i] : i)) {
            corners.push_back(v[c]);
            x += m.positions()[c].x;
        }
        middle.push_back(x);
    }
    return Mesh::triangles(p, corners)
        .with(floatAttribute("place", Domain::Vertex, 3, place))
        .with(floatAttribute("middle", Domain::Face, 1, middle));
}

/// Each face as its positions, sorted: what does not depend on numbers.
std::vector<std::array<float, 9>> content(const Mesh& m)
{
    std::vector<std::array<float, 9>> out;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        std::array<float, 9> a{};
        for (size_t i = 0; i < 3; ++i)
            for (size_t k = 0; k < 3; ++k) a[3 * i + k] = m.positions()[m.face(f)[i]][int(k)];
        out.push_back(a);
    }
    std::sort(out.begin(), out.end());
    return out;
}

Mesh ran(const Mesh& m, const char* parameters)
{
    const Operation& op = operation("reorder");
    return std::get<Mesh>(apply(op, m, parsed(op.parameters, parameters)));
}

class Shuffles : public testing::TestWithParam<bool> {};

TEST_P(Shuffles, ArePutInOrderWithAllTheyHave)
{
    const Mesh made = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(5)}}));
    const Mesh mixed = shuffled(made, GetParam());
    EXPECT_GT(scatterOf(mixed), mostScatterInOrder);
    for (const char* method : {"", "method=breadth-first"}) {
        const Mesh m = ran(mixed, method);
        EXPECT_LT(scatterOf(m), mostScatterInOrder) << method;
        EXPECT_EQ(content(m), content(made));
        EXPECT_EQ(m.topology().euler, 2);
        const Attribute *place = m.find("place"), *middle = m.find("middle");
        ASSERT_TRUE(place && middle);
        for (size_t v = 0; v < m.vertexCount(); ++v) ASSERT_EQ(float(place->at(v, 2)), m.positions()[v].z);
        for (size_t f = 0; f < m.faceCount(); ++f) {
            float x = 0;
            for (const uint32_t v : m.face(f)) x += m.positions()[v].x;
            ASSERT_EQ(float(middle->at(f, 0)), x);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Reorder, Shuffles, testing::Bool());

TEST(Reorder, LeavesGoodOrderAlone)
{
    const Mesh ball = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(5)}}));
    EXPECT_EQ(ran(ball, "").positions().id(), ball.positions().id()) << "not even copied";
    const Mesh loose(Array<glm::vec3>{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, Array<uint32_t>{0, 3}, Array<uint32_t>{3, 1, 2});
    const Mesh m = ran(loose, "method=first-use");
    EXPECT_EQ(m.positions()[0].x, 4);
    EXPECT_EQ(m.positions()[3].x, 1) << "unused vertices come last";
}

}  // namespace
