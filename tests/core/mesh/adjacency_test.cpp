// The nine queries against a look at every face, on regular, broken and real meshes; the walk of listing 2.1; iterators; the records of the three
// structures; the triangle-adjacency primitive.
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/error.h"
#include "core/io/io.h"
#include "core/mesh/iterate.h"
#include "core/mesh/one_ring_walk.h"
#include "core/mesh/records.h"
#include "core/mesh/select.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangle_adjacency.h"
#include "core/steps/stepper.h"

#include "data.h"
#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

using Query = Adjacency::Query;
using Pair = std::pair<uint32_t, uint32_t>;

template <class Out, class P>
Out result(const Mesh& mesh, Generator (*algorithm)(Mesh, P, Stage<Out>&), const P& parameters)
{
    RunOf<Out> run(false, [&](Stage<Out>& s) { return algorithm(mesh, parameters, s); });
    while (run.advance()) continue;
    return std::any_cast<Out>(run.snapshot().value);
}

template <class Out, class P>
Stepper stepper(const Mesh& mesh, Generator (*algorithm)(Mesh, P, Stage<Out>&), const P& parameters)
{
    return Stepper([=](bool watched) -> std::unique_ptr<mw::Run> {
        return std::make_unique<RunOf<Out>>(watched, [&](Stage<Out>& s) { return algorithm(mesh, parameters, s); });
    });
}

ElementSet asked(const Mesh& mesh, Query query, const std::string& element, int64_t ring = 1, bool acrossVertices = false)
{
    return result<ElementSet>(mesh, adjacency, Adjacency{query, element, ring, acrossVertices});
}

std::set<Pair> sidesOf(std::span<const uint32_t> face)
{
    std::set<Pair> out;
    for (size_t i = 0; i < face.size(); ++i) {
        const Pair p = std::minmax(face[i], face[(i + 1) % face.size()]);
        if (p.first != p.second) out.insert(p);
    }
    return out;
}

/// What a query must find, from the definitions alone: every face is looked at.
ElementSet everyFaceAsked(const Mesh& mesh, Query query, Pair element, bool acrossVertices)
{
    std::set<uint32_t> ends{element.first, element.second}, found;
    std::set<Pair> edges;
    const bool ofFace = askedKind(query) == ElementKind::Face, ofEdge = askedKind(query) == ElementKind::Edge;
    const std::set<Pair> own = ofFace ? sidesOf(mesh.face(element.first)) : std::set<Pair>{element};
    if (ofFace) ends = {mesh.face(element.first).begin(), mesh.face(element.first).end()};
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        const bool touches = std::any_of(face.begin(), face.end(), [&](uint32_t v) { return ends.contains(v); });
        if (!touches) continue;
        const std::set<Pair> sides = sidesOf(face);
        const bool shares = std::any_of(sides.begin(), sides.end(), [&](const Pair& s) { return own.contains(s); });
        const bool hit = ofFace ? f == element.first : ofEdge ? shares : true;
        if (foundKind(query) == ElementKind::Face) {
            if (ofFace ? f != element.first && (acrossVertices || shares) : hit) found.insert(f);
        } else if (foundKind(query) == ElementKind::Edge) {
            for (const Pair& s : sides)
                if (ofFace ? hit : s != element && (ends.contains(s.first) || ends.contains(s.second))) edges.insert(s);
        } else if (ofFace) {
            if (hit) found.insert(face.begin(), face.end());
        } else if (ofEdge) {
            found = ends;
        } else {
            for (const Pair& s : sides)
                if (ends.contains(s.first) != ends.contains(s.second)) found.insert(ends.contains(s.first) ? s.second : s.first);
        }
    }
    ElementSet out{foundKind(query), {found.begin(), found.end()}};
    for (const Pair& e : edges) out.indices.insert(out.indices.end(), {e.first, e.second});
    return out;
}

std::string textOf(ElementKind kind, Pair element)
{
    return kind == ElementKind::Edge ? std::to_string(element.first) + "~" + std::to_string(element.second) : std::to_string(element.first);
}

/// A few of each kind: the first, the last, some between, and what is odd about the mesh.
std::vector<Pair> samples(const Mesh& mesh, ElementKind kind, std::mt19937& random)
{
    const TopologyReport& r = mesh.topology();
    std::vector<Pair> out;
    const auto add = [&](uint32_t i) { out.push_back({i, i}); };
    if (kind == ElementKind::Edge) {
        const auto& e = mesh.edges();
        for (int i = 0; i < 3 && !e.empty(); ++i) {
            const size_t k = random() % (e.size() / 2);
            out.push_back({e[2 * k], e[2 * k + 1]});
        }
        for (size_t i = 0; i < std::min<size_t>(2, r.nonmanifoldEdges.size()); ++i) out.push_back(r.nonmanifoldEdges[i]);
        if (const ElementSet border = boundary(mesh, ElementKind::Edge); !border.indices.empty())
            out.push_back({border.indices[0], border.indices[1]});
        return out;
    }
    const size_t n = kind == ElementKind::Vertex ? mesh.vertexCount() : mesh.faceCount();
    for (int i = 0; i < 3 && n > 0; ++i) add(uint32_t(random() % n));
    const auto& odd = kind == ElementKind::Vertex ? r.nonmanifoldVertices : r.degenerateFaces;
    for (size_t i = 0; i < std::min<size_t>(2, odd.size()); ++i) add(odd[i]);
    if (kind == ElementKind::Vertex && !r.nonmanifoldEdges.empty()) add(r.nonmanifoldEdges[0].first);
    if (kind == ElementKind::Vertex && !r.boundaryLoops.empty()) add(r.boundaryLoops[0][0]);
    if (kind == ElementKind::Vertex && !r.isolatedVertices.empty()) add(r.isolatedVertices[0]);
    if (kind == ElementKind::Face && !odd.empty())  // a neighbour of a degenerate face
        for (const uint32_t v : mesh.face(odd[0]))
            for (uint32_t f = 0; f < mesh.faceCount() && out.size() < 12; ++f)
                if (std::ranges::find(mesh.face(f), v) != mesh.face(f).end()) add(f);
    return out;
}

void expectRightAnswers(const Mesh& mesh, std::mt19937& random)
{
    for (int q = 0; q < 9; ++q) {
        const Query query = Query(q);
        for (const Pair& e : samples(mesh, askedKind(query), random))
            for (const bool acrossVertices : {false, true}) {
                if (acrossVertices && query != Query::FaceFaces) continue;
                const ElementSet own = asked(mesh, query, textOf(askedKind(query), e), 1, acrossVertices);
                ASSERT_EQ(own.kind, foundKind(query));
                ASSERT_EQ(own.indices, everyFaceAsked(mesh, query, e, acrossVertices).indices)
                    << "query " << q << " of " << e.first << ", " << e.second << (acrossVertices ? " across vertices" : "");
            }
    }
}

template <class Body>
void forDataMeshes(const std::filesystem::path& data, const Body& body)
{
    size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "meshes")) {
        static const std::set<std::string> endings{".off", ".obj", ".ply", ".stl"};
        if (!endings.contains(entry.path().extension().string())) continue;
        SCOPED_TRACE(entry.path().filename().string());
        const Imported read = readFile(entry.path());
        for (const MeshId id : read.scene.meshes()) {
            body(read.scene.find(id)->base);
            ++count;
        }
    }
    EXPECT_GT(count, 55u);
}

}  // namespace

TEST(Adjacency, RegularMeshHasTheNumbersOfTheTable)
{
    const Mesh torus = grid(12, true, false).mesh();
    const size_t expected[] = {6, 6, 6, 2, 10, 2, 3, 3, 3};
    for (int q = 0; q < 9; ++q) {
        const std::string element = askedKind(Query(q)) == ElementKind::Edge ? "0~1" : "17";
        EXPECT_EQ(countOf(asked(torus, Query(q), element)), expected[q]) << "query " << q;
    }
    EXPECT_EQ(countOf(asked(torus, Query::FaceFaces, "17", 1, true)), 12u);
    EXPECT_EQ(countOf(asked(torus, Query::VertexVertices, "17", 2)), 18u);  // 6, and 12 more
    EXPECT_EQ(countOf(asked(torus, Query::VertexVertices, "17", 3)), 36u);
}

TEST(Adjacency, WalksAsOftenAsThereAreNeighbours)
{
    const Mesh torus = grid(12, true, false).mesh();
    const std::pair<Query, const char*> walks[] = {{Query::VertexFaces, "about"}, {Query::FaceEdges, "round"}, {Query::EdgeFaces, "halves"}};
    for (const auto& [query, phase] : walks) {
        Stepper s = stepper<ElementSet>(torus, adjacency, Adjacency{query, query == Query::EdgeFaces ? "0~1" : "17"});
        const HalfedgeWalk walk(torus);
        size_t steps = 0;
        uint32_t expected = none;
        while (s.forward() && !s.atEnd()) {
            if (s.step().phase != phase) continue;
            ++steps;
            std::map<std::string, double> n;
            for (const Number& number : s.step().numbers) n[number.name] = number.value;
            const uint32_t h = uint32_t(n["half-edge"]);
            if (expected != none) {
                EXPECT_EQ(h, expected);  // each step goes where the one before said
            }
            expected = uint32_t(n["next"]);
            EXPECT_EQ(walk.source(h), n["from"]);
            EXPECT_EQ(walk.target(h), n["to"]);
            EXPECT_EQ(n["outcome"], 0);
            EXPECT_EQ(n["found"], steps);
        }
        EXPECT_EQ(steps, countOf(asked(torus, query, query == Query::EdgeFaces ? "0~1" : "17")));
    }
}

TEST(Adjacency, RingsAreThoseOfTheDistance)
{
    const Mesh open = grid(9, false, true).mesh();
    for (const uint32_t v : {0u, 5u, 44u}) {
        ElementSet ball{ElementKind::Vertex, {v}};
        for (int64_t ring = 1; ring <= 4; ++ring) {
            ball = grown(open, ball);
            ElementSet around = without(ball, {ElementKind::Vertex, {v}});
            EXPECT_EQ(asked(open, Query::VertexVertices, std::to_string(v), ring).indices, around.indices);
        }
    }
}

TEST(Adjacency, BrokenMeshesAreAnsweredInFull)
{
    std::mt19937 random(3);
    for (int round = 0; round < 40; ++round) {
        Polygons soup = Polygons::points(9);
        for (int f = 0; f < 12; ++f) {
            const uint32_t n = 2 + random() % 4;
            for (uint32_t i = 0; i < n; ++i) soup.corners.push_back(uint32_t(random() % 9));
            soup.start.push_back(uint32_t(soup.corners.size()));
        }
        SCOPED_TRACE(round);
        expectRightAnswers(soup.mesh(), random);
    }
}

TEST(Adjacency, DataMeshesAreAnsweredAsEveryFaceSays)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    std::mt19937 random(5);
    forDataMeshes(data, [&](const Mesh& mesh) { expectRightAnswers(mesh, random); });
}

TEST(Adjacency, WhatIsNotThereIsExplained)
{
    const Mesh m = cube().mesh();
    EXPECT_THROW(asked(m, Query::VertexFaces, "8"), Error);
    EXPECT_THROW(asked(m, Query::VertexFaces, "1-3"), Error);
    EXPECT_THROW(asked(m, Query::VertexFaces, ""), Error);
    EXPECT_THROW(asked(m, Query::EdgeFaces, "0~7"), Error);  // a diagonal
    EXPECT_THROW(asked(m, Query::EdgeFaces, "3"), Error);
    EXPECT_THROW(asked(Mesh(), Query::FaceFaces, "0"), Error);
}

TEST(Iterate, SumsAreThoseOfTheMesh)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    forDataMeshes(data, [&](const Mesh& mesh) {
        if (mesh.faceCount() > 200'000) return;
        const TopologyReport& r = mesh.topology();
        const auto sum = [](const Table& t) { return t.summary.at(1).second; };
        EXPECT_EQ(sum(result<Table>(mesh, iterate, Iterate{Iterate::Elements::Vertices})), 2. * double(r.edges));
        EXPECT_EQ(sum(result<Table>(mesh, iterate, Iterate{Iterate::Elements::Faces})), double(mesh.cornerCount()));
        EXPECT_EQ(result<Table>(mesh, iterate, Iterate{Iterate::Elements::Vertices}).columns[0].values.size(), mesh.vertexCount());
    });
}

TEST(Iterate, CubeEdgesBendByARightAngle)
{
    const Table t = result<Table>(cube().mesh(), iterate, Iterate{Iterate::Elements::Edges});
    ASSERT_EQ(t.columns[0].values.size(), 12u);
    for (size_t e = 0; e < 12; ++e) {
        EXPECT_NEAR(t.columns[0].values[e], 90, 1e-12);
        EXPECT_EQ(t.columns[1].values[e], 1);
    }
    Polygons inside = cube();
    for (size_t f = 0; f < 6; ++f) std::reverse(inside.corners.begin() + std::ptrdiff_t(4 * f), inside.corners.begin() + std::ptrdiff_t(4 * f + 4));
    const Table hollow = result<Table>(inside.mesh(), iterate, Iterate{Iterate::Elements::Edges});
    for (const double bend : hollow.columns[0].values) EXPECT_NEAR(bend, -90, 1e-12);
    const Table open = result<Table>(grid(2, false, true).mesh(), iterate, Iterate{Iterate::Elements::Edges});
    EXPECT_EQ(std::ranges::count_if(open.columns[0].values, [](double v) { return std::isnan(v); }), 8);
}

TEST(Iterate, HalfedgesAreADoublyLinkedList)
{
    const Table t = result<Table>(grid(4, false, false).mesh(), iterate, Iterate{Iterate::Elements::Halfedges});
    const auto at = [&](size_t column, size_t h) { return t.columns[column].values[h]; };
    for (size_t h = 0; h < t.columns[0].values.size(); ++h) {
        const size_t next = size_t(at(3, h)), pair = size_t(at(5, h));
        EXPECT_EQ(at(4, next), h);
        EXPECT_EQ(at(5, pair), h);
        EXPECT_EQ(at(1, h), at(0, next));
        EXPECT_EQ(at(0, pair), at(1, h));
        EXPECT_TRUE(at(2, h) == at(2, next) || (std::isnan(at(2, h)) && std::isnan(at(2, next))));
    }
}

namespace {

struct WalkCount {
    size_t triangles = 0, vertices = 0, refusals = 0, boundaries = 0;
};

WalkCount walked(const Mesh& mesh, uint32_t vertex)
{
    WalkCount c;
    Stepper s = stepper<ElementSet>(mesh, oneRingWalk, OneRingWalk{vertex, -1});
    while (s.forward() && !s.atEnd()) {
        c.triangles += s.step().phase == "start" || s.step().phase == "visit";
        c.refusals += s.step().phase == "refuse";
        c.boundaries += s.step().phase == "boundary";
        for (const Number& n : s.step().numbers)
            if (std::string(n.name) == "new") c.vertices += size_t(n.value);
    }
    return c;
}

}  // namespace

TEST(OneRingWalk, ValenceKTakesKTrianglesVerticesAndRefusals)
{
    const Mesh torus = grid(9, true, false).mesh(), sheet = grid(6, false, false).mesh();
    const WalkCount inside = walked(torus, 31);
    EXPECT_EQ(inside.triangles, 6u);
    EXPECT_EQ(inside.vertices, 6u);
    EXPECT_EQ(inside.refusals, 6u);
    EXPECT_EQ(inside.boundaries, 0u);
    const WalkCount border = walked(sheet, 3);
    EXPECT_EQ(border.triangles, 3u);
    EXPECT_EQ(border.vertices, 4u);
    EXPECT_EQ(border.boundaries, 2u);
}

TEST(OneRingWalk, FindsTheRingWhereverItIsOneFan)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    std::mt19937 random(7);
    forDataMeshes(data, [&](const Mesh& mesh) {
        if (!mesh.isTriangles() || !mesh.topology().manifold() || !mesh.topology().degenerateFaces.empty()) return;
        if (!mesh.topology().consistentlyOriented || mesh.faceCount() == 0) return;
        for (int i = 0; i < 3; ++i) {
            const uint32_t v = mesh.cornerVertex()[random() % mesh.cornerCount()];
            EXPECT_EQ(result<ElementSet>(mesh, oneRingWalk, OneRingWalk{v, -1}).indices,
                      asked(mesh, Query::VertexVertices, std::to_string(v)).indices);
        }
    });
}

TEST(OneRingWalk, WhatItCannotWalkIsExplained)
{
    const Mesh torus = grid(9, true, false).mesh();
    EXPECT_THROW(result<ElementSet>(cube().mesh(), oneRingWalk, OneRingWalk{0, -1}), Error);
    EXPECT_THROW(result<ElementSet>(torus, oneRingWalk, OneRingWalk{81, -1}), Error);
    EXPECT_THROW(result<ElementSet>(torus, oneRingWalk, OneRingWalk{0, 162}), Error);
    EXPECT_THROW(result<ElementSet>(torus, oneRingWalk, OneRingWalk{0, 80}), Error);  // has other vertices
}

namespace {

uint32_t field(const Record& r, const std::string& name)
{
    for (const Record::Field& f : r.fields)
        if (f.name == name) return f.link.to == RecordLink::To::Nothing ? none : f.link.index;
    ADD_FAILURE() << "no field " << name;
    return none;
}

}  // namespace

// Figure 2.9: clockwise on both faces; a and d meet the edge at Q, b and c at P.
TEST(Records, WingedEdgeIsClockwiseOnBothFaces)
{
    for (const Mesh& mesh : {grid(7, true, false).mesh(), grid(7, true, true).mesh(), grid(4, false, true).mesh()}) {
        const HalfedgeWalk walk(mesh);
        const auto has = [&](uint32_t edge, uint32_t v) { return walk.source(2 * edge) == v || walk.target(2 * edge) == v; };
        const auto isSideOf = [&](uint32_t edge, uint32_t face) {
            return sidesOf(mesh.face(face)).contains(std::minmax(walk.source(2 * edge), walk.target(2 * edge)));
        };
        for (uint32_t e = 0; e < walk.size() / 2; ++e) {
            const Record r = wingedEdgeRecord(walk, e);
            const uint32_t p = field(r, "start"), q = field(r, "end"), left = field(r, "left"), right = field(r, "right");
            // The left face has P before Q, anticlockwise; the right one Q before P.
            for (const auto& [face, from, to] : {std::tuple(left, p, q), std::tuple(right, q, p)}) {
                if (face == none) continue;
                const auto f = mesh.face(face);
                const size_t at = size_t(std::ranges::find(f, from) - f.begin());
                EXPECT_EQ(f[(at + 1) % f.size()], to);
            }
            const std::tuple<const char*, uint32_t, uint32_t> wings[] = {
                {"left_prev", left, q}, {"left_next", left, p}, {"right_prev", right, p}, {"right_next", right, q}};
            for (const auto& [name, face, end] : wings) {
                const uint32_t wing = field(r, name);
                EXPECT_EQ(wing == none, face == none);
                if (face == none) continue;
                EXPECT_NE(wing, e);
                EXPECT_TRUE(has(wing, end)) << name;
                EXPECT_TRUE(isSideOf(wing, face)) << name;
            }
        }
    }
}

TEST(Records, HalfedgesAndFacesNameTheirNeighbours)
{
    const Mesh mesh = grid(5, false, false).mesh();
    const HalfedgeWalk walk(mesh);
    for (uint32_t h = 0; h < walk.size(); ++h) {
        const Record r = halfedgeRecord(walk, h), pair = halfedgeRecord(walk, field(r, "pair"));
        EXPECT_EQ(field(pair, "pair"), h);
        EXPECT_EQ(field(halfedgeRecord(walk, field(r, "next")), "prev"), h);
        EXPECT_EQ(field(halfedgeRecord(walk, field(r, "next")), "face"), field(r, "face"));
        EXPECT_EQ(field(r, "vert"), field(halfedgeRecord(walk, walk.pair(field(r, "next"))), "vert"));
    }
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const Record r = faceRecord(walk, mesh, f);
        ASSERT_EQ(r.fields.size(), 6u);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(field(r, "p" + std::to_string(k + 1)), mesh.face(f)[size_t(k)]);
            const uint32_t t = field(r, "t" + std::to_string(k + 1));
            const Pair side = std::minmax(mesh.face(f)[size_t(k)], mesh.face(f)[size_t(k + 1) % 3]);
            if (t != none) {
                EXPECT_TRUE(sidesOf(mesh.face(t)).contains(side));
            } else {
                EXPECT_EQ(asked(mesh, Query::EdgeFaces, textOf(ElementKind::Edge, side)).indices.size(), 1u);
            }
        }
        EXPECT_EQ(field(halfedgeRecord(walk, field(halfedgeFaceRecord(walk, f), "edge")), "face"), f);
    }
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(walk.source(field(halfedgeVertexRecord(walk, v), "edge")), v);
}

TEST(Records, PlacesAreFoundFromAnyElement)
{
    Polygons p = grid(3, false, false);
    p.positions.emplace_back(9.f, 9.f, 9.f);
    const Mesh mesh = p.face({0, 0, 1}).mesh();
    const HalfedgeWalk walk(mesh);
    using To = RecordLink::To;
    for (uint32_t h = 0; h < walk.size(); ++h) {
        const RecordPlace place = placeOf(walk, {To::Halfedge, h});
        EXPECT_EQ(place.halfedge, h);
        EXPECT_EQ(place.vertex, walk.source(h));
        EXPECT_NE(place.face, none);
        EXPECT_EQ(placeOfEdge(walk, walk.source(h), walk.target(h)).halfedge, h);
    }
    EXPECT_EQ(placeOf(walk, {To::Vertex, 16}).halfedge, none);  // stands alone
    EXPECT_EQ(placeOf(walk, {To::Vertex, 16}).vertex, 16u);
    EXPECT_EQ(placeOf(walk, {To::Face, 18}).halfedge, none);  // degenerate
    EXPECT_EQ(placeOf(walk, {To::Face, 18}).face, 18u);
    EXPECT_EQ(faceRecord(walk, mesh, 18).fields.size(), 6u);
    EXPECT_EQ(placeOfEdge(walk, 0, 15).halfedge, none);
}

TEST(TriangleAdjacency, SixVerticesAreThoseOfTheFigure)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    forDataMeshes(data, [&](const Mesh& mesh) {
        if (!mesh.isTriangles() || !mesh.topology().manifold() || !mesh.topology().degenerateFaces.empty()) return;
        if (!mesh.topology().consistentlyOriented || !mesh.topology().duplicateFaces.empty()) return;
        const Array<uint32_t> six = adjacencyIndices(mesh);
        ASSERT_EQ(six.size(), 6 * mesh.faceCount());
        const HalfedgeWalk walk(mesh);
        size_t missing = 0;
        for (uint32_t f = 0; f < mesh.faceCount(); f += 1 + uint32_t(mesh.faceCount() / 5000)) {
            uint32_t h = walk.next(walk.ofFace(f));
            for (int k = 0; k < 3; ++k, h = walk.next(h)) {
                const uint32_t* v = &six[6 * size_t(f) + size_t(2 * k)];
                ASSERT_EQ(v[0], mesh.face(f)[size_t(k)]);
                const uint32_t g = walk.pair(h);
                ASSERT_EQ(v[1], walk.face(g) == none ? v[0] : walk.target(walk.next(g)));
            }
        }
        for (size_t i = 0; i < six.size(); i += 2) missing += six[i] == six[i + 1];
        EXPECT_EQ(missing, mesh.topology().boundaryEdges);
    });
}

// Triangles beside triangles and polygons, convex and not: one face by its half-edges is what the table of all has.
TEST(TriangleAdjacency, OfOneFaceBesidePolygons)
{
    // Four triangles round a point, a square on the right, a concave pentagon above; nothing below and on the left.
    const Array<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},       {0.5f, 0.5f, 0},
                                     {2, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1.2f, 0}, {1, 2, 0}};
    const Array<uint32_t> start{0, 3, 6, 9, 12, 16, 21}, corners{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 5, 6, 2, 2, 9, 8, 7, 3};
    const Mesh mixed(positions, start, corners);
    std::vector<Mesh> meshes{mixed};
    if (const auto data = mw::test::dataFolder(); !data.empty())
        forDataMeshes(data, [&](const Mesh& mesh) {
            if (!mesh.isTriangles() && mesh.topology().manifold() && mesh.topology().consistentlyOriented) meshes.push_back(mesh);
        });
    size_t compared = 0;
    for (const Mesh& mesh : meshes) {
        if (!mesh.topology().degenerateFaces.empty() || !mesh.topology().duplicateFaces.empty()) continue;
        const HalfedgeWalk walk(mesh);
        const Array<uint32_t> six = adjacencyIndices(mesh);
        const auto& faces = mesh.triangulation().faces;
        for (size_t t = 0; t < faces.size(); ++t) {
            if (mesh.face(faces[t]).size() != 3) continue;
            const auto own = adjacencyOf(walk, mesh, faces[t]);
            ASSERT_TRUE(own);
            ASSERT_TRUE(std::equal(own->begin(), own->end(), six.begin() + ptrdiff_t(6 * t))) << "triangle " << t;
            ++compared;
        }
    }
    EXPECT_GE(compared, 4u);
}

TEST(TriangleAdjacency, TableCountsWhatIsMissing)
{
    const Table t = result<Table>(grid(4, false, false).mesh(), triangleAdjacency, TriangleAdjacency{});
    EXPECT_EQ(t.rows, ElementKind::Face);
    EXPECT_EQ(t.summary[2].second, 16);
    ASSERT_EQ(t.columns.size(), 7u);
    const Table quads = result<Table>(cube().mesh(), triangleAdjacency, TriangleAdjacency{});
    EXPECT_EQ(quads.rows, ElementKind::Object);
    EXPECT_EQ(quads.columns[0].values.size(), 12u);
    EXPECT_EQ(quads.summary[2].second, 0);
}

// A tip that every side meets: the lists of open sides would take the square of their number.
TEST(TriangleAdjacency, FanOfManyTrianglesTakesNoSquare)
{
    const uint32_t n = 200'000;
    Array<glm::vec3> positions(n + 1, glm::vec3(0));
    for (uint32_t i = 1; i <= n; ++i) positions[i] = {std::cos(float(i)), std::sin(float(i)), 0};
    Array<uint32_t> indices;
    std::vector<uint32_t> order(n);
    for (uint32_t i = 0; i < n; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    for (const uint32_t i : order) indices.insert(indices.end(), {0u, i + 1, (i + 1) % n + 1});
    const Array<uint32_t> six = adjacencyIndices(Mesh::triangles(positions, indices));
    size_t missing = 0;
    for (size_t i = 0; i < six.size(); i += 2) missing += six[i] == six[i + 1];
    EXPECT_EQ(missing, n);  // the rim
}
