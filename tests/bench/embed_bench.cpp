// The direct solver of planar embeddings against Eigen 3.4: SimplicialLDLT with AMD for uniform weights, SparseLU for mean value. From the pattern of
// the matrix to the places of all vertices, one thread, CPU time.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <benchmark/benchmark.h>
#include <cmath>
#include <optional>

#include "core/math/random.h"
#include "core/parameterize/embed_planar.h"
#include "core/parameterize/spring_system.h"

#include "bench/bench_meshes.h"

namespace mw::bench {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// n x n squares with waves, each cut along either diagonal, inner vertices shaken.
Mesh wavyDisk(uint32_t n)
{
    Random random(1);
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) {
            const bool inside = x > 0 && y > 0 && x < n && y < n;
            const double u = x + (inside ? 0.4 * (random.uniform() - 0.5) : 0), v = y + (inside ? 0.4 * (random.uniform() - 0.5) : 0);
            p.emplace_back(u, v, 6 * std::sin(0.09 * u) * std::cos(0.07 * v));
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
            if (random.uniform() < 0.5)
                t.insert(t.end(), {a, b, c, a, c, d});
            else
                t.insert(t.end(), {a, b, d, b, c, d});
        }
    return Mesh::triangles(std::move(p), std::move(t));
}

/// A system and its right sides, as both programs get them.
struct Problem {
    Disk disk;
    SpringSystem springs;
    SparsePattern pattern;
    SparseValues values;
    std::vector<glm::vec3> in;
    std::vector<glm::dvec2> pinned, right;
    Matrix matrix;
    Eigen::MatrixXd sides;

    Problem(const Mesh& mesh, EdgeWeights weights)
        : disk(diskOf(mesh)),
          springs(disk, weights),
          pattern(springs.pattern()),
          values(springs.values()),
          in(springs.places()),
          pinned(mesh.vertexCount(), glm::dvec2(0))
    {
        const std::vector<glm::dvec2> outline = outlinePlaces(disk, PlanarOutline::Circle);
        for (size_t i = 0; i < outline.size(); ++i) pinned[disk.border[i]] = outline[i];
        right = springs.rightSides(pinned);
        const auto n = Eigen::Index(pattern.size());
        std::vector<Eigen::Triplet<double>> entries;
        sides.resize(n, 2);
        for (Eigen::Index i = 0; i < n; ++i) {
            entries.emplace_back(int(i), int(i), values.diagonal[size_t(i)]);
            for (uint32_t k = pattern.start[size_t(i)]; k < pattern.start[size_t(i) + 1]; ++k)
                entries.emplace_back(int(i), int(pattern.column[k]), values.off[k]);
            sides(i, 0) = right[size_t(i)].x, sides(i, 1) = right[size_t(i)].y;
        }
        matrix.resize(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
    }
    SparseDirect prepared() const
    {
        SparseDirect s(pattern, in);
        while (s.order(1e9)) {
        }
        while (s.analyse(1e9)) {
        }
        return s;
    }
    void factor(SparseDirect& s) const
    {
        s.begin(values);
        while (s.factor(1e12, false)) {
        }
    }
    double residual(std::span<const glm::dvec2> x) const
    {
        std::vector<glm::dvec2> places = pinned;
        for (size_t i = 0; i < x.size(); ++i) places[disk.inner[i]] = x[i];
        return springs.residual(places);
    }
};

/// Factors and one solution by the solver of Eigen.
template <class Solver>
double peer(const Problem& p, Eigen::MatrixXd& x)
{
    return quickest(1, [&] {
        Solver solver;
        solver.compute(p.matrix);
        x = solver.solve(p.sides);
    });
}

void embed(benchmark::State& state, uint32_t n, EdgeWeights weights)
{
    const Problem p(wavyDisk(n), weights);
    Eigen::MatrixXd theirs;
    const double eigen = weights == EdgeWeights::Uniform ? peer<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>>>(p, theirs)
                                                         : peer<Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>>>(p, theirs);
    std::vector<glm::dvec2> x;
    double all = 1e9, again = 1e9, solve = 1e9;
    for (auto _ : state) {
        std::optional<SparseDirect> s;
        all = std::min(all, quickest(1, [&] {
                           s.emplace(p.prepared());
                           p.factor(*s);
                           x = p.right;
                           s->solve(x);
                       }));
        again = std::min(again, quickest(1, [&] { p.factor(*s); }));
        solve = std::min(solve, quickest(3, [&] {
                             x = p.right;
                             s->solve(x);
                         }));
    }
    double apart = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        const auto row = Eigen::Index(i);
        apart = std::max(apart, std::hypot(x[i].x - theirs(row, 0), x[i].y - theirs(row, 1)));
    }
    if (!(apart < 1e-8)) state.SkipWithError("the two do not agree");
    state.counters["vertices"] = double(p.pinned.size());
    state.counters["s"] = all;
    state.counters["eigen_s"] = eigen;
    state.counters["ratio"] = all / eigen;
    state.counters["factor_s"] = again;
    state.counters["solve_ms"] = 1e3 * solve;
    state.counters["residual"] = p.residual(x);
    state.counters["apart"] = apart;
}

}  // namespace

BENCHMARK_CAPTURE(embed, uniform_11k, 103, EdgeWeights::Uniform)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK_CAPTURE(embed, uniform_108k, 328, EdgeWeights::Uniform)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK_CAPTURE(embed, uniform_302k, 549, EdgeWeights::Uniform)->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK_CAPTURE(embed, mean_value_108k, 328, EdgeWeights::MeanValue)->Unit(benchmark::kMillisecond)->Iterations(2);

}  // namespace mw::bench
