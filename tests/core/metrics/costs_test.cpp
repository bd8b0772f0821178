// Costs of vertices and edges: closed forms, OpenMesh's dihedral angles, Eigen's solution of the normal equations.
#include <Eigen/Dense>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

#include "core/catalog/others.h"
#include "core/math/point_triangle.h"
#include "core/math/random.h"
#include "core/metrics/fan.h"
#include "tests/core/mesh/shapes.h"

namespace mw {
namespace {

constexpr double pi = std::numbers::pi;

Table table(const char* id, const Mesh& mesh, const char* parameters = "")
{
    const Operation& op = operation(id);
    return std::get<Table>(apply(op, mesh, parsed(op.parameters, parameters)));
}

double summary(const Table& t, std::string_view name)
{
    for (const auto& [n, v] : t.summary)
        if (n == name) return v;
    ADD_FAILURE() << "no " << name;
    return NAN;
}

/// k triangles round vertex 0, which stands `height` above the plane of the others, a ring of radius 1.
Mesh fan(uint32_t k, float height)
{
    test::Polygons p;
    p.positions.push_back({0, 0, height});
    for (uint32_t i = 0; i < k; ++i) {
        const double a = 2 * pi * i / k;
        p.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0});
    }
    for (uint32_t i = 0; i < k; ++i) p.face({0, 1 + i, 1 + (i + 1) % k});
    return p.mesh();
}

Mesh bumpy()
{
    const Mesh sphere = *meshOfSource("icosphere:subdivisions=3");
    Random random(4);
    Array<glm::vec3> p(sphere.positions().begin(), sphere.positions().end());
    for (glm::vec3& v : p) v *= float(1 + 0.2 * random.uniform());
    return sphere.withPositions(std::move(p));
}

// The sum of A n / sum of A alone is shorter than 1; made unit, d is height minus the centroids' height.
TEST(Planarity, OfAFanIsTwoThirdsOfItsHeight)
{
    const Table t = table("vertex-planarity", fan(6, 1));
    EXPECT_NEAR(t.columns[1].values[0], 2.0 / 3, 1e-7);
    EXPECT_NEAR(t.columns[0].values[0], 2.0 / 3 / std::sqrt(2), 1e-7);
    for (size_t v = 1; v < 7; ++v) EXPECT_TRUE(std::isnan(t.columns[0].values[v])) << "on the border";
    EXPECT_EQ(summary(t, "measured"), 1);
}

TEST(Planarity, DoesNotDependOnTheScaleNorOnTurns)
{
    const Mesh mesh = bumpy();
    Array<glm::vec3> p;
    for (const glm::vec3& v : mesh.positions()) p.push_back(7.f * glm::vec3(v.z, v.x, v.y));
    const Table a = table("vertex-planarity", mesh), b = table("vertex-planarity", mesh.withPositions(std::move(p)));
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_NEAR(a.columns[0].values[v], b.columns[0].values[v], 1e-6);
        EXPECT_NEAR(7 * a.columns[1].values[v], b.columns[1].values[v], 1e-5);
    }
}

TEST(Planarity, IsZeroOnPlanesOfPolygons)
{
    const Table t = table("vertex-planarity", *meshOfSource("grid"));
    for (const double c : t.columns[0].values) EXPECT_TRUE(std::isnan(c) || c < 1e-7);
    EXPECT_GT(summary(t, "measured"), 0);
}

TEST(BoundaryDistance, IsTheBendOfTheOutline)
{
    const Mesh mesh = *meshOfSource("grid:width=2,depth=2,columns=4,rows=4");
    const Table t = table("boundary-distance", mesh);
    int corners = 0, straight = 0, inner = 0;
    for (const double d : t.columns[0].values) {
        if (std::isnan(d))
            ++inner;
        else if (d < 1e-9)
            ++straight;
        else if (std::abs(d - 0.5 / std::sqrt(2)) < 1e-7)
            ++corners;
    }
    EXPECT_EQ(corners, 4);
    EXPECT_EQ(straight, 12);
    EXPECT_EQ(inner, 9);
}

TEST(BoundaryDistance, IsUndefinedWhereBordersCross)
{
    test::Polygons bowTie;
    bowTie.positions = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}};
    bowTie.face({0, 2, 1}).face({0, 3, 4});
    const Table t = table("boundary-distance", bowTie.mesh());
    EXPECT_TRUE(std::isnan(t.columns[0].values[0]));
    EXPECT_NEAR(t.columns[0].values[1], std::sqrt(2), 1e-7);
}

// From the foot of the axis to a side: apothem times height by the slant.
TEST(VertexQuadric, OfAFanInClosedForm)
{
    const double apothem = std::sqrt(3) / 2, d = apothem / std::hypot(1, apothem);
    const Table t = table("vertex-quadric", fan(6, 1));
    EXPECT_NEAR(t.columns[0].values[0], 6 * d * d, 1e-6);
    EXPECT_NEAR(t.columns[1].values[0], d, 1e-6);
    const double area = 0.5 * std::hypot(1, apothem);
    const Table weighed = table("vertex-quadric", fan(6, 1), "weight=area");
    EXPECT_NEAR(weighed.columns[0].values[0], 6 * area * d * d, 1e-6);
    EXPECT_NEAR(weighed.columns[1].values[0], d, 1e-6);
    // At the mean point of the faces, a third up the axis, two thirds of that are left.
    EXPECT_NEAR(table("vertex-quadric", fan(6, 1), "at=plane").columns[0].values[0], 6 * d * d * 4 / 9, 1e-6);
}

TEST(EdgeDihedral, OfABoxInAllForms)
{
    const Mesh box = *meshOfSource("box:width=1,height=1,depth=1,segments=1");
    const Table plain = table("edge-dihedral", box, "form=angle-length,k1=2,k2=3"), share = table("edge-dihedral", box, "form=normalised,k1=2,k2=3"),
                cosine = table("edge-dihedral", box, "form=cosine,k1=2,k2=3");
    ASSERT_EQ(plain.columns[0].values.size(), 12u);
    ASSERT_EQ(plain.edges.size(), 24u);
    for (size_t e = 0; e < 12; ++e) {
        EXPECT_NEAR(plain.columns[0].values[e], 2 * pi / 2 + 3, 1e-9);
        EXPECT_NEAR(share.columns[0].values[e], 2 * 0.5 + 3, 1e-9);
        EXPECT_NEAR(cosine.columns[0].values[e], 2 * 0.5 + 3, 1e-9);
        EXPECT_NEAR(plain.columns[1].values[e], 90, 1e-9);
        EXPECT_NEAR(plain.columns[2].values[e], 1, 1e-9);
    }
}

/// Triangles and polygons, with third faces, degenerate ones and neighbours that run the same way.
Mesh soupOf(Random& random)
{
    const auto below = [&](uint32_t n) { return uint32_t(random.next() % n); };
    const uint32_t vertices = 3 + below(8), faces = below(14);
    Array<uint32_t> start{0u}, corners;
    for (uint32_t f = 0; f < faces; ++f) {
        for (uint32_t c = below(6) == 0 ? below(6) : 3; c > 0; --c) corners.push_back(below(vertices));
        start.push_back(uint32_t(corners.size()));
    }
    Array<glm::vec3> positions(vertices);
    for (glm::vec3& p : positions) p = glm::vec3(glm::dvec3(random.uniform(), random.uniform(), random.uniform()));
    return Mesh(std::move(positions), std::move(start), std::move(corners));
}

// Of all pairs of faces at an edge the sharpest, whichever way they run along it.
TEST(EdgeDihedral, OfSoups)
{
    Random random(8);
    for (int soup = 0; soup < 1000; ++soup) {
        const Mesh mesh = soupOf(random);
        const Array<FaceMeasure> measures = faceMeasuresOf(mesh);
        std::map<std::pair<uint32_t, uint32_t>, std::vector<glm::dvec3>> normals;  // turned to run from the lower vertex
        for (size_t f = 0; f < mesh.faceCount(); ++f)
            for (size_t k = 0; k < mesh.face(f).size(); ++k) {
                const uint32_t a = mesh.face(f)[k], b = mesh.face(f)[(k + 1) % mesh.face(f).size()];
                if (a != b) normals[std::minmax({a, b})].push_back((a < b ? 1. : -1.) * (measures[f].area > 0 ? measures[f].normal : glm::dvec3(0)));
            }
        const Table t = table("edge-dihedral", mesh);
        ASSERT_EQ(t.edges.size(), 2 * normals.size());
        for (size_t e = 0; e < normals.size(); ++e) {
            double cosine = 2;
            const auto& at = normals.at({t.edges[2 * e], t.edges[2 * e + 1]});
            for (size_t i = 0; i < at.size(); ++i)
                for (size_t j = i + 1; j < at.size(); ++j)
                    if (at[i] != glm::dvec3(0) && at[j] != glm::dvec3(0)) cosine = std::min(cosine, -glm::dot(at[i], at[j]));
            ASSERT_NEAR(std::cos(t.columns[1].values[e] * pi / 180), std::min(cosine, 1.0), 1e-12) << "soup " << soup;
        }
    }
}

TEST(EdgeDihedral, AnglesAreThoseOfOpenMesh)
{
    using Tri = OpenMesh::TriMesh_ArrayKernelT<>;
    const Mesh mesh = bumpy();
    Tri peer;
    for (const glm::vec3& p : mesh.positions()) peer.add_vertex({p.x, p.y, p.z});
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        peer.add_face(Tri::VertexHandle(int(mesh.face(f)[0])), Tri::VertexHandle(int(mesh.face(f)[1])), Tri::VertexHandle(int(mesh.face(f)[2])));
    peer.request_face_normals();
    peer.update_face_normals();
    const Table t = table("edge-dihedral", mesh);
    for (size_t e = 0; e < t.edges.size() / 2; ++e) {
        const auto h = peer.find_halfedge(Tri::VertexHandle(int(t.edges[2 * e])), Tri::VertexHandle(int(t.edges[2 * e + 1])));
        ASSERT_TRUE(h.is_valid());
        EXPECT_NEAR(t.columns[1].values[e], std::abs(double(peer.calc_dihedral_angle(h))) * 180 / pi, 0.05);
        EXPECT_NEAR(t.columns[2].values[e], double(peer.calc_edge_length(h)), 1e-6);
    }
}

TEST(EdgeDihedral, BordersAndTurnedFacesAndThreeFaces)
{
    const Array<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
    const auto angleOfFirst = [&](Array<uint32_t> faces) {
        const Table t = table("edge-dihedral", Mesh::triangles(p, std::move(faces)));
        EXPECT_EQ(t.edges[0], 0u);
        EXPECT_EQ(t.edges[1], 1u);
        return t.columns[1].values[0];
    };
    EXPECT_EQ(angleOfFirst({0, 1, 2}), 0);                             // border
    EXPECT_NEAR(angleOfFirst({0, 1, 2, 1, 0, 3}), 0, 1e-6);            // flat
    EXPECT_NEAR(angleOfFirst({0, 1, 2, 0, 1, 3}), 0, 1e-6);            // flat, one turned round
    EXPECT_NEAR(angleOfFirst({0, 1, 2, 1, 0, 4}), 90, 1e-6);           // upright
    EXPECT_NEAR(angleOfFirst({0, 1, 2, 1, 0, 3, 0, 1, 4}), 90, 1e-6);  // three: the sharpest pair
}

// Planes at both ends of the edge of a unit box: halfway between them, a quarter each.
TEST(EdgeQuadric, OfABoxInClosedForm)
{
    const Mesh box = *meshOfSource("box:width=1,height=1,depth=1,segments=1");
    const Table t = table("edge-quadric", box);
    for (size_t e = 0; e < 12; ++e) {
        EXPECT_NEAR(t.columns[0].values[e], 0.5, 1e-9);
        EXPECT_EQ(t.columns[4].values[e], 1);
        const glm::dvec3 a = box.positions()[t.edges[2 * e]], b = box.positions()[t.edges[2 * e + 1]];
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(t.columns[size_t(k) + 1].values[e], 0.5 * (a[k] + b[k]), 1e-9);
    }
}

TEST(EdgeQuadric, PointsSolveTheNormalEquations)
{
    const Mesh mesh = bumpy();
    const Table t = table("edge-quadric", mesh);
    const Array<FaceMeasure> faces = faceMeasuresOf(mesh);
    size_t solved = 0;
    for (size_t e = 0; e < t.edges.size() / 2; ++e) {
        std::vector<uint32_t> planes;
        for (const uint32_t v : {t.edges[2 * e], t.edges[2 * e + 1]})
            for (const uint32_t c : mesh.rings().cornersOf(v)) planes.push_back(c / 3);
        Eigen::MatrixXd n(planes.size(), 3);
        Eigen::VectorXd d(planes.size());
        for (size_t i = 0; i < planes.size(); ++i) {
            const FaceMeasure& f = faces[planes[i]];
            for (int k = 0; k < 3; ++k) n(Eigen::Index(i), k) = f.normal[k];
            d(Eigen::Index(i)) = glm::dot(f.normal, f.centroid);
        }
        if (t.columns[4].values[e] == 0) continue;
        ++solved;
        const Eigen::Vector3d best = n.colPivHouseholderQr().solve(d);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(t.columns[size_t(k) + 1].values[e], best[k], 1e-6);
        EXPECT_NEAR(t.columns[0].values[e], (n * best - d).squaredNorm(), 1e-9);
    }
    EXPECT_GT(solved, 900u);
}

// In a plane p is free in two directions: the best of both ends and the middle is taken, and costs nothing.
TEST(EdgeQuadric, FlatPlacesKeepThePointNearTheEdge)
{
    const Mesh mesh = *meshOfSource("grid");
    const Table t = table("edge-quadric", mesh);
    for (size_t e = 0; e < t.edges.size() / 2; ++e) {
        EXPECT_EQ(t.columns[4].values[e], 0);
        EXPECT_NEAR(t.columns[0].values[e], 0, 1e-12);
    }
}

TEST(PointTriangle, AgreesWithWeightsAndWithTheClosestPoint)
{
    Random random(8);
    const auto any = [&] {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        return 4.0 * glm::dvec3(x, y, z) - 2.0;
    };
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 a = any(), b = any(), c = any(), p = any();
        const PointTriangle r = pointTriangle(p, a, b, c);
        EXPECT_NEAR(glm::dot(r.foot - a, r.normal), 0, 1e-9);
        EXPECT_NEAR(glm::distance(r.foot + r.distance * r.normal, p), 0, 1e-9);
        // (3.31): the coordinates are signed areas as shares of the whole, each t is one of them in another order.
        const double square = r.t.x + r.t.y + r.t.z;
        EXPECT_NEAR(r.weights.z, r.t.x / square, 1e-6);
        EXPECT_NEAR(r.weights.x, r.t.y / square, 1e-6);
        EXPECT_NEAR(r.weights.y, r.t.z / square, 1e-6);
        EXPECT_LT(glm::distance(r.weights.x * a + r.weights.y * b + r.weights.z * c, r.foot), 1e-5);
        EXPECT_EQ(r.inside, std::min({r.weights.x, r.weights.y, r.weights.z}) >= 0);
        inside += r.inside;
        if (r.inside) {
            EXPECT_NEAR(glm::distance(r.closest, r.foot), 0, 1e-7);
        } else {
            double least = 1e9;  // the nearest of the three segments
            for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
                least = std::min(least, glm::distance(p, u + closestOnSegment(p, u, v) * (v - u)));
            EXPECT_NEAR(glm::distance(r.closest, p), least, 1e-9);
        }
    }
    EXPECT_GT(inside, 100);
}

// (3.32), in the plane.
TEST(PointTriangle, CoordinatesAreThoseOfTheFormulaInThePlane)
{
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        glm::dvec2 p[4];
        for (glm::dvec2& q : p) {
            q.x = random.uniform();
            q.y = random.uniform();
        }
        const auto [a, b, c, q] = std::tuple(p[0], p[1], p[2], p[3]);
        const double d = (b.y - c.y) * (a.x - c.x) + (c.x - b.x) * (a.y - c.y);
        if (std::abs(d) < 1e-3) continue;
        const double l1 = ((b.y - c.y) * (q.x - c.x) + (c.x - b.x) * (q.y - c.y)) / d,
                     l2 = ((c.y - a.y) * (q.x - c.x) + (a.x - c.x) * (q.y - c.y)) / d;
        const glm::dvec3 w = barycentric({q, 0}, {a, 0}, {b, 0}, {c, 0});
        EXPECT_NEAR(w.x, l1, 1e-9);
        EXPECT_NEAR(w.y, l2, 1e-9);
        EXPECT_NEAR(w.z, 1 - l1 - l2, 1e-9);
    }
}

TEST(ClosestPointQuery, TellsWhatTheTriangleSays)
{
    const Mesh one = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, Array<uint32_t>{0, 1, 2});
    const Table above = table("closest-point", one, "point=0.5/0.5/3"), beyond = table("closest-point", one, "point=2/2/-1");
    EXPECT_NEAR(summary(above, "D"), 3, 1e-12);
    EXPECT_EQ(summary(above, "inside"), 1);
    EXPECT_NEAR(summary(above, "lambda2"), 0.25, 1e-12);
    EXPECT_NEAR(summary(beyond, "D"), -1, 1e-12);
    EXPECT_EQ(summary(beyond, "inside"), 0);
    EXPECT_NEAR(summary(beyond, "foot x"), 2, 1e-12);
    EXPECT_NEAR(summary(beyond, "x"), 1, 1e-12);
    EXPECT_NEAR(summary(beyond, "distance"), std::sqrt(3), 1e-12);
    EXPECT_LT(summary(beyond, "t2"), 0);
    EXPECT_THROW(table("closest-point", Mesh()), Error);
    const Table walk = table("closest-point", *meshOfSource("icosphere:subdivisions=6"), "point=0.4/1.2/0.6");
    EXPECT_LT(summary(walk, "triangles tried"), 200);  // of 81,920
}

Table distance(const Mesh& a, const Mesh& b, int64_t samples = 50000)
{
    const Operation& op = operation("distance");
    return std::get<Table>(apply(op, a, {{"samples", samples}}, nullptr, {{"other", b}}));
}

Mesh moved(const Mesh& mesh, const glm::dmat3& turn, const glm::dvec3& by)
{
    Array<glm::vec3> p;
    for (const glm::vec3& v : mesh.positions()) p.push_back(glm::vec3(turn * glm::dvec3(v) + by));
    return mesh.withPositions(std::move(p));
}

TEST(SurfaceDistance, OfParallelSquaresIsTheirDistance)
{
    const Mesh a = *meshOfSource("grid:width=1,depth=1"), b = moved(a, glm::dmat3(1), {0, 0.25, 0});
    const Table t = distance(a, b);
    for (const char* name : {"hausdorff", "rms", "mean", "hausdorff to other", "hausdorff from other", "rms to other", "rms from other"})
        EXPECT_NEAR(summary(t, name), 0.25, 1e-7) << name;
    EXPECT_NEAR(summary(t, "rms %"), 100 * 0.25 / std::sqrt(2), 1e-5);
    for (const double d : t.columns[1].values) EXPECT_NEAR(d, 0.25, 1e-7);
    EXPECT_NEAR(summary(distance(a, b, 0), "rms"), 0.25, 1e-7);  // over the vertices
}

// A unit square turned by 30 degrees about one side, above a plane: distances are spread evenly from 0 to a half.
TEST(SurfaceDistance, OfATiltedSquareAboveAPlane)
{
    const Mesh plane = *meshOfSource("grid:width=8,depth=8"), square = *meshOfSource("grid:width=1,depth=1,columns=7,rows=7");
    const double s = 0.5, c = std::sqrt(3) / 2;
    const Mesh tilted = moved(square, glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1), {0, 0.25, 0});
    const Table t = distance(tilted, plane);
    EXPECT_NEAR(summary(t, "hausdorff to other"), 0.5, 1e-6);
    EXPECT_NEAR(summary(t, "mean to other"), 0.25, 2e-4);
    EXPECT_NEAR(summary(t, "rms to other"), 0.5 / std::sqrt(3), 2e-4);
    EXPECT_GT(summary(t, "hausdorff from other"), 4.0);  // the plane's corners
}

TEST(SurfaceDistance, PointsAreSpreadByArea)
{
    const Mesh two =
        Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 9}, {1, 0, 9}, {0, 2, 9}}, Array<uint32_t>{0, 1, 2, 3, 4, 5});
    const Operation& op = operation("distance");
    const Table t = std::get<Table>(apply(op, two, {{"samples", int64_t(4000)}}, nullptr, {{"other", two}}));
    EXPECT_NEAR(summary(t, "hausdorff"), 0, 1e-12);
    EXPECT_EQ(summary(t, "points"), 8000);
    EXPECT_NEAR(summary(t, "spacing"), std::sqrt(4.0 / 4000), 1e-9);
    EXPECT_THROW(distance(two, Mesh()), Error);
    EXPECT_THROW(distance(Mesh(), two), Error);
}

// The border by its definition.
TEST(Border, IsTheEdgesOfOneFace)
{
    using Place = BorderNeighbours::Place;
    Random random(7);
    for (int soup = 0; soup < 3000; ++soup) {
        const Mesh mesh = soupOf(random);
        const uint32_t vertices = uint32_t(mesh.vertexCount()), faces = uint32_t(mesh.faceCount());
        std::map<std::pair<uint32_t, uint32_t>, int> sides;
        const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
        for (size_t f = 0; f < faces; ++f) {
            const auto face = mesh.face(f);
            for (size_t k = 0; k < face.size(); ++k)
                if (degenerate.empty() || !degenerate[f]) ++sides[std::minmax({face[k], face[(k + 1) % face.size()]})];
        }
        std::vector<std::vector<uint32_t>> along(vertices);
        for (const auto& [edge, count] : sides) {
            if (count != 1) continue;
            along[edge.first].push_back(edge.second);
            along[edge.second].push_back(edge.first);
        }
        const BorderNeighbours border = borderNeighboursOf(mesh);
        for (uint32_t v = 0; v < vertices; ++v) {
            const size_t n = along[v].size();
            ASSERT_EQ(border.place[v], n == 0 ? Place::Inside : n > 2 ? Place::Branch : Place::Border) << "soup " << soup;
            for (size_t k = 0; k < 2; ++k) ASSERT_EQ(border.neighbour[2 * v + k], k < n ? along[v][k] : none) << "soup " << soup;
        }
    }
}

}  // namespace
}  // namespace mw
