// Figures 3.13 to 3.24: subdivision of surfaces.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/mesh/rings.h"
#include "core/mesh/submesh.h"
#include "core/mesh/topology.h"
#include "core/subdivide/butterfly_rows.h"
#include "core/subdivide/catmull_level.h"
#include "core/subdivide/loop_level.h"
#include "core/subdivide/sqrt3_round.h"

namespace mw::figures {
namespace {

/// A weight as the book writes it: over `denominator`, shortened where that is not given.
std::string fraction(double w, int denominator = 0)
{
    const std::string sign = w < 0 ? "\u2212" : "";
    for (const int d : {1, 2, 4, 8, 16, 32}) {
        if (denominator && d != denominator) continue;
        const double n = std::abs(w) * d;
        if (std::abs(n - std::round(n)) < 1e-9) return sign + std::to_string(std::lround(n)) + (d == 1 ? "" : "/" + std::to_string(d));
    }
    return shortNumber(w);
}

glm::dvec2 flat(const Mesh& mesh, uint32_t v)
{
    return glm::dvec2(mesh.positions()[v]);
}

/// Whether a vertex has faces all round it.
std::vector<bool> innerVertices(const Mesh& mesh)
{
    std::vector<bool> inner(mesh.vertexCount(), true);
    for (const auto& loop : mesh.topology().boundaryLoops)
        for (const uint32_t v : loop) inner[v] = false;
    return inner;
}

/// The edges of a mesh in the plane.
void net(Drawing& d, const Mesh& mesh, const Pen& pen)
{
    const Shared<uint32_t>& e = mesh.edges();
    for (size_t i = 0; i < e.size(); i += 2) d.line(flat(mesh, e[i]), flat(mesh, e[i + 1]), pen);
}

std::set<std::vector<std::pair<long, long>>> shapesOf(const Mesh& mesh)
{
    std::set<std::vector<std::pair<long, long>>> out;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<std::pair<long, long>> shape;
        for (const uint32_t v : mesh.face(f)) shape.emplace_back(std::lround(1e5 * mesh.positions()[v].x), std::lround(1e5 * mesh.positions()[v].y));
        std::rotate(shape.begin(), std::min_element(shape.begin(), shape.end()), shape.end());
        out.insert(shape);
    }
    return out;
}

void splitPanel(Page& page, const Mesh& mesh, const std::string& caption, std::vector<double>& faces, std::set<size_t>& valences)
{
    Drawing& d = page.drawing(caption + countText(mesh.faceCount(), "face"), {250, 230});
    net(d, mesh, Pen(page.ink(Ink::Line), 2));
    const std::vector<bool> inner = innerVertices(mesh);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        d.disc(flat(mesh, v), page.ink(inner[v] ? Ink::Focus : Ink::Text), inner[v] ? 11 : 7);
        if (inner[v]) valences.insert(mesh.rings().neighboursOf(v).size());
    }
    faces.push_back(double(mesh.faceCount()));
}

void splits(Page& page)
{
    const double h = std::sqrt(0.75);
    const Mesh triangle = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}}, Array<uint32_t>{0, 1, 2});
    const Mesh quad(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Array<uint32_t>{0u, 4u}, Array<uint32_t>{0, 1, 2, 3});
    bool same = true;
    for (const Mesh& m : {triangle, quad}) {
        const std::string name = m.isTriangles() ? "triangle" : "quad";
        std::vector<double> faces;
        std::set<size_t> valences;
        splitPanel(page, m, "", faces, valences);
        splitPanel(page, applied("split-dyadic", "levels=1", m), "dyadic: ", faces, valences);
        splitPanel(page, applied("split-dyadic", "levels=2", m), "dyadic twice: ", faces, valences);
        const Mesh four = applied("split-nadic", "n=4", m);
        splitPanel(page, four, "4-adic: ", faces, valences);
        same = same && shapesOf(four) == shapesOf(applied("split-dyadic", "levels=2", m));
        page.numbers(name + " faces", faces);
        page.numbers(name + " inner valences", std::vector<double>(valences.begin(), valences.end()));
        if (m.isTriangles()) page.row();
    }
    page.note("Marked: vertices inside, of valence 6 among triangles and 4 among quads.");
    page.number("4-adic is dyadic twice", same);
}

LoopLevel levelOf(const Mesh& mesh)
{
    return LoopLevel::of(mesh, {}, SubdivideLoop::Corners::Smooth);
}

uint32_t edgeBetween(const LoopLevel& level, uint32_t a, uint32_t b)
{
    for (uint32_t e = 0; e < level.edges.size(); ++e)
        if (std::minmax(level.edges[e].a, level.edges[e].b) == std::minmax(a, b)) return e;
    return none;
}

/// The neighbour of vertex 0 that lies farthest to the right.
uint32_t rightOf(const Mesh& mesh, uint32_t v)
{
    uint32_t best = none;
    for (const uint32_t n : mesh.rings().neighboursOf(v))
        if (best == none || mesh.positions()[n].x > mesh.positions()[best].x) best = n;
    return best;
}

void butterflyStencil(Page& page)
{
    const Mesh grid = hexagonGrid(2);
    const LoopLevel level = levelOf(grid);
    const uint32_t a = 0, b = rightOf(grid, a), e = edgeBetween(level, a, b);
    for (const int outer : {16, 8}) {
        std::vector<ButterflyRows::Term> terms;
        ButterflyRows(level, 1.0 / outer, true).row(e, terms);
        Drawing& d = page.drawing("w = 1/" + std::to_string(outer), {470, 400});
        net(d, grid, Pen(page.ink(Ink::Faint), 1));
        const glm::dvec2 middle = 0.5 * (flat(grid, a) + flat(grid, b));
        d.line(flat(grid, a), flat(grid, b), Pen(page.ink(Ink::Focus), 3));
        double sum = 0;
        std::vector<double> weights;
        char letter = 'A';
        for (const auto& t : terms) {
            const bool end = letter <= 'B', wing = letter >= 'E';
            d.disc(flat(grid, t.vertex), page.ink(end ? Ink::Focus : wing ? Ink::Rejected : Ink::Neighbour), 26);
            d.words(flat(grid, t.vertex), std::string(1, letter++), {page.ink(Ink::Panel), Beside::On, 15, true, false});
            const glm::dvec2 away = flat(grid, t.vertex) - middle;
            d.words(flat(grid, t.vertex), fraction(t.weight),
                    {page.ink(Ink::Text), end ? (away.x > 0 ? Beside::Right : Beside::Left) : (away.y > 0 ? Beside::Above : Beside::Below), 16, false,
                     true, 16});
            weights.push_back(t.weight);
            sum += t.weight;
        }
        d.disc(middle, page.ink(Ink::New), 12);
        d.label(middle, "P", page.ink(Ink::New), Beside::Above, 17, true);
        page.numbers("weights " + std::to_string(outer), weights);
        page.number("sum " + std::to_string(outer), sum);
    }
}

/// Four panels of iterations; counts go into the numbers.
std::vector<Mesh> iterations(Page& page, const Mesh& mesh, const std::string& operation, glm::dvec2 view, glm::vec2 size = {330, 280})
{
    std::vector<Mesh> out;
    std::vector<double> vertices, edges, faces;
    for (int level = 0; level <= 3; ++level) {
        const std::string parameters = "levels=" + std::to_string(level);
        out.push_back(level == 0 ? mesh : applied(operation.c_str(), parameters.c_str(), mesh));
        const TopologyReport& t = out.back().topology();
        if (level == 2) page.row();
        Space& s = page.space((level == 0 ? "original: " : "iteration " + std::to_string(level) + ": ") + "V = " + std::to_string(t.vertices) +
                                  ", E = " + std::to_string(t.edges) + ", F = " + std::to_string(t.faces),
                              size);
        s.look(view.x, view.y);
        s.put(out.back());
        s.wires(level < 3);
        vertices.push_back(double(t.vertices)), edges.push_back(double(t.edges)), faces.push_back(double(t.faces));
    }
    page.numbers("V", vertices);
    page.numbers("E", edges);
    page.numbers("F", faces);
    return out;
}

/// How far the vertices of the first mesh have moved in the last.
std::pair<double, double> displacement(const std::vector<Mesh>& meshes)
{
    double most = 0, sum = 0;
    const Mesh &first = meshes.front(), &last = meshes.back();
    for (size_t v = 0; v < first.vertexCount(); ++v) {
        const double d = glm::distance(glm::dvec3(first.positions()[v]), glm::dvec3(last.positions()[v]));
        most = std::max(most, d), sum += d;
    }
    return {most, sum / double(first.vertexCount())};
}

void butterfly(Page& page)
{
    const auto moved = displacement(iterations(page, cow3(250), "subdivide-butterfly", {55, 15}));
    page.number("largest displacement of old vertices", moved.first);
    page.note("Old vertices moved by at most " + shortNumber(moved.first) + ".");
}

void loop(Page& page)
{
    const std::vector<Mesh> meshes = iterations(page, cow3(250), "subdivide-loop", {55, 15});
    page.number("mean displacement of old vertices", displacement(meshes).second);
    page.number("volume before", enclosedVolume(meshes.front()));
    page.number("volume after", enclosedVolume(meshes.back()));
}

/// A row drawn with its weights; `target` is what is made or moved.
void stencil(Page& page, Drawing& d, const Mesh& mesh, const Stencils& rows, uint32_t row, glm::dvec2 target, const char* name, int denominator,
             const std::string& key)
{
    std::vector<double> weights;
    for (uint32_t i = rows.start[row]; i < rows.start[row + 1]; ++i) {
        const glm::dvec2 p = flat(mesh, rows.source[i]), away = p - target;
        const bool self = glm::length(away) < 1e-9;
        if (!self) d.line(p, target, Pen(page.ink(Ink::Neighbour), 2.5f).gaps(7, 7));
        d.disc(p, page.ink(self ? Ink::Focus : Ink::Neighbour), 12);
        const Beside beside = self                                        ? Beside::BelowRight
                              : std::abs(away.x) > std::abs(away.y) * 1.2 ? (away.x > 0 ? Beside::Right : Beside::Left)
                              : away.y > 0                                ? Beside::Above
                                                                          : Beside::Below;
        d.label(p, fraction(double(rows.weight[i]), denominator), page.ink(Ink::Text), beside);
        weights.push_back(double(rows.weight[i]));
    }
    d.ring(target, page.ink(Ink::New), 18, 3);
    d.label(target, name, page.ink(Ink::New), Beside::AboveRight, 17, true);
    page.numbers(key, weights);
}

void loopStencils(Page& page)
{
    const Mesh grid = hexagonGrid(2);
    const LoopLevel level = levelOf(grid);
    const Stencils rows = loopVertexRows(level, SubdivideLoop::Weights::Loop);
    const uint32_t right = rightOf(grid, 0), e = edgeBetween(level, 0, right);
    Drawing& a = page.drawing("a new vertex H on the edge AB", {430, 380});
    net(a, grid, Pen(page.ink(Ink::Faint), 1));
    stencil(page, a, grid, rows, uint32_t(grid.vertexCount()) + e, 0.5 * (flat(grid, 0) + flat(grid, right)), "H", 8, "new");
    Drawing& b = page.drawing("an old vertex G of valence 6: \u03bb = " + fraction(loopWeight(SubdivideLoop::Weights::Loop, 6)), {430, 380});
    net(b, grid, Pen(page.ink(Ink::Faint), 1));
    stencil(page, b, grid, rows, 0, flat(grid, 0), "G", 16, "old");
}

void loopBoundary(Page& page)
{
    const Mesh grid = triangleGrid(4, 2);
    const LoopLevel level = levelOf(grid);
    const Stencils rows = loopVertexRows(level, SubdivideLoop::Weights::Loop);
    const uint32_t e = edgeBetween(level, 1, 2);
    Drawing& a = page.drawing("a new vertex C on a border edge", {430, 300});
    net(a, grid, Pen(page.ink(Ink::Faint), 1));
    stencil(page, a, grid, rows, uint32_t(grid.vertexCount()) + e, 0.5 * (flat(grid, 1) + flat(grid, 2)), "C", 2, "new");
    Drawing& b = page.drawing("an old vertex G on the border", {430, 300});
    net(b, grid, Pen(page.ink(Ink::Faint), 1));
    stencil(page, b, grid, rows, 2, flat(grid, 2), "G", 8, "old");
}

void sqrt3Steps(Page& page)
{
    const Mesh grid = hexagonGrid(1);
    Sqrt3Round round(grid, false);
    const auto mesh = [&] { return Mesh::triangles(round.points, round.triangles); };
    const auto vertices = [&](Drawing& d, bool centres) {
        for (uint32_t v = 0; v < grid.vertexCount(); ++v) d.disc(flat(grid, v), page.ink(Ink::Text), 9);
        for (const uint32_t c : round.centre)
            if (centres) d.disc(glm::dvec2(round.points[c]), page.ink(Ink::New), 9);
    };
    std::vector<double> faces{double(grid.faceCount())};
    Drawing& a = page.drawing("original: " + countText(grid.faceCount(), "triangle"), {330, 300});
    net(a, grid, Pen(page.ink(Ink::Line), 2));
    vertices(a, false);
    faces.push_back(double(mesh().faceCount()));
    Drawing& b = page.drawing("a centre in each: " + countText(mesh().faceCount(), "triangle"), {330, 300});
    net(b, mesh(), Pen(page.ink(Ink::Faint), 1.5f));
    net(b, grid, Pen(page.ink(Ink::Line), 2));
    vertices(b, true);
    for (uint32_t e = 0; e < round.edges.size(); ++e)
        if (round.flips(e)) round.flip(e);
    faces.push_back(double(mesh().faceCount()));
    Drawing& c = page.drawing("inner edges flipped: " + countText(mesh().faceCount(), "triangle"), {330, 300});
    net(c, mesh(), Pen(page.ink(Ink::Line), 2));
    for (uint32_t e = 0; e < round.edges.size(); ++e)
        if (round.flips(e)) c.line(flat(grid, round.edges.ends[e].a), flat(grid, round.edges.ends[e].b), Pen(page.ink(Ink::Removed), 1.5f).dashed());
    vertices(c, true);
    page.numbers("faces", faces);
    page.number("valence of the middle before", grid.rings().neighboursOf(0).size());
    page.number("valence of the middle after", mesh().rings().neighboursOf(0).size());
}

void sqrt3(Page& page)
{
    const std::vector<Mesh> meshes = iterations(page, sphereMesh(0), "subdivide-sqrt3", {25, 20}, {300, 270});
    std::vector<double> newValences;
    for (const auto& [valence, count] : meshes[1].topology().vertexValences) newValences.push_back(double(valence));
    page.numbers("valences after one", newValences);
}

/// Of the vertices with four quads round them that face the viewer, the one that an update moves most.
uint32_t goodVertex(const Mesh& mesh, const Array<glm::vec3>& updated)
{
    uint32_t best = 0;
    double most = -1;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.rings().neighboursOf(v).size() != 4) continue;
        if (glm::dot(glm::dvec3(mesh.vertexNormals()[v]), glm::normalize(glm::dvec3(0.8, 0.9, 0.5))) < 0.5) continue;
        const double d = glm::distance(glm::dvec3(updated[v]), glm::dvec3(mesh.positions()[v]));
        if (d > most) most = d, best = v;
    }
    return best;
}

void catmullSteps(Page& page)
{
    const Mesh cow = cow4();
    const CatmullLevel level = CatmullLevel::of(cow, {}, false);
    const Array<glm::vec3> old(cow.positions().begin(), cow.positions().end());
    CatmullPoints next(level, old);
    next.faces(0, level.faces());
    next.edges(0, level.edges.size());
    next.vertices();
    const uint32_t v = goodVertex(cow, next.points);
    KeptElements kept(cow);
    for (size_t f = 0; f < cow.faceCount(); ++f) kept.faces[f] = std::find(cow.face(f).begin(), cow.face(f).end(), v) != cow.face(f).end();
    const Mesh near = submesh(cow, kept);
    const glm::dvec3 n = cow.vertexNormals()[v];
    const double azimuth = glm::degrees(std::atan2(n.x, n.z)) + 15, elevation = glm::degrees(std::asin(n.y)) - 12;
    const auto panel = [&](const std::string& caption) -> Space& {
        Space& s = page.space(caption, {330, 300});
        s.look(azimuth, elevation);
        KeptElements used(near);
        std::fill(used.vertices.begin(), used.vertices.end(), false);
        for (const uint32_t c : near.cornerVertex()) used.vertices[c] = true;
        s.put(submesh(near, used));
        return s;
    };
    // The edge whose parts are named: from the vertex, A, to B.
    uint32_t named = none;
    for (uint32_t e = 0; e < level.edges.size() && named == none; ++e)
        if (level.edges[e].a == v || level.edges[e].b == v) named = e;
    const CatmullLevel::Edge& edge = level.edges[named];
    const uint32_t other = edge.a == v ? edge.b : edge.a;
    const auto facePoint = [&](uint32_t f) { return next.points[cow.vertexCount() + level.edges.size() + f]; };
    const auto facePoints = [&](Space& s, const char* first, const char* second) {
        for (uint32_t f = 0; f < cow.faceCount(); ++f)
            if (kept.faces[f]) s.disc(facePoint(f), page.ink(Ink::New), 11);
        s.label(facePoint(edge.f), first, page.ink(Ink::New));
        if (second) s.label(facePoint(edge.g), second, page.ink(Ink::New));
    };
    const auto edgePoints = [&](Space& s, bool withName) {
        for (uint32_t e = 0; e < level.edges.size(); ++e)
            if (level.edges[e].a == v || level.edges[e].b == v) s.disc(next.points[cow.vertexCount() + e], page.ink(Ink::Neighbour), 11);
        if (withName) s.label(next.points[cow.vertexCount() + named], "ve", page.ink(Ink::Neighbour));
    };
    const double spread = glm::distance(glm::dvec3(next.points[v]), glm::dvec3(old[v]));
    Space& a = panel("new face points");
    facePoints(a, "vf", nullptr);
    a.disc(old[v], page.ink(Ink::Text), 11);
    Space& b = panel("new edge points");
    facePoints(b, "vf", "vg");
    edgePoints(b, true);
    for (const uint32_t end : {v, other}) {
        b.disc(old[end], page.ink(Ink::Text), 11);
        b.label(old[end], end == v ? "vA" : "vB", page.ink(Ink::Text));
    }
    Space& c = panel("the vertex updated");
    facePoints(c, "vfi", nullptr);
    edgePoints(c, false);
    c.disc(old[v], page.ink(Ink::Text), 11);
    c.disc(old[other], page.ink(Ink::Text), 11);
    c.label(old[other], "vi", page.ink(Ink::Text));
    c.disc(next.points[v], page.ink(Ink::Focus), 11);
    c.label(next.points[v], "v", page.ink(Ink::Focus));
    a.key(page.ink(Ink::Text), "current vertex").key(page.ink(Ink::New), "new face point");
    b.key(page.ink(Ink::Neighbour), "new edge point");
    c.key(page.ink(Ink::Focus), "updated vertex");
    page.number("valence", cow.rings().neighboursOf(v).size());
    page.number("moved", spread);
}

void catmullSplit(Page& page)
{
    const Mesh before(
        Array<glm::vec3>{{0, 0, 0}, {1.6, 0, 0}, {1.6, 1.4, 0}, {0, 1.4, 0}, {2.9, 0.6, 0}, {3.2, 1.8, 0}, {2.2, 2.6, 0}, {0.8, 2.5, 0}},
        Array<uint32_t>{0u, 4u, 9u, 12u, 15u}, Array<uint32_t>{0, 1, 2, 3, 1, 4, 5, 6, 2, 3, 2, 7, 2, 6, 7});
    const Mesh after = applied("subdivide-catmull-clark", "levels=1", before);
    for (const Mesh& m : {before, after}) {
        Drawing& d = page.drawing(m.faceCount() == before.faceCount() ? "faces of 3, 4 and 5 sides" : "after: quads only", {430, 340});
        net(d, m, Pen(page.ink(Ink::Line), 2));
        for (uint32_t v = 0; v < m.vertexCount(); ++v) {
            const size_t edges = before.vertexCount() + before.edges().size() / 2;
            d.disc(flat(m, v), page.ink(v < before.vertexCount() ? Ink::Text : v < edges ? Ink::Neighbour : Ink::New), 9);
        }
    }
    std::vector<double> sides, expected, valences;
    size_t corners = 0;
    for (const auto& [size, count] : before.topology().faceSizes) sides.push_back(double(size)), corners += size * count;
    for (const auto& [size, count] : after.topology().faceSizes) expected.push_back(double(size));
    const std::vector<bool> inner = innerVertices(after);
    for (uint32_t v = uint32_t(before.vertexCount()); v < before.vertexCount() + before.edges().size() / 2; ++v)
        if (inner[v]) valences.push_back(double(after.rings().neighboursOf(v).size()));
    page.numbers("sides before", sides);
    page.numbers("sides after", expected);
    page.number("corners before", corners);
    page.number("faces after", after.faceCount());
    page.numbers("valence of inner edge points", valences);
    page.note("Blue: edge points, green: face points.");
}

Mesh cubeOfHalfSide1()
{
    Array<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i & 4 ? 1 : -1, i & 2 ? 1 : -1, i & 1 ? 1 : -1);
    Array<uint32_t> start, corners{0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3};
    for (uint32_t f = 0; f <= 6; ++f) start.push_back(4 * f);
    return Mesh(std::move(p), std::move(start), std::move(corners));
}

void catmullCube(Page& page)
{
    const Mesh cube = cubeOfHalfSide1();
    std::vector<double> v, e, f, threes, corner;
    for (int level = 0; level <= 3; ++level) {
        const Mesh m = level == 0 ? cube : applied("subdivide-catmull-clark", ("levels=" + std::to_string(level)).c_str(), cube);
        const TopologyReport& t = m.topology();
        Space& s =
            page.space((level == 0 ? "" : std::to_string(level) + ": ") + "V = " + std::to_string(t.vertices) + ", E = " + std::to_string(t.edges) +
                           ", F = " + std::to_string(t.faces) + "\ncorner at " + shortNumber(double(m.positions()[7].x)),
                       {260, 250});
        s.look(30, 25);
        s.put(m);
        std::vector<uint32_t> marked;
        for (uint32_t i = 0; i < m.vertexCount(); ++i)
            if (m.rings().neighboursOf(i).size() == 3) marked.push_back(i);
        threes.push_back(double(marked.size()));
        s.vertices(marked, page.ink(Ink::Focus));
        v.push_back(double(t.vertices)), e.push_back(double(t.edges)), f.push_back(double(t.faces)), corner.push_back(double(m.positions()[7].x));
    }
    page.numbers("V", v);
    page.numbers("E", e);
    page.numbers("F", f);
    page.numbers("vertices of valence 3", threes);
    page.numbers("corner", corner);
}

void catmull(Page& page)
{
    iterations(page, cow4(), "subdivide-catmull-clark", {55, 15});
}

}  // namespace

std::vector<Figure> chapter3SubdivisionFigures()
{
    return {
        {"3.13-splits", "3.13", "Dyadic and n-adic splits", {"3.6"}, splits},
        {"3.14-butterfly-stencil", "3.14", "The butterfly's stencil, with two sets of weights", {"3.7"}, butterflyStencil},
        {"3.15-butterfly", "3.15", "Butterfly subdivision goes through the old vertices", {"3.7"}, butterfly},
        {"3.16-loop-stencils", "3.16", "Masks of Loop subdivision", {"3.8"}, loopStencils},
        {"3.17-loop-boundary", "3.17", "Loop subdivision on a border", {"3.8"}, loopBoundary},
        {"3.18-loop", "3.18", "Loop subdivision", {"3.8"}, loop},
        {"3.19-sqrt3-steps", "3.19", "\u221a3 subdivision: insert, then flip", {"3.9"}, sqrt3Steps},
        {"3.20-sqrt3", "3.20", "\u221a3 subdivision", {"3.9"}, sqrt3},
        {"3.21-catmull-steps", "3.21", "The steps of Catmull-Clark subdivision", {"3.10"}, catmullSteps},
        {"3.22-catmull-split", "3.22", "Faces of any size become quads", {"3.10"}, catmullSplit},
        {"3.23-catmull-cube", "3.23", "Catmull-Clark subdivision of a cube", {"3.10"}, catmullCube},
        {"3.24-catmull", "3.24", "Catmull-Clark subdivision", {"3.10"}, catmull},
    };
}

}  // namespace mw::figures
