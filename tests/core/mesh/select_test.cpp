// Sets of elements against brute force and closed forms: text and back, set operations, growth, loops, regions.
#include "core/mesh/select.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/error.h"
#include "core/mesh/topology.h"

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

using Indices = std::vector<uint32_t>;

ElementSet vertices(Indices i)
{
    return {ElementKind::Vertex, std::move(i)};
}

ElementSet faces(Indices i)
{
    return {ElementKind::Face, std::move(i)};
}

ElementSet edge(uint32_t a, uint32_t b)
{
    return {ElementKind::Edge, {std::min(a, b), std::max(a, b)}};
}

// What an element of each kind is made of: its vertices. A set as a set of vertex lists.
using Elements = std::set<std::vector<uint32_t>>;

Elements elementsOf(const ElementSet& s)
{
    Elements out;
    const size_t n = s.kind == ElementKind::Edge ? 2 : 1;
    for (size_t i = 0; i < s.indices.size(); i += n) out.insert(Indices(s.indices.begin() + long(i), s.indices.begin() + long(i + n)));
    EXPECT_EQ(out.size(), countOf(s)) << "each once";
    return out;
}

Elements allOf(const Mesh& m, ElementKind kind)
{
    Elements out;
    if (kind == ElementKind::Vertex)
        for (uint32_t v = 0; v < m.vertexCount(); ++v) out.insert({v});
    for (uint32_t f = 0; f < m.faceCount(); ++f) {
        if (kind == ElementKind::Face) out.insert({f});
        const auto v = m.face(f);
        for (size_t i = 0; kind == ElementKind::Edge && i < v.size(); ++i)
            if (v[i] != v[(i + 1) % v.size()]) out.insert({std::min(v[i], v[(i + 1) % v.size()]), std::max(v[i], v[(i + 1) % v.size()])});
    }
    return out;
}

std::set<uint32_t> verticesOf(const Mesh& m, ElementKind kind, const std::vector<uint32_t>& element)
{
    if (kind != ElementKind::Face) return {element.begin(), element.end()};
    return {m.face(element[0]).begin(), m.face(element[0]).end()};
}

// Do two elements of one kind touch: by a vertex, vertices by an edge.
bool touch(const Mesh& m, ElementKind kind, const std::vector<uint32_t>& a, const std::vector<uint32_t>& b, const Elements& edges)
{
    if (kind == ElementKind::Vertex) return a == b || edges.count({std::min(a[0], b[0]), std::max(a[0], b[0])});
    const auto x = verticesOf(m, kind, a), y = verticesOf(m, kind, b);
    return std::any_of(x.begin(), x.end(), [&](uint32_t v) { return y.count(v) > 0; });
}

// A soup of few vertices: edges of many faces, faces of two corners, repeated vertices, loose vertices.
Mesh soup(std::mt19937& random)
{
    Polygons p = Polygons::points(6 + random() % 10);
    const uint32_t n = uint32_t(p.positions.size());
    for (uint32_t f = random() % 12; f > 0; --f) {
        const uint32_t a = random() % n, b = random() % n, c = random() % n, d = random() % n;
        if (random() % 3 == 0)
            p.face({a, b, c, d});
        else if (random() % 8 == 0)
            p.face({a, b});
        else
            p.face({a, b, c});
    }
    return p.mesh();
}

ElementSet randomPart(const Mesh& m, ElementKind kind, std::mt19937& random)
{
    ElementSet s{kind, {}};
    for (const auto& e : allOf(m, kind))
        if (random() % 3 == 0) s.indices.insert(s.indices.end(), e.begin(), e.end());
    return s;
}

constexpr ElementKind kinds[] = {ElementKind::Vertex, ElementKind::Edge, ElementKind::Face};

double millisecondsOf(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST(ElementText, RangesAreCompact)
{
    EXPECT_EQ(elementText(vertices({})), "");
    EXPECT_EQ(elementText(vertices({7})), "7");
    EXPECT_EQ(elementText(vertices({0, 1, 2, 3, 9, 20, 21})), "0-3;9;20-21");
    EXPECT_EQ(elementText({ElementKind::Edge, {3, 7, 3, 9, 4, 5}}), "3~7;3~9;4~5");
}

TEST(ElementText, AnyOrderAndRepetitionGiveTheSet)
{
    EXPECT_EQ(parsedElements(ElementKind::Face, "9;0-3;2-5;9;;1").indices, (Indices{0, 1, 2, 3, 4, 5, 9}));
    EXPECT_EQ(parsedElements(ElementKind::Edge, "9~3;3~7;7~3").indices, (Indices{3, 7, 3, 9}));
    EXPECT_TRUE(parsedElements(ElementKind::Vertex, "").indices.empty());
}

TEST(ElementText, RandomSetsComeBack)
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::set<uint32_t> indices;
        std::set<std::pair<uint32_t, uint32_t>> edges;
        const uint32_t n = 1 + random() % 300;
        for (uint32_t i = random() % 200; i > 0; --i) indices.insert(random() % n);
        for (uint32_t i = random() % 50; i > 0; --i)
            if (const uint32_t a = random() % n, b = random() % n; a != b) edges.insert(std::minmax(a, b));
        const ElementSet set{round % 2 ? ElementKind::Face : ElementKind::Vertex, Indices(indices.begin(), indices.end())};
        ElementSet pairs{ElementKind::Edge, {}};
        for (const auto& [a, b] : edges) pairs.indices.push_back(a), pairs.indices.push_back(b);
        EXPECT_EQ(parsedElements(set.kind, elementText(set), n).indices, set.indices);
        EXPECT_EQ(parsedElements(ElementKind::Edge, elementText(pairs), n).indices, pairs.indices);
        EXPECT_EQ(elementText(set).find_first_of(",+ "), std::string::npos);
    }
}

TEST(ElementText, WhatDoesNotFitIsNamed)
{
    const auto refused = [](ElementKind kind, const std::string& text, const std::string& word) {
        try {
            parsedElements(kind, text, 100);
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    refused(ElementKind::Vertex, "3;100", "\"100\"");
    refused(ElementKind::Vertex, "0-4294967295", "below 100");
    refused(ElementKind::Vertex, "99999999999999999999", "below 100");
    refused(ElementKind::Vertex, "5-2", "backwards");
    refused(ElementKind::Vertex, "1,2", "no index");
    refused(ElementKind::Vertex, "-5", "no index");
    refused(ElementKind::Vertex, "5-", "no index");
    refused(ElementKind::Vertex, "+5", "no index");
    refused(ElementKind::Vertex, "3~7", "no index");
    refused(ElementKind::Edge, "5", "no edge");
    refused(ElementKind::Edge, "5~5", "the same");
    refused(ElementKind::Edge, "5~6~7", "no index");
    refused(ElementKind::Corner, "5", "only vertices");
}

TEST(ElementText, OverlappingRangesCostNothing)
{
    std::string text;
    for (int i = 0; i < 20000; ++i) text += "0-999999;";
    EXPECT_EQ(parsedElements(ElementKind::Vertex, text, 1'000'000).indices.size(), 1'000'000u);
}

TEST(ElementSets, OperationsAgreeWithStdSet)
{
    std::mt19937 random(2);
    for (int round = 0; round < 300; ++round) {
        const Mesh m = soup(random);
        const ElementKind kind = kinds[round % 3];
        const ElementSet a = randomPart(m, kind, random), b = randomPart(m, kind, random);
        const Elements x = elementsOf(a), y = elementsOf(b);
        Elements both = x, less, either;
        both.insert(y.begin(), y.end());
        std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::inserter(less, less.end()));
        std::set_symmetric_difference(x.begin(), x.end(), y.begin(), y.end(), std::inserter(either, either.end()));
        EXPECT_EQ(elementsOf(united(a, b)), both);
        EXPECT_EQ(elementsOf(without(a, b)), less);
        EXPECT_EQ(elementsOf(toggled(a, b)), either);
        EXPECT_EQ(elementsOf(allElements(m, kind)), allOf(m, kind));
        EXPECT_EQ(inverted(m, a).indices, without(allElements(m, kind), a).indices);
    }
}

TEST(ElementSets, GatheredInAnyOrder)
{
    EXPECT_EQ(sorted(vertices({5, 1, 5, 0})).indices, (Indices{0, 1, 5}));
    EXPECT_EQ(sorted(vertices({4000000000u, 1, 1})).indices, (Indices{1, 4000000000u}));
    EXPECT_EQ(sorted({ElementKind::Edge, {9, 2, 1, 3, 2, 9, 4, 4}}).indices, (Indices{1, 3, 2, 9}));
    EXPECT_EQ(sorted({ElementKind::Edge, {4000000000u, 2, 3999999999u, 4000000000u}}).indices, (Indices{2, 4000000000u, 3999999999u, 4000000000u}));
    EXPECT_TRUE(sorted(vertices({})).indices.empty());
    std::mt19937 random(3);
    ElementSet many{ElementKind::Edge, {}};
    std::set<std::vector<uint32_t>> expected;
    for (int i = 0; i < 5000; ++i) {
        const uint32_t a = random() % 200, b = random() % 200;
        many.indices.push_back(a), many.indices.push_back(b);
        if (a != b) expected.insert({std::min(a, b), std::max(a, b)});
    }
    EXPECT_EQ(elementsOf(sorted(many)), expected);
}

TEST(ElementSets, GrowAndShrinkAgreeWithBruteForce)
{
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        const Mesh m = soup(random);
        const ElementKind kind = kinds[round % 3];
        const Elements all = allOf(m, kind), edges = allOf(m, ElementKind::Edge), set = elementsOf(randomPart(m, kind, random));
        ElementSet given{kind, {}};
        for (const auto& e : set) given.indices.insert(given.indices.end(), e.begin(), e.end());
        Elements more, less;
        for (const auto& e : all) {
            const bool near = std::any_of(all.begin(), all.end(), [&](const auto& o) { return set.count(o) && touch(m, kind, e, o, edges); });
            const bool edge = std::any_of(all.begin(), all.end(), [&](const auto& o) { return !set.count(o) && touch(m, kind, e, o, edges); });
            if (near || set.count(e)) more.insert(e);
            if (set.count(e) && !edge) less.insert(e);
        }
        EXPECT_EQ(elementsOf(grown(m, given)), more);
        EXPECT_EQ(elementsOf(shrunk(m, given)), less);
    }
}

TEST(ElementSets, GrowthOnAGridIsCounted)
{
    const Mesh m = grid(20, true, true).mesh();  // a torus: no border in the way
    ElementSet f = faces({210}), v = vertices({210});
    for (size_t k = 1; k <= 5; ++k) {
        f = grown(m, f);
        v = grown(m, v);
        EXPECT_EQ(countOf(f), (2 * k + 1) * (2 * k + 1));
        EXPECT_EQ(countOf(v), 2 * k * k + 2 * k + 1);  // a diamond
    }
    for (size_t k = 5; k-- > 0;) {
        f = shrunk(m, f);
        v = shrunk(m, v);
        EXPECT_EQ(countOf(f), (2 * k + 1) * (2 * k + 1));
        EXPECT_EQ(countOf(v), 2 * k * k + 2 * k + 1);
    }
    EXPECT_EQ(countOf(grown(m, edge(0, 1))), 7u);
    EXPECT_TRUE(shrunk(m, f).indices.empty());
}

TEST(ElementSets, ConversionsAgreeWithBruteForce)
{
    std::mt19937 random(5);
    for (int round = 0; round < 450; ++round) {
        const Mesh m = soup(random);
        const ElementKind from = kinds[round % 3], to = kinds[round / 3 % 3];
        if (from == to) continue;
        const ElementSet set = randomPart(m, from, random);
        const Elements had = elementsOf(set);
        std::set<uint32_t> in;
        for (const auto& e : had) in.merge(verticesOf(m, from, e));
        // Sides of an element that are edges of the set.
        const auto sides = [&](uint32_t f, bool all) {
            const auto v = m.face(f);
            size_t yes = 0, n = v.size();
            for (size_t i = 0; i < n; ++i) yes += had.count({std::min(v[i], v[(i + 1) % n]), std::max(v[i], v[(i + 1) % n])});
            return all ? yes == n && n > 0 : yes > 0;
        };
        for (const bool touching : {false, true}) {
            Elements expected;
            for (const auto& e : allOf(m, to)) {
                const auto v = verticesOf(m, to, e);
                const auto inside = [&](uint32_t i) { return in.count(i) > 0; };
                bool yes = touching || to == ElementKind::Vertex ? std::any_of(v.begin(), v.end(), inside) : std::all_of(v.begin(), v.end(), inside);
                if (from == ElementKind::Edge && to == ElementKind::Face) yes = sides(e[0], !touching);
                if (from == ElementKind::Face && to == ElementKind::Edge)
                    yes = std::any_of(set.indices.begin(), set.indices.end(), [&](uint32_t f) {
                        const auto c = m.face(f);
                        for (size_t i = 0; i < c.size(); ++i)
                            if (std::minmax(c[i], c[(i + 1) % c.size()]) == std::minmax(e[0], e[1])) return true;
                        return false;
                    });
                if (yes) expected.insert(e);
            }
            EXPECT_EQ(elementsOf(converted(m, set, to, touching)), expected) << int(from) << " to " << int(to) << " touching " << touching;
        }
    }
}

TEST(ElementSets, WhatTheMeshLacksIsLeftOut)
{
    const Mesh m = cube().mesh();
    for (const ElementKind kind : kinds) {
        const ElementSet wild{kind, {7, 4000000000u}};
        for (const ElementSet& s : {grown(m, wild), shrunk(m, wild), connected(m, wild), inverted(m, wild), boundaryLoops(m, wild)})
            for (const uint32_t i : s.indices) EXPECT_LT(i, 12u);
        for (const ElementKind to : kinds) EXPECT_LE(countOf(converted(m, wild, to, true)), 12u);
    }
    EXPECT_TRUE(edgeLoop(m, {ElementKind::Edge, {3, 4000000000u}}).indices.empty());
    EXPECT_TRUE(flatRegion(m, faces({4000000000u}), 10).indices.empty());
    EXPECT_TRUE(coplanar(m, faces({4000000000u}), 10, 1).indices.empty());
    EXPECT_TRUE(allElements(Mesh(), ElementKind::Edge).indices.empty());
    EXPECT_TRUE(connected(Mesh(), vertices({0})).indices.empty());
}

TEST(Connected, ComponentsAreThoseOfTheReport)
{
    Polygons p = tetrahedron();
    for (const Polygons& other : {cube(), grid(4, true, true)}) {
        const uint32_t base = uint32_t(p.positions.size());
        p.positions.insert(p.positions.end(), other.positions.begin(), other.positions.end());
        for (size_t f = 0; f + 1 < other.start.size(); ++f) {
            for (uint32_t c = other.start[f]; c < other.start[f + 1]; ++c) p.corners.push_back(other.corners[c] + base);
            p.start.push_back(uint32_t(p.corners.size()));
        }
    }
    const Mesh m = p.mesh();
    EXPECT_EQ(m.topology().components, 3u);
    EXPECT_EQ(countOf(connected(m, faces({0}))), 4u);
    EXPECT_EQ(connected(m, vertices({5})).indices, (Indices{4, 5, 6, 7, 8, 9, 10, 11}));
    EXPECT_EQ(countOf(connected(m, edge(4, 5))), 12u);
    EXPECT_EQ(countOf(connected(m, faces({0, 20}))), 4u + 16u);
    EXPECT_EQ(countOf(component(m, ElementKind::Face, 0)), 16u);
    EXPECT_EQ(countOf(component(m, ElementKind::Face, 1)), 6u);
    EXPECT_EQ(countOf(component(m, ElementKind::Edge, 2)), 6u);
    EXPECT_TRUE(component(m, ElementKind::Face, 3).indices.empty());
}

TEST(EdgeLoop, OnATorusItClosesAfterNEdges)
{
    constexpr uint32_t n = 12;
    for (const bool quads : {true, false}) {
        const Mesh m = grid(n, true, quads).mesh();
        const ElementSet row = edgeLoop(m, edge(0, 1)), column = edgeLoop(m, edge(0, n));
        EXPECT_EQ(countOf(row), n);
        EXPECT_EQ(countOf(column), n);
        for (const uint32_t v : row.indices) EXPECT_LT(v, n);
        for (const uint32_t v : column.indices) EXPECT_EQ(v % n, 0u);
        EXPECT_EQ(edgeLoop(m, edge(3, 4)).indices, row.indices);
    }
    EXPECT_EQ(countOf(edgeLoop(grid(n, true, false).mesh(), edge(0, n + 1))), n);  // the diagonals
}

TEST(EdgeLoop, EndsAtTheBorderAndFollowsIt)
{
    const Mesh m = grid(8, false, true).mesh();  // 9 x 9 vertices
    EXPECT_EQ(countOf(edgeLoop(m, edge(40, 41))), 8u);
    EXPECT_EQ(countOf(edgeLoop(m, edge(0, 1))), 32u);  // all round
    EXPECT_EQ(edgeLoop(m, edge(0, 1)).indices, boundary(m, ElementKind::Edge).indices);
    EXPECT_EQ(countOf(edgeLoop(cube().mesh(), edge(0, 1))), 1u);  // valence 3: nothing goes straight on
    EXPECT_TRUE(edgeLoop(m, edge(0, 40)).indices.empty());        // no edge of the mesh
    EXPECT_EQ(countOf(edgeLoop(moebius(10).mesh(), edge(0, 1))), 1u);
    EXPECT_EQ(countOf(edgeLoop(moebius(10).mesh(), edge(0, 2))), 20u);  // the one border
}

TEST(EdgeRing, CrossesQuads)
{
    constexpr uint32_t n = 12;
    const Mesh torus = grid(n, true, true).mesh();
    EXPECT_EQ(countOf(edgeRing(torus, edge(0, 1))), n);
    for (const auto& e : elementsOf(edgeRing(torus, edge(0, 1)))) EXPECT_EQ(e[1] - e[0], 1u);
    EXPECT_EQ(countOf(edgeRing(grid(8, false, true).mesh(), edge(40, 41))), 9u);
    EXPECT_EQ(countOf(edgeRing(cube().mesh(), edge(0, 1))), 4u);
    EXPECT_EQ(countOf(edgeRing(moebius(10).mesh(), edge(0, 1))), 10u);
    EXPECT_EQ(countOf(edgeRing(tetrahedron().mesh(), edge(0, 1))), 1u);
}

TEST(Walks, SoupsDoNoHarm)
{
    std::mt19937 random(6);
    for (int round = 0; round < 300; ++round) {
        const Mesh m = soup(random);
        const ElementSet all = allElements(m, ElementKind::Edge), some = randomPart(m, ElementKind::Edge, random);
        for (const ElementSet& s : {edgeLoop(m, some), edgeRing(m, some), boundaryLoops(m, some), sharpEdges(m, 30)})
            EXPECT_TRUE(without(s, all).indices.empty());
        const TopologyReport& r = m.topology();
        EXPECT_EQ(countOf(boundary(m, ElementKind::Edge)), r.boundaryEdges);
        EXPECT_EQ(boundaryLoops(m, allElements(m, ElementKind::Vertex)).indices, boundary(m, ElementKind::Edge).indices);
        for (const auto& [valence, count] : r.vertexValences) EXPECT_EQ(countOf(ofValence(m, valence, valence)), count) << valence;
    }
}

TEST(Boundary, OneLoopIsThatOfTheReport)
{
    Polygons p = grid(8, false, true);
    const uint32_t hole = 3 * 8 + 3;  // its vertices: 30 31 39 40
    p.corners.erase(p.corners.begin() + 4 * hole, p.corners.begin() + 4 * hole + 4);
    p.start.pop_back();
    const Mesh m = p.mesh();
    EXPECT_EQ(boundaryLoops(m, vertices({40})).indices, (Indices{30, 31, 30, 39, 31, 40, 39, 40}));
    EXPECT_EQ(countOf(boundaryLoops(m, vertices({0}))), 32u);
    EXPECT_EQ(countOf(boundaryLoops(m, vertices({0, 40}))), 36u);
    EXPECT_TRUE(boundaryLoops(m, vertices({10})).indices.empty());
    EXPECT_EQ(countOf(boundary(m, ElementKind::Face)), 28u + 4u);
    EXPECT_EQ(countOf(boundary(m, ElementKind::Vertex)), 36u);
}

TEST(Regions, SidesOfACube)
{
    const Mesh m = cube().mesh();
    EXPECT_EQ(countOf(flatRegion(m, faces({0}), 89)), 1u);
    EXPECT_EQ(countOf(flatRegion(m, faces({0}), 90)), 6u);
    EXPECT_EQ(countOf(sharpEdges(m, 89)), 12u);
    EXPECT_EQ(countOf(sharpEdges(m, 90)), 0u);
    EXPECT_EQ(coplanar(m, faces({0}), 1, 1e-3).indices, (Indices{0}));
    EXPECT_EQ(coplanar(m, faces({0}), 1, 1.001).indices, (Indices{0, 1}));  // the opposite side is one away
}

TEST(Regions, FlatFloodAgreesWithBruteForceOnATerrain)
{
    std::mt19937 random(7);
    Polygons p = grid(14, false, false);
    for (auto& v : p.positions) v.z = float(random() % 100) / 1500;
    std::swap(p.corners[30], p.corners[31]);  // one face the other way round: it is as flat as before
    const Mesh m = p.mesh();
    const auto normal = [&](uint32_t f) {
        const auto v = m.face(f);
        const auto& q = m.positions();
        return glm::normalize(glm::cross(glm::dvec3(q[v[1]] - q[v[0]]), glm::dvec3(q[v[2]] - q[v[0]])));
    };
    for (const double degrees : {5.0, 20.0, 35.0, 60.0}) {
        std::set<uint32_t> reached{100};
        for (bool more = true; more;) {
            more = false;
            for (uint32_t f = 0; f < m.faceCount(); ++f) {
                if (reached.count(f)) continue;
                for (const uint32_t g : std::set<uint32_t>(reached)) {
                    std::set<uint32_t> common;
                    for (const uint32_t a : m.face(f))
                        for (const uint32_t b : m.face(g))
                            if (a == b) common.insert(a);
                    if (common.size() == 2 && std::abs(glm::dot(normal(f), normal(g))) >= std::cos(degrees * std::acos(-1.0) / 180))
                        more = reached.insert(f).second || more;
                }
            }
        }
        EXPECT_EQ(flatRegion(m, faces({100}), degrees).indices, Indices(reached.begin(), reached.end())) << degrees;
    }
}

// In sorts of a million numbers in the same run, so that a busy or instrumented machine does not fail it.
TEST(Speed, AMillionElementsCostNoMoreThanAFewSorts)
{
    const Mesh m = grid(1000, true, true).mesh();  // 1 M vertices and faces, 2 M edges
    m.edges();                                     // kept with the mesh, made by whoever drew it
    ElementSet some{ElementKind::Face, {}}, all;
    for (uint32_t i = 0; i < 1'000'000; i += 3) some.indices.push_back(i);
    const auto report = [](const char* what, double ms) { std::printf("%-28s %6.1f ms\n", what, ms); };
    double worst = 0;
    const auto timed = [&](const char* what, const std::function<void()>& work) {
        const double ms = std::min(millisecondsOf(work), millisecondsOf(work));
        report(what, ms);
        worst = std::max(worst, ms);
    };
    timed("all faces", [&] { all = allElements(m, ElementKind::Face); });
    timed("invert faces", [&] { inverted(m, some); });
    timed("all vertices", [&] { allElements(m, ElementKind::Vertex); });
    timed("add box of faces", [&] { united(all, some); });
    timed("toggle box of faces", [&] { toggled(all, some); });
    timed("grow faces", [&] { grown(m, some); });
    std::mt19937 random(8);
    ElementSet shuffled = all;
    std::shuffle(shuffled.indices.begin(), shuffled.indices.end(), random);
    timed("sort a box of faces", [&] { sorted(shuffled); });
    report("all 2 M edges", millisecondsOf([&] { all = allElements(m, ElementKind::Edge); }));
    report("invert 2 M edges", millisecondsOf([&] { inverted(m, all); }));
    report("connected", millisecondsOf([&] { connected(m, some); }));
    std::vector<uint32_t> numbers(1'000'000);
    for (uint32_t& n : numbers) n = random();
    const double sort = millisecondsOf([&] { std::sort(numbers.begin(), numbers.end()); });
    report("sort of a million", sort);
    EXPECT_LT(worst, 5 * sort);  // on an idle machine no step takes longer than a third of one
}
