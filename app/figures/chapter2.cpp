// Figures of chapter 2.
#include <algorithm>
#include <cmath>
#include <set>

#include "app/figures/drawn_mesh.h"
#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/catalog/catalog.h"
#include "core/mesh/rings.h"
#include "core/mesh/stripify.h"
#include "core/mesh/topology.h"

namespace mw::figures {
namespace {

const std::vector<uint32_t> cubeStrip{0, 1, 2, 3, 7, 1, 5, 4, 7, 6, 2, 4, 0, 1};

/// Where the corners of a strip lie when its triangles are laid flat one after the other: odd ones up, even ones down.
glm::dvec2 bandPlace(size_t i)
{
    return {0.5 * double(i), i % 2 ? std::sqrt(0.75) : 0};
}

void stripOfCube(Page& page)
{
    const Mesh cube = stripCube();
    const Array<uint32_t> triangles = decodeStrips(cubeStrip);
    Space& solid = page.space("the cube, vertex 4x + 2y + z", {330, 250});
    solid.look(28, 24);
    solid.put(cube);
    const auto color = [&](size_t i) { return page.tint(page.series(0), 0.25f + 0.6f * float(i) / 11); };
    for (uint32_t f = 0; f < cube.faceCount(); ++f) solid.faces({f}, glm::vec4(glm::vec3(color(f)), 0.75f));
    solid.numberVertices(page.ink(Ink::Text), page.ink(Ink::Faint));
    Drawing& band = page.drawing("the strip: each corner after the second adds a triangle", {760, 250});
    for (size_t i = 0; i + 2 < cubeStrip.size(); ++i) {
        band.polygon({bandPlace(i), bandPlace(i + 1), bandPlace(i + 2)}, color(i));
        const glm::dvec2 middle = (bandPlace(i) + bandPlace(i + 1) + bandPlace(i + 2)) / 3.0;
        band.words(middle, std::to_string(i), {page.ink(Ink::Text), Beside::On, 13, false, false});
    }
    for (size_t i = 0; i + 2 < cubeStrip.size(); ++i) band.path({bandPlace(i), bandPlace(i + 2)}, Pen(page.ink(Ink::Line), 1.5f));
    std::vector<At> order;
    for (size_t i = 0; i < cubeStrip.size(); ++i) order.emplace_back(bandPlace(i));
    band.path(order, Pen(page.ink(Ink::Focus), 2.5f).arrow().gaps(6, 8));
    for (size_t i = 0; i < cubeStrip.size(); ++i)
        band.label(bandPlace(i), std::to_string(cubeStrip[i]), page.ink(Ink::Text), i % 2 ? Beside::Above : Beside::Below, 17, true);
    page.row();
    TablePanel& table = page.table("decoded: every second triangle is turned round", {"triangle", "strip", "decoded"});
    (void)table;
    std::set<std::pair<uint32_t, uint32_t>> halfEdges;
    std::vector<double> decoded;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) halfEdges.emplace(triangles[i + k], triangles[i + (k + 1) % 3]);
        const size_t at = i / 3;
        const std::vector<uint32_t> raw(cubeStrip.begin() + ptrdiff_t(at), cubeStrip.begin() + ptrdiff_t(at + 3));
        const std::vector<uint32_t> corners(triangles.begin() + ptrdiff_t(i), triangles.begin() + ptrdiff_t(i + 3));
        table.row({std::to_string(at), joined(raw), {joined(corners), at % 2 ? page.ink(Ink::Focus) : page.ink(Ink::Text)}});
        decoded.push_back(100 * corners[0] + 10 * corners[1] + corners[2]);
    }
    page.note("Strip " + joined(cubeStrip) + ": " + std::to_string(cubeStrip.size()) + " indices for " + countText(triangles.size() / 3, "triangle") +
              "; a list has " + std::to_string(triangles.size()) + ".");
    page.number("strip indices", cubeStrip.size());
    page.number("list indices", triangles.size());
    page.number("triangles", triangles.size() / 3);
    page.numbers("decoded", decoded);
    page.number("distinct half-edges", halfEdges.size());
}

void genusOf(Page& page, const Mesh& mesh, const std::string& name, std::vector<std::vector<double>>& all)
{
    const TopologyReport& t = mesh.topology();
    double valences = 0;
    for (const auto& [valence, count] : t.vertexValences) valences += double(valence * count);
    Space& s = page.space(name + ": V = " + std::to_string(t.vertices) + ", E = " + std::to_string(t.edges) + ", F = " + std::to_string(t.faces) +
                              "\nV \u2212 E + F = " + shortNumber(double(t.euler)) + ", genus " + std::to_string(t.genus.value_or(-1)),
                          {360, 300});
    s.look(25, 38);
    s.put(mesh);
    all[0].push_back(double(t.vertices));
    all[1].push_back(double(t.edges));
    all[2].push_back(double(t.faces));
    all[3].push_back(double(t.euler));
    all[4].push_back(double(t.genus.value_or(-1)));
    all[5].push_back(valences);
}

void genus(Page& page)
{
    std::vector<std::vector<double>> all(6);
    genusOf(page, sphereMesh(2), "sphere", all);
    genusOf(page, torusMesh(1, 0.42, 26, 12), "torus", all);
    genusOf(page, torus2(), "two holes", all);
    const char* names[] = {"V", "E", "F", "V-E+F", "genus", "sum of valences"};
    for (size_t i = 0; i < all.size(); ++i) page.numbers(names[i], all[i]);
}

void cubeLists(Page& page)
{
    const Mesh cube = stripCube();
    Space& s = page.space("the cube", {380, 340});
    s.look(30, 22);
    s.put(cube);
    const At origin(0, 0, 0);
    s.arrow(origin, {1.55, 0, 0}, page.series(7), 2.5f);
    s.arrow(origin, {0, 1.45, 0}, page.ink(Ink::New), 2.5f);
    s.arrow(origin, {0, 0, 1.75}, page.series(0), 2.5f);
    s.label({1.55, 0, 0}, "x", page.series(7), Beside::Right, 17, true);
    s.label({0, 1.45, 0}, "y", page.ink(Ink::New), Beside::Above, 17, true);
    s.label({0, 0, 1.75}, "z", page.series(0), Beside::Left, 17, true);
    s.numberVertices(page.ink(Ink::Text), page.ink(Ink::Faint));
    TablePanel& vertices = page.table("vertex list", {"vertex", "x", "y", "z"});
    for (uint32_t v = 0; v < cube.vertexCount(); ++v) {
        const glm::vec3 p = cube.positions()[v];
        vertices.row({std::to_string(v), shortNumber(double(p.x)), shortNumber(double(p.y)), shortNumber(double(p.z))});
    }
    TablePanel& polygons = page.table("polygon list, anticlockwise from outside", {"triangle", "v1", "v2", "v3"});
    for (uint32_t f = 0; f < cube.faceCount(); ++f) {
        const auto c = cube.face(f);
        polygons.row({std::to_string(f), std::to_string(c[0]), std::to_string(c[1]), std::to_string(c[2])});
    }
    page.number("vertices", cube.vertexCount());
    page.number("triangles", cube.faceCount());
    page.number("indices", cube.cornerCount());
    page.number("volume", enclosedVolume(cube));  // positive: anticlockwise from outside
}

void stripRestart(Page& page)
{
    constexpr uint32_t columns = 6, rows = 3;
    std::vector<uint32_t> elements;
    for (uint32_t r = 0; r + 1 < rows; ++r) {
        if (r > 0) elements.push_back(restartIndex);
        for (uint32_t c = 0; c < columns; ++c) elements.insert(elements.end(), {r * columns + c, (r + 1) * columns + c});
    }
    const auto at = [](uint32_t v) { return glm::dvec2(v % columns, -double(v / columns)); };
    const glm::vec4 colors[] = {page.series(0), page.series(1)};
    Drawing& d = page.drawing("two strips", {720, 330});
    const Array<uint32_t> t = decodeStrips(elements);
    double least = 1;
    for (size_t i = 0; i < t.size(); i += 3) {
        const glm::dvec2 a = at(t[i]), b = at(t[i + 1]) - a, c = at(t[i + 2]) - a;
        least = std::min(least, 0.5 * (b.x * c.y - b.y * c.x));
        const size_t strip = i / 3 < t.size() / 6 ? 0 : 1;
        d.polygon({a, at(t[i + 1]), at(t[i + 2])}, page.tint(colors[strip], i % 2 ? 0.35f : 0.5f));
    }
    std::vector<At> order;
    size_t strip = 0;
    const auto end = [&] {
        d.path(order, Pen(colors[strip++], 2.5f).arrow().gaps(8, 10));
        order.clear();
    };
    for (const uint32_t v : elements) {
        if (v == restartIndex)
            end();
        else
            order.emplace_back(at(v) + (strip ? glm::dvec2(0, -0.04) : glm::dvec2(0, 0.04)));
    }
    end();
    for (uint32_t v = 0; v < columns * rows; ++v)
        d.label(at(v), std::to_string(v), page.ink(Ink::Text), v < columns ? Beside::Above : Beside::Below, 16, true);
    page.row();
    Drawing& array = page.drawing("the element array; R is the restart index", {900, 64});
    array.margin = 6;
    strip = 0;
    for (size_t i = 0; i < elements.size(); ++i) {
        const bool restart = elements[i] == restartIndex;
        const double x = double(i);
        array.polygon({{x + 0.04, 0}, {x + 0.96, 0}, {x + 0.96, 1}, {x + 0.04, 1}}, restart ? page.ink(Ink::Focus) : page.tint(colors[strip], 0.35f));
        array.words({x + 0.5, 0.5}, restart ? "R" : std::to_string(elements[i]),
                    {restart ? page.ink(Ink::Paper) : page.ink(Ink::Text), Beside::On, 15, restart, false});
        strip += restart;
    }
    page.number("indices", elements.size());
    page.number("restarts", size_t(std::count(elements.begin(), elements.end(), restartIndex)));
    page.number("triangles", t.size() / 3);
    page.number("list indices", t.size());
    page.number("least signed area", least);
}

std::string verdict(const Mesh& m)
{
    const TopologyReport& t = m.topology();
    return t.manifold() ? "manifold" : "not manifold";
}

void manifold(Page& page)
{
    page.letters(false);
    const glm::vec2 size(265, 230);
    const glm::vec4 red = page.ink(Ink::Offender), blue = page.ink(Ink::Neighbour), focus = page.ink(Ink::Focus);
    std::vector<double> verdicts;
    const auto panel = [&](const Mesh& m, const std::string& words, glm::vec2 extent) -> Space& {
        Space& s = page.space(words + ": " + verdict(m), extent);
        s.look(0, 62);
        s.put(m, glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 0, 1)));
        verdicts.push_back(m.topology().manifold());
        return s;
    };
    Space& a = panel(fan(6, 0.25), "(a) closed fan round an inner vertex", size);
    a.vertices({0}, focus, 13);
    Space& b = panel(fan(4, 0.15, false), "(a) open fan at a boundary vertex", size);
    b.vertices({0}, focus, 13);
    const Mesh two = Mesh::triangles(Array<glm::vec3>{{-1, 0, 0}, {1, 0, 0}, {0, 1.2f, 0.25f}, {0, -1.2f, 0.25f}}, Array<uint32_t>{0, 1, 2, 1, 0, 3});
    Space& c = panel(two, "(a) inner edge with 2 faces", size);
    c.edges({0, 1}, focus, 5);
    Space& d = panel(two, "(a) border edge with 1 face", size);
    d.edges({1, 2}, focus, 5);
    page.row();
    const Mesh book = Mesh::triangles(Array<glm::vec3>{{-1, 0, 0}, {1, 0, 0}, {0, 1.1f, -0.6f}, {0, -1.1f, -0.6f}, {0, 0, 1.2f}},
                                      Array<uint32_t>{0, 1, 2, 1, 0, 3, 0, 1, 4});
    const size_t meeting = 3 * (book.topology().nonmanifoldEdges.size() == 1);
    Space& e = panel(book, "(b) an edge with " + std::to_string(meeting) + " faces", {400, 260});
    e.look(50, 42);
    e.edges({0, 1}, red, 6);
    for (uint32_t f = 0; f < 3; ++f) e.label(e.centre(f), std::to_string(f + 1), blue, Beside::On, 17, true);
    const Mesh bow = Mesh::triangles(
        Array<glm::vec3>{{0, 0, 0}, {1.2f, 0.6f, 0}, {1.3f, 0, 0}, {1.2f, -0.6f, 0}, {-1.2f, 0.6f, 0}, {-1.3f, 0, 0}, {-1.2f, -0.6f, 0}},
        Array<uint32_t>{0, 2, 1, 0, 3, 2, 0, 4, 5, 0, 5, 6});
    Space& f = panel(bow, "(b) a vertex with 2 fans (bow-tie)", {400, 260});
    f.vertices({0}, red, 14);
    f.label({1.0, 0, 0.28}, "fan 1", blue, Beside::On, 15, true);
    f.label({-1.0, 0, 0.28}, "fan 2", blue, Beside::On, 15, true);
    page.numbers("manifold", verdicts);
    page.number("faces at the edge", meeting);
    page.number("non-manifold edges of (b)", book.topology().nonmanifoldEdges.size());
    page.number("non-manifold vertices of (b)", bow.topology().nonmanifoldVertices.size());
}

std::vector<uint32_t> ringOf(const Mesh& m, uint32_t v, int n)
{
    const Operation& op = operation("adjacency");
    const std::string parameters = "query=vertex-vertices,element=" + std::to_string(v) + ",ring=" + std::to_string(n);
    return std::get<ElementSet>(apply(op, m, parsed(op.parameters, parameters))).indices;
}

void rings(Page& page)
{
    const Mesh grid = hexagonGrid(4), cow = cow3(1400);
    const auto split = [](const Mesh& m, uint32_t v) {
        std::vector<uint32_t> one = ringOf(m, v, 1), two = ringOf(m, v, 2), more;
        std::set_difference(two.begin(), two.end(), one.begin(), one.end(), std::back_inserter(more));
        return std::pair(one, more);
    };
    const glm::vec4 first = page.ink(Ink::Neighbour), second = page.ink(Ink::New), focus = page.ink(Ink::Focus);
    const auto [one, more] = split(grid, 0);
    Drawing& d = page.drawing(
        "a regular mesh: " + std::to_string(one.size()) + " in the one-ring, " + std::to_string(more.size()) + " more in the two-ring", {420, 390});
    drawEdges(d, grid, Pen(page.ink(Ink::Removed), 1.5f));
    for (const uint32_t v : one) d.disc(placeOf(grid, v), first, 15);
    for (const uint32_t v : more) d.disc(placeOf(grid, v), second, 15);
    d.disc({0, 0}, focus, 18);
    d.words({0, 0}, "V", {page.ink(Ink::Text), Beside::AboveRight, 17, true});
    const auto [a, b] = nearestEdge(cow, {0.4, 1.1, 0.1});
    (void)b;
    const auto [ring, outer] = split(cow, a);
    Space& s = page.space("the cow: " + std::to_string(ring.size()) + " and " + std::to_string(outer.size()), {420, 390});
    s.put(cow);
    closeUp(s, glm::dvec3(cow.positions()[a]), glm::dvec3(cow.vertexNormals()[a]), 0.62);
    s.vertices(outer, second, 14);
    s.vertices(ring, first, 14);
    s.vertices({a}, focus, 17);
    for (Panel* p : {static_cast<Panel*>(&d), static_cast<Panel*>(&s)}) p->key(focus, "vertex V").key(first, "one-ring").key(second, "two-ring");
    page.number("one-ring", one.size());
    page.number("two-ring, more", more.size());
    page.number("one-ring of the cow", ring.size());
    page.number("valence of the cow's vertex", cow.rings().neighboursOf(a).size());
}

void faceNormal(Page& page)
{
    const Mesh five = Mesh(Array<glm::vec3>{{0, 0, 0}, {2, -0.2f, 0.5f}, {2.6f, 0.1f, -1.1f}, {1.1f, 0.45f, -2.3f}, {-0.5f, 0.3f, -1.3f}},
                           Array<uint32_t>{0u, 5u}, Array<uint32_t>{0, 1, 2, 3, 4});
    const glm::dvec3 p1(five.positions()[0]), p2(five.positions()[1]), p3(five.positions()[2]), p = p2 - p1, q = p3 - p1, n = glm::cross(p, q);
    // (2.5)
    const double a = p1.y * (p2.z - p3.z) + p2.y * (p3.z - p1.z) + p3.y * (p1.z - p2.z);
    const double b = p1.z * (p2.x - p3.x) + p2.z * (p3.x - p1.x) + p3.z * (p1.x - p2.x);
    const double c = p1.x * (p2.y - p3.y) + p2.x * (p3.y - p1.y) + p3.x * (p1.y - p2.y);
    const double d = -(a * p1.x + b * p1.y + c * p1.z);
    Space& s = page.space("P1, P2, P3 anticlockwise: n = p × q", {460, 360});
    s.look(-12, 24);
    s.put(five);
    const glm::vec4 ink = page.ink(Ink::Text);
    s.arrow(p1, p2, page.ink(Ink::Neighbour), 3);
    s.arrow(p1, p3, page.ink(Ink::Neighbour), 3);
    s.arrow(p1, p1 + 0.45 * n, page.ink(Ink::Focus), 3.5f);
    s.label(p1 + 0.55 * p, "p", page.ink(Ink::Neighbour), Beside::Below, 18, true);
    s.label(p1 + 0.55 * q, "q", page.ink(Ink::Neighbour), Beside::Above, 18, true);
    s.label(p1 + 0.45 * n, "n", page.ink(Ink::Focus), Beside::Right, 18, true);
    s.label(p1, "P1", ink, Beside::BelowLeft, 16, true);
    s.label(p2, "P2", ink, Beside::Right, 16, true);
    s.label(p3, "P3", ink, Beside::Right, 16, true);
    TablePanel& t = page.table("plane a x + b y + c z + d = 0 by (2.5)", {"", "(2.5)", "p × q"});
    t.row({"a", shortNumber(a), shortNumber(n.x)});
    t.row({"b", shortNumber(b), shortNumber(n.y)});
    t.row({"c", shortNumber(c), shortNumber(n.z)});
    t.row({"d", shortNumber(d), shortNumber(-glm::dot(n, p1))});
    const double u = glm::length(p), v = glm::length(q), w = glm::length(p3 - p2), half = 0.5 * (u + v + w),
                 heron = std::sqrt(half * (half - u) * (half - v) * (half - w));
    t.rule();
    t.row({"length", shortNumber(std::sqrt(a * a + b * b + c * c)), shortNumber(glm::length(n))});
    t.row({"twice the triangle's area", "", shortNumber(2 * heron)});
    page.numbers("(2.5)", std::vector<double>{a, b, c, d});
    page.numbers("cross product", std::vector<double>{n.x, n.y, n.z});
    page.number("length", std::sqrt(a * a + b * b + c * c));
    page.number("twice the area by its sides", 2 * heron);
}

void shading(Page& page)
{
    const Mesh cow = cow3(1800);
    for (const bool smooth : {false, true}) {
        Space& s = page.space(smooth ? "vertex normals" : "face normals", {460, 380});
        s.look(52, 12);
        s.put(cow);
        s.wires(false);
        s.smooth(smooth);
    }
    page.number("face normals", cow.faceNormals().size());
    page.number("vertex normals", cow.vertexNormals().size());
    page.number("V", cow.vertexCount());
    page.number("F", cow.faceCount());
}

}  // namespace

std::vector<Figure> chapter2Figures()
{
    return {
        {"2.01-cube-lists", "2.1", "A cube as vertex list and polygon list", {"2.1", "2.3"}, cubeLists},
        {"2.02-cube-strip", "2.2", "A cube as one triangle strip", {"2.1"}, stripOfCube},
        {"2.03-strip-restart", "2.3", "Two strips joined by a restart index", {"2.1"}, stripRestart},
        {"2.04-manifold", "2.4", "Manifold and not", {"2.3", "2.4"}, manifold},
        {"2.05-rings", "2.5", "One-ring and two-ring", {"2.3", "2.6"}, rings},
        {"2.06-genus", "2.6", "Genus and Euler characteristic", {"2.3"}, genus},
        {"2.12-face-normal", "2.12", "The normal of a polygon", {"2.7"}, faceNormal},
        {"2.13-shading", "2.13", "Face normals and vertex normals", {"2.7"}, shading},
    };
}

}  // namespace mw::figures
