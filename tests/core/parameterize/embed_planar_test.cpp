// Planar embeddings by what must hold of them: means of rings, planar meshes reproduced, no fold-overs, solvers that agree; and the sparse solver by
// dense elimination.
#include "core/parameterize/embed_planar.h"

#include <gtest/gtest.h>

#include "core/math/random.h"
#include "core/mesh/topology.h"
#include "core/metrics/uv_layout.h"
#include "core/parameterize/sparse_direct.h"
#include "core/parameterize/spring_system.h"
#include "core/steps/stepper.h"
#include "tests/core/algorithm_meshes.h"
#include "tests/data.h"

namespace mw::test {
namespace {

constexpr EdgeWeights everyWeight[] = {EdgeWeights::Uniform, EdgeWeights::Wachspress, EdgeWeights::Harmonic, EdgeWeights::MeanValue};

/// A round piece of an uneven surface: triangles of many shapes, one border.
Mesh bumpyDisk(uint32_t n, double height, uint32_t seed = 1)
{
    Random random(seed);
    Polygons p;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) {
            const bool inside = x > 0 && y > 0 && x < n && y < n;
            const double u = x + (inside ? 0.4 * (random.uniform() - 0.5) : 0), v = y + (inside ? 0.4 * (random.uniform() - 0.5) : 0);
            p.positions.emplace_back(u, v, height * std::sin(0.7 * u) * std::cos(0.9 * v));
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
            if (random.uniform() < 0.5)
                p.face({a, b, c}).face({a, c, d});
            else
                p.face({a, b, d}).face({b, c, d});
        }
    return p.mesh();
}

Mesh embedded(const Mesh& mesh, const char* parameters)
{
    return applied("embed-planar", mesh, parameters);
}

/// Each inner vertex against the sum over its ring, from the formula, by itself.
TEST(EmbedPlanar, EveryInnerVertexIsTheMeanOfItsRing)
{
    const Mesh mesh = bumpyDisk(20, 2);
    const std::vector<glm::dvec2> places = planarEmbedding(mesh);
    const Disk disk = diskOf(mesh);
    EXPECT_EQ(disk.border.size(), 80u);
    for (const uint32_t v : disk.inner) {
        glm::dvec2 mean(0);
        for (const uint32_t w : mesh.rings().neighboursOf(v)) mean += places[w];
        EXPECT_LT(glm::length(mean / double(mesh.rings().neighboursOf(v).size()) - places[v]), 1e-12);
    }
    for (size_t i = 0; i < 80; ++i) {
        EXPECT_NEAR(glm::length(places[disk.border[i]]), 1, 1e-12);
        const glm::dvec2 a = places[disk.border[i]], b = places[disk.border[(i + 1) % 80]];
        EXPECT_NEAR(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)), 2 * std::numbers::pi / 80, 1e-12) << "equal steps, anticlockwise";
    }
}

/// Box 3.1: all but the uniform weights reproduce a planar ring, so a planar mesh pinned at its own border stays as it is.
TEST(EmbedPlanar, PlanarMeshesAreReproduced)
{
    const Mesh mesh = bumpyDisk(12, 0);
    const Disk disk = diskOf(mesh);
    std::vector<glm::dvec2> outline;
    for (const uint32_t v : disk.border) outline.emplace_back(mesh.positions()[v]);
    for (const EdgeWeights w : everyWeight) {
        const std::vector<glm::dvec2> places = planarEmbedding(disk, w, outline);
        double worst = 0;
        for (const uint32_t v : disk.inner) worst = std::max(worst, glm::length(places[v] - glm::dvec2(mesh.positions()[v])));
        if (w == EdgeWeights::Uniform)
            EXPECT_GT(worst, 0.05);
        else
            EXPECT_LT(worst, 1e-6) << int(w);
    }
}

TEST(EmbedPlanar, ResidualAndFoldOversOfDataMeshes)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    for (const char* name : {"disk/camelhead.off", "disk/lilium.obj", "disk/cat_head.obj", "disk/hemisphere.off", "disk/woody.obj", "disk/circle.obj",
                             "quads/inspired_mesh_quads_Smooth.off"}) {
        SCOPED_TRACE(name);
        const Mesh mesh = meshOf(data / "meshes" / name);
        const Disk disk = diskOf(mesh);
        for (const EdgeWeights w : everyWeight)
            for (const PlanarOutline o : {PlanarOutline::Circle, PlanarOutline::Square, PlanarOutline::Chord}) {
                const std::vector<glm::dvec2> places = planarEmbedding(mesh, w, o);
                EXPECT_LT(SpringSystem(disk, w).residual(places), 1e-9);
                // Triangles at the tips of the quads' border have all their corners on one side of the square.
                if (o == PlanarOutline::Square && !mesh.isTriangles()) continue;
                if (w == EdgeWeights::Uniform || w == EdgeWeights::MeanValue) {
                    EXPECT_EQ(foldedFaces(mesh, places).size(), 0u) << int(w) << int(o);
                }
            }
    }
}

/// Figure 3.27: counts, border at steps of 60 and 18 degrees, inner vertices means of their rings, no fold-overs; and the outside is out.
TEST(EmbedPlanar, HouseAndCar)
{
    const struct {
        const char* id;
        size_t vertices, edges, faces, border;
    } shapes[] = {{"house", 15, 36, 22, 6}, {"car", 32, 73, 42, 20}};
    for (const auto& s : shapes) {
        const Mesh mesh = std::get<Mesh>(apply(operation(s.id), {}, {}));
        const TopologyReport& t = mesh.topology();
        EXPECT_EQ(t.vertices, s.vertices);
        EXPECT_EQ(t.edges, s.edges);
        EXPECT_EQ(t.faces, s.faces);
        EXPECT_EQ(t.euler, 1);
        const Disk disk = diskOf(mesh);
        EXPECT_EQ(disk.border.size(), s.border);
        EXPECT_TRUE(foldedFaces(mesh, planarEmbedding(mesh)).empty());
        glm::dvec3 centre = mesh.bounds().centre();
        size_t inwards = 0;
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            const glm::dvec3 a = mesh.positions()[mesh.face(f)[0]];
            inwards += glm::dot(glm::dvec3(mesh.faceNormals()[f]), a - centre) < 0;
        }
        EXPECT_EQ(inwards, 0u) << s.id;
    }
}

/// Of three points on a side of the square none lies between: no face may be flat.
TEST(EmbedPlanar, SquaresHaveTheirCornersWhereTheMeshHas)
{
    for (const uint32_t n : {1u, 2u, 5u, 9u}) {
        const Mesh mesh = bumpyDisk(n, 0.3);
        const std::vector<glm::dvec2> places = planarEmbedding(mesh, EdgeWeights::Uniform, PlanarOutline::Square);
        EXPECT_TRUE(foldedFaces(mesh, places).empty()) << n;
        if (n < 2) continue;
        const uint32_t corners[] = {0, n, n * (n + 2), n * (n + 1)};
        for (const uint32_t c : corners) {
            EXPECT_NEAR(std::abs(places[c].x), 1, 1e-12) << n;
            EXPECT_NEAR(std::abs(places[c].y), 1, 1e-12) << n;
        }
    }
}

TEST(EmbedPlanar, SolversAgree)
{
    const Mesh mesh = bumpyDisk(10, 1);
    for (const char* weights : {"uniform", "harmonic", "mean-value"}) {
        const std::string with = std::string("output=flat,weights=") + weights;
        const Mesh direct = embedded(mesh, with.c_str());
        for (const char* solver : {",solver=jacobi,tolerance=1e-10", ",solver=gauss-seidel,tolerance=1e-10"}) {
            // Gauss-Seidel settles whenever the matrix is positive definite, Jacobi may not where springs push.
            if (weights == std::string("harmonic") && std::string(solver).find("jacobi") != std::string::npos) continue;
            const Mesh other = embedded(mesh, (with + solver).c_str());
            for (size_t v = 0; v < mesh.vertexCount(); ++v)
                EXPECT_LT(glm::length(other.positions()[v] - direct.positions()[v]), 1e-5) << weights << solver;
        }
    }
}

TEST(EmbedPlanar, SweepsEndAtTheirLimit)
{
    const Mesh mesh = bumpyDisk(16, 1);
    Stepper s(stepping(operation("embed-planar"), mesh, parsed(operation("embed-planar").parameters, "solver=jacobi,iterations=3")));
    size_t sweeps = 0;
    double largest = 1e9, error = 1e9;
    while (s.forward()) {
        if (s.step().phase != "sweep") continue;
        ++sweeps;
        for (const Number& n : s.step().numbers) {
            if (std::string_view(n.name) == "largest") {
                EXPECT_LT(n.value, largest);
                largest = n.value;
            } else if (std::string_view(n.name) == "error") {
                EXPECT_LT(n.value, error);
                error = n.value;
            }
        }
    }
    EXPECT_EQ(sweeps, 3u);
    EXPECT_GT(error, 0.01);
}

/// Polygons stay; texture coordinates lie in the unit square; the flat net has the area of the mesh.
TEST(EmbedPlanar, PolygonsStay)
{
    Polygons quads = grid(8, false, true);
    for (glm::vec3& p : quads.positions) p.z = 0.1f * p.x * p.y;
    const Mesh mesh = quads.mesh(), out = embedded(mesh, "");
    EXPECT_EQ(out.faceCount(), 64u);
    EXPECT_EQ(out.cornerVertex().id(), mesh.cornerVertex().id());
    const UvLayout layout = uvLayoutOf(out, 0);
    EXPECT_TRUE(layout.folded.empty());
    EXPECT_EQ(layout.seams, 0u);
    EXPECT_GE(layout.low.x, 0);
    EXPECT_LE(layout.high.y, 1);
    EXPECT_EQ(out.find("folded"), nullptr);
    const Mesh square = embedded(mesh, "output=flat,boundary=square");
    EXPECT_NEAR(surfaceArea(square), surfaceArea(mesh), 1e-4 * surfaceArea(mesh));
}

/// A very obtuse pair of triangles: their edge pushes harmonic springs apart, so that a face folds; uniform and mean value never do.
TEST(EmbedPlanar, HarmonicFoldsAreCountedAndMarked)
{
    size_t folded = 0;
    for (uint32_t seed = 1; seed < 30; ++seed) {
        const Mesh mesh = bumpyDisk(6, 6, seed);
        for (const char* w : {"uniform", "mean-value"}) {
            const Mesh out = embedded(mesh, (std::string("weights=") + w).c_str());
            EXPECT_EQ(out.find("folded"), nullptr) << w << seed;
            EXPECT_TRUE(uvLayoutOf(out, 0).folded.empty()) << w << seed;
        }
        const Mesh out = embedded(mesh, "weights=harmonic");
        const std::vector<uint32_t> over = uvLayoutOf(out, 0).folded;
        const Attribute* flags = out.find("folded", Domain::Face);
        EXPECT_EQ(flags != nullptr, !over.empty());
        for (const uint32_t f : over) EXPECT_EQ(flags->at(f, 0), 1);
        folded += over.size();
    }
    EXPECT_GT(folded, 0u);
}

void expectRefused(const Mesh& mesh, const std::string& word)
{
    try {
        embedded(mesh, "");
        ADD_FAILURE() << "no error with " << word;
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
}

TEST(EmbedPlanar, WhatIsNoDiskIsRefusedWithARemedy)
{
    expectRefused(tetrahedron().mesh(), "closed");
    expectRefused(grid(6, true, false).mesh(), "closed");
    expectRefused(Mesh(), "no faces");
    Polygons two = Polygons::points(6);
    expectRefused(two.face({0, 1, 2}).face({3, 4, 5}).mesh(), "2 pieces");
    Polygons turned = Polygons::points(4);
    expectRefused(turned.face({0, 1, 2}).face({0, 1, 3}).mesh(), "turned against");
    Polygons three = Polygons::points(5);
    expectRefused(three.face({0, 1, 2}).face({0, 1, 3}).face({0, 1, 4}).mesh(), "Repair");
    const Operation& tube = operation("cylinder");
    expectRefused(std::get<Mesh>(apply(tube, {}, parsed(tube.parameters, "caps=open"))), "2 boundaries");
}

// ---- The sparse solver by itself.

struct System {
    SparsePattern pattern;
    SparseValues values;
    std::vector<glm::vec3> places;
    std::vector<std::vector<double>> dense;
};

/// Of a grid with random diagonals, some unknowns joined to nobody, some to far ones; diagonally dominant.
System randomSystem(uint32_t side, bool isSymmetric, uint32_t seed)
{
    Random random(seed);
    const uint32_t n = side * side;
    System s;
    s.dense.assign(n, std::vector<double>(n, 0.0));
    const auto join = [&](uint32_t a, uint32_t b) {
        s.dense[a][b] = -random.uniform() - 0.01;
        s.dense[b][a] = isSymmetric ? s.dense[a][b] : -random.uniform() - 0.01;
    };
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            s.places.emplace_back(x, y, random.uniform());
            if (x + 1 < side && random.uniform() < 0.9) join(y * side + x, y * side + x + 1);
            if (y + 1 < side && random.uniform() < 0.9) join(y * side + x, y * side + side + x);
        }
    for (int k = 0; k < 5; ++k) {
        const uint32_t a = uint32_t(random.uniform() * n), b = uint32_t(random.uniform() * n);
        if (a != b) join(a, b);
    }
    for (uint32_t i = 0; i < n; ++i) {
        double sum = 0.05;
        for (uint32_t j = 0; j < n; ++j) {
            if (s.dense[i][j] == 0) continue;
            s.pattern.column.push_back(j);
            s.values.off.push_back(s.dense[i][j]);
            sum -= s.dense[i][j];
        }
        s.pattern.start.push_back(uint32_t(s.pattern.column.size()));
        s.values.diagonal.push_back(sum);
        s.dense[i][i] = sum;
    }
    s.values.symmetric = isSymmetric;
    return s;
}

double worstResidual(const System& s, const std::vector<glm::dvec2>& x, const std::vector<glm::dvec2>& b)
{
    double worst = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        glm::dvec2 sum(0);
        for (size_t j = 0; j < x.size(); ++j) sum += s.dense[i][j] * x[j];
        worst = std::max(worst, glm::length(sum - b[i]));
    }
    return worst;
}

TEST(SparseDirect, SolvesWhatTheMatrixSays)
{
    for (const bool isSymmetric : {true, false})
        for (const uint32_t side : {1u, 3u, 7u, 20u, 41u}) {
            System s = randomSystem(side, isSymmetric, side);
            SparseDirect direct(s.pattern, s.places);
            while (direct.order(10)) {
            }
            while (direct.analyse(10)) {
            }
            for (int again = 0; again < 2; ++again) {  // other values on the same analysis
                direct.begin(s.values);
                while (direct.factor(100)) {
                }
                EXPECT_EQ(direct.factored(), direct.supernodes());
                std::vector<glm::dvec2> b(s.places.size());
                for (size_t i = 0; i < b.size(); ++i) b[i] = {std::sin(double(i)), i % 7 == 0};
                std::vector<glm::dvec2> x = b;
                direct.solve(x);
                EXPECT_LT(worstResidual(s, x, b), 1e-11) << side << isSymmetric;
                for (size_t i = 0; i < b.size(); ++i) s.dense[i][i] = s.values.diagonal[i] += 0.3 * double(i % 3);
            }
        }
}

TEST(SparseDirect, EachUnknownIsEliminatedOnce)
{
    const System s = randomSystem(30, true, 5);
    SparseDirect direct(s.pattern, s.places);
    while (direct.order(1e9)) {
    }
    while (direct.analyse(1e9)) {
    }
    std::vector<int> seen(900, 0);
    size_t groups = 0;
    for (size_t i = 0; i < direct.supernodes(); ++i) {
        for (const uint32_t u : direct.supernode(i).own) ++seen[u];
        groups += direct.supernode(i).own.size() > 1;
    }
    EXPECT_EQ(seen, std::vector<int>(900, 1));
    EXPECT_GT(groups, 20u);
}

/// The order is then a poor one, no wrong one.
TEST(SparseDirect, PlacesThatSayNothingDo)
{
    System s = randomSystem(20, true, 7);
    const float huge = std::numeric_limits<float>::max(), nothing = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec3> given = s.places;
    for (int way = 0; way < 3; ++way) {
        for (size_t i = 0; i < given.size(); ++i) {
            if (way == 0) s.places[i] = {1, 2, 3};
            if (way == 1) s.places[i] = i % 50 ? given[i] : glm::vec3(i % 100 ? huge : -huge, 0, 0);
            if (way == 2) s.places[i] = i % 3 ? given[i] : glm::vec3(nothing, 0, HUGE_VALF);
        }
        SparseDirect direct(s.pattern, s.places);
        while (direct.order(100)) {
        }
        while (direct.analyse(100)) {
        }
        direct.begin(s.values);
        while (direct.factor(1e9)) {
        }
        const std::vector<glm::dvec2> b(given.size(), glm::dvec2(1, -2));
        std::vector<glm::dvec2> x = b;
        direct.solve(x);
        EXPECT_LT(worstResidual(s, x, b), 1e-11) << way;
    }
}

/// Threads must not change a bit.
TEST(SparseDirect, ThreadsGiveTheSameBits)
{
    const Mesh mesh = bumpyDisk(150, 3);
    const Disk disk = diskOf(mesh);
    for (const EdgeWeights w : {EdgeWeights::Uniform, EdgeWeights::MeanValue}) {
        const SpringSystem springs(disk, w);
        std::vector<glm::dvec2> x[2];
        for (const bool threads : {false, true}) {
            SparseDirect direct(springs.pattern(), springs.places());
            while (direct.order(1e5)) {
            }
            while (direct.analyse(1e5)) {
            }
            ASSERT_GT(direct.operations(), 2e7);
            direct.begin(springs.values());
            while (direct.factor(1e6, threads)) {
            }
            x[threads].assign(disk.inner.size(), glm::dvec2(1, 0.5));
            direct.solve(x[threads]);
        }
        EXPECT_EQ(x[0], x[1]);
    }
}

TEST(SparseDirect, WhatIsNotDefiniteIsRefused)
{
    System s = randomSystem(5, true, 1);
    s.values.diagonal[7] = -1;
    SparseDirect direct(s.pattern, s.places);
    while (direct.order(1e9)) {
    }
    while (direct.analyse(1e9)) {
    }
    direct.begin(s.values);
    EXPECT_THROW(direct.factor(1e9), Error);
    EXPECT_THROW(direct.begin(s.values, 10), Error) << "more memory than allowed";
}

}  // namespace
}  // namespace mw::test
