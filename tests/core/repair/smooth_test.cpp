// Smoothing against closed forms: eigenvalues of the ring, the fixed circle, size kept and lost.
#include "core/repair/smooth.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/mesh/topology.h"

namespace mw {
namespace {

// n x n torus of triangles on the unit grid, z = a plane wave: an eigenvector of the uniform umbrella operator.
Mesh wave(uint32_t n, uint32_t kx, uint32_t ky)
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) p.push_back({0, 0, std::cos(2 * M_PI * (kx * x + ky * y) / n)});
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * n + x, b = y * n + (x + 1) % n, c = (y + 1) % n * n + (x + 1) % n, d = (y + 1) % n * n + x;
            for (uint32_t v : {a, b, c, a, c, d}) t.push_back(v);
        }
    return Mesh::triangles(p, t);
}

Mesh smoothed(const Mesh& m, const Smooth& p)
{
    Stage<Mesh> stage(false);
    Generator g = smooth(m, p, stage);
    while (g.next()) {
    }
    return stage.value();
}

// Mean of cos over the six neighbours (1,0), (0,1), (1,1) and their opposites, minus 1.
double eigenvalue(uint32_t n, uint32_t kx, uint32_t ky)
{
    const double x = 2 * M_PI * kx / n, y = 2 * M_PI * ky / n;
    return (std::cos(x) + std::cos(y) + std::cos(x + y)) / 3 - 1;
}

TEST(Smooth, DampsAPlaneWaveByItsEigenvalue)
{
    Smooth p;
    p.method = Smooth::Method::Laplacian;
    p.iterations = 5;
    p.lambda = 0.4;
    for (const auto& [kx, ky] : {std::pair{1u, 0u}, {2u, 3u}, {6u, 1u}}) {
        const Mesh in = wave(12, kx, ky), out = smoothed(in, p);
        const double factor = std::pow(1 + p.lambda * eigenvalue(12, kx, ky), 5);
        for (size_t v = 0; v < in.vertexCount(); ++v) EXPECT_NEAR(out.positions()[v].z, factor * in.positions()[v].z, 1e-5);
    }
}

TEST(Smooth, TaubinKeepsTheLowFrequencies)
{
    Smooth p;
    p.iterations = 20;
    const double mu = 1 / (p.passBand - 1 / p.lambda);
    const Mesh in = wave(16, 2, 0), out = smoothed(in, p);
    const double e = eigenvalue(16, 2, 0), factor = std::pow((1 + p.lambda * e) * (1 + mu * e), 20);
    for (size_t v = 0; v < in.vertexCount(); ++v) EXPECT_NEAR(out.positions()[v].z, factor * in.positions()[v].z, 1e-4);
    p.method = Smooth::Method::Laplacian;
    p.iterations = 40;
    EXPECT_LT(std::abs(smoothed(in, p).positions()[0].z), 0.5 * std::abs(out.positions()[0].z));
}

TEST(Smooth, CotangentWeightsLeaveAPlaneAlone)
{
    // An uneven fan in a plane: the cotangent mean of an inner vertex is its own place, whatever the sampling.
    Array<glm::vec3> p{{0.1f, -0.2f, 0}};
    const double angles[] = {0, 0.7, 1.9, 2.8, 4.0, 5.3};
    Array<uint32_t> t;
    for (uint32_t i = 0; i < 6; ++i) {
        p.push_back({2 * std::cos(angles[i]), 2 * std::sin(angles[i]), 0});
        for (uint32_t v : {0u, i + 1, (i + 1) % 6 + 1}) t.push_back(v);
    }
    Smooth s;
    s.method = Smooth::Method::Laplacian;
    s.weights = Smooth::Weights::Cotangent;
    const Mesh m = Mesh::triangles(p, t), out = smoothed(m, s);
    for (size_t v = 0; v < m.vertexCount(); ++v) EXPECT_LT(glm::distance(out.positions()[v], m.positions()[v]), 1e-5f);
    s.weights = Smooth::Weights::Uniform;
    EXPECT_GT(glm::distance(smoothed(m, s).positions()[0], m.positions()[0]), 0.1f);
}

TEST(Smooth, FixedBoundariesStayAndFreeOnesMove)
{
    const Array<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Mesh m = Mesh::triangles(p, Array<uint32_t>{0, 1, 2});
    EXPECT_EQ(contentHash(smoothed(m, {})), contentHash(m));
    Smooth free;
    free.method = Smooth::Method::Laplacian;
    free.fixBoundary = false;
    free.iterations = 200;
    const Mesh out = smoothed(m, free);
    for (const glm::vec3& q : out.positions()) EXPECT_LT(glm::distance(q, glm::vec3(1, 1, 0) / 3.f), 1e-4f);
}

}  // namespace
}  // namespace mw
