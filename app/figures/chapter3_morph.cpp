// Figures 3.30 to 3.36: morphs.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/catalog/others.h"
#include "core/mesh/topology.h"
#include "core/morph/morph_maps.h"
#include "core/morph/parametric_morph.h"
#include "core/morph/target.h"

namespace mw::figures {
namespace {

constexpr double pi = std::numbers::pi, ringRadius = 1, tubeRadius = 0.4;
const std::vector<double> fractions{0, 0.25, 0.5, 0.75, 1};

std::string partOf(double t)
{
    return "t = " + shortNumber(t);
}

Mesh openCylinder()
{
    return *meshOfSource("cylinder:caps=open,radius=0.6,height=2,segments=24,rings=16");
}

/// How far the vertices lie from the torus.
double offTorus(const Mesh& mesh)
{
    double worst = 0;
    for (const glm::vec3& p : mesh.positions())
        worst = std::max(worst, std::abs(std::hypot(std::hypot(double(p.x), double(p.z)) - ringRadius, double(p.y)) - tubeRadius));
    return worst;
}

/// Edges both of whose ends are taken.
template <class Taken>
std::vector<uint32_t> edgesWhere(const Mesh& mesh, const Taken& taken)
{
    std::vector<uint32_t> out;
    for (size_t i = 0; i < mesh.edges().size(); i += 2)
        if (taken(mesh.edges()[i]) && taken(mesh.edges()[i + 1])) out.insert(out.end(), {mesh.edges()[i], mesh.edges()[i + 1]});
    return out;
}

void parametricIdea(Page& page)
{
    const Mesh cylinder = openCylinder();
    const TorusShape torus{ringRadius, tubeRadius};
    const double theta = 0.7, y = 1.3, height = 2, phi = 2 * pi * y / height - pi;
    const glm::dvec3 on(0.6 * std::sin(theta), y - 1, 0.6 * std::cos(theta)), there = torus.at(theta, phi);
    Space& source = page.space("the cylinder", {300, 300});
    source.look(20, 22);
    source.put(cylinder);
    const auto domain = [&](const char* caption, const char* u, const char* v, double low, double high, glm::dvec2 at) -> Drawing& {
        Drawing& d = page.drawing(caption, {260, 300});
        d.polygon({{0, low}, {2 * pi, low}, {2 * pi, high}, {0, high}}, page.tint(page.series(0), 0.2f));
        for (int i = 0; i <= 8; ++i) {
            d.line({2 * pi * i / 8, low}, {2 * pi * i / 8, high}, Pen(page.ink(Ink::Faint), 1));
            d.line({0, low + (high - low) * i / 8}, {2 * pi, low + (high - low) * i / 8}, Pen(page.ink(Ink::Faint), 1));
        }
        d.label({pi, low}, u, page.ink(Ink::Text), Beside::Below);
        d.label({0, (low + high) / 2}, v, page.ink(Ink::Text), Beside::Left);
        d.disc(at, page.ink(Ink::Focus), 11);
        return d;
    };
    // Heights are drawn as long as the angle they become.
    const glm::dvec2 inSource(theta, 2 * pi * y / height), inTarget(theta, phi);
    Drawing& a = domain("its parameters", "\u03b8", "y", 0, 2 * pi, inSource);
    Drawing& b = domain("those of the torus", "\u03c9", "\u03c6", -pi, pi, inTarget);
    Space& target = page.space("the torus", {300, 300});
    target.look(20, 35);
    target.put(torusMesh(ringRadius, tubeRadius, 32, 16));
    source.disc(on, page.ink(Ink::Focus), 11);
    source.label(on, "P", page.ink(Ink::Text), Beside::Auto, 18, true);
    target.disc(there, page.ink(Ink::Focus), 11);
    target.label(there, "Q", page.ink(Ink::Text), Beside::Auto, 18, true);
    const Pen pen = Pen(page.ink(Ink::Focus), 2).arrow().gaps(8, 9);
    page.link(source, on, a, inSource, pen);
    page.link(a, inSource, b, inTarget, pen);
    page.link(b, inTarget, target, there, pen);
    page.note("\u03c9 = \u03b8, \u03c6 = 2\u03c0 y/H \u2212 \u03c0: \u03b8 = " + shortNumber(theta) + ", y = " + shortNumber(y) + " of " +
              shortNumber(height) + " becomes \u03c9 = " + shortNumber(theta) + ", \u03c6 = " + shortNumber(phi) + ".");
    page.number("off the torus", std::abs(std::hypot(std::hypot(there.x, there.z) - ringRadius, there.y) - tubeRadius));
    page.number("theta", theta);
    page.number("phi", phi);
}

void cylinderToTorus(Page& page)
{
    const Mesh m = applied("morph", "method=cylinder-torus,radius=1,tube=0.4", openCylinder());
    const auto seam = [&](uint32_t v) { return std::abs(m.positions()[v].x) < 1e-6f && m.positions()[v].z > 0; };
    std::vector<double> off;
    for (const double t : fractions) {
        Space& s = page.space(partOf(t), {250, 260});
        s.look(28, 30);
        const Mesh now = towardsTarget(m, t);
        s.put(now);
        s.edges(edgesWhere(now, seam), page.ink(Ink::Focus), 4);
        off.push_back(offTorus(now));
    }
    page.note("At t = 1 no vertex is farther from the torus than " + shortNumber(off.back()) + ".");
    page.numbers("off the torus", off);
}

void sphereToTorus(Page& page)
{
    const Mesh sphere = *meshOfSource("uv-sphere:segments=32,rings=20"), m = applied("morph", "method=sphere-torus,radius=1,tube=0.4", sphere);
    const auto pole = [&](uint32_t v) { return std::hypot(double(m.positions()[v].x), double(m.positions()[v].z)) < 1e-6; };
    std::vector<double> off, inner;
    for (const double t : fractions) {
        Space& s = page.space(partOf(t), {250, 260});
        s.look(28, 38);
        const Mesh now = towardsTarget(m, t);
        s.put(now);
        s.edges(edgesWhere(now, pole), page.ink(Ink::Focus), 4);
        double widest = 0, least = 1e9;
        for (uint32_t v = 0; v < now.vertexCount(); ++v)
            if (pole(v)) {
                const double r = std::hypot(double(now.positions()[v].x), double(now.positions()[v].z));
                widest = std::max(widest, r);
                least = std::min(least, r);
            }
        off.push_back(offTorus(now));
        inner.push_back(widest);
        page.number("uneven " + shortNumber(t), widest - least);
    }
    page.note("The poles open to rings and meet on the inner one, of radius R \u2212 r = " + shortNumber(inner.back()) + ".");
    page.numbers("off the torus", off);
    page.numbers("ring of the poles", inner);
}

Mesh turnedTetrahedron()
{
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.48, glm::normalize(glm::dvec3(-0.7, -0.9, 0)));
    Array<glm::vec3> p;
    for (const glm::dvec3& v : {glm::dvec3(1, 1, 1), glm::dvec3(1, -1, -1), glm::dvec3(-1, 1, -1), glm::dvec3(-1, -1, 1)})
        p.push_back(glm::vec3(0.8 * glm::dvec3(turn * glm::dvec4(v, 1))));
    return Mesh::triangles(p, Array<uint32_t>{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2});
}

Mesh bookCube()
{
    return triangulated(*meshOfSource("box:width=1.2,height=1.2,depth=1.2"));
}

Overlay overlaid(MorphMaps& maps)
{
    Overlay o(std::move(maps.maps[0]), std::move(maps.maps[1]));
    o.locate();
    for (const int of : {0, 1}) {
        while (o.locateMore(of, 1000)) {
        }
        o.trace(of, 0, uint32_t(o.input(of).map.edges()));
    }
    while (o.connect()) {
    }
    while (o.fill(1000)) {
    }
    return o;
}

/// The other mesh's vertices put into this one along rays from the centre, each into a triangle that it cuts in three.
Mesh withProjected(const Mesh& mesh, const Mesh& other)
{
    std::vector<glm::vec3> p(mesh.positions().begin(), mesh.positions().end());
    std::vector<uint32_t> t(mesh.cornerVertex().begin(), mesh.cornerVertex().end());
    for (const glm::vec3& q : other.positions()) {
        for (size_t i = 0; i < t.size(); i += 3) {
            const glm::dvec3 a(p[t[i]]), b(p[t[i + 1]]), c(p[t[i + 2]]), d(q);
            const double wa = glm::dot(d, glm::cross(b, c)), wb = glm::dot(d, glm::cross(c, a)), wc = glm::dot(d, glm::cross(a, b));
            if (wa <= 0 || wb <= 0 || wc <= 0) continue;
            const uint32_t fresh = uint32_t(p.size()), v[3] = {t[i], t[i + 1], t[i + 2]};
            p.push_back(glm::vec3((wa * a + wb * b + wc * c) / (wa + wb + wc)));
            t[i + 2] = fresh;
            t.insert(t.end(), {v[1], v[2], fresh, v[2], v[0], fresh});
            break;
        }
    }
    return Mesh::triangles(Array<glm::vec3>(p.begin(), p.end()), Array<uint32_t>(t.begin(), t.end()));
}

std::vector<uint32_t> added(const Mesh& before, const Mesh& after)
{
    std::vector<uint32_t> out;
    for (uint32_t v = uint32_t(before.vertexCount()); v < after.vertexCount(); ++v) out.push_back(v);
    return out;
}

void projectiveMap(Page& page)
{
    const Mesh tetra = turnedTetrahedron(), cube = bookCube();
    Space& both = page.space("tetrahedron and cube, one centre", {330, 320});
    both.look(30, 24);
    both.frame.options.shading = Shading::Wire;
    for (const Mesh* m : {&tetra, &cube}) {
        const NodeId node = both.put(*m);
        both.edges(std::vector<uint32_t>(m->edges().begin(), m->edges().end()), page.series(m == &tetra ? 0 : 1), 2.5f, node, false, true);
    }
    both.disc(glm::dvec3(0), page.ink(Ink::Text), 8);
    const auto split = [&](const Mesh& mesh, const Mesh& other, const char* caption, int color, const char* name) {
        const Mesh m = withProjected(mesh, other);
        Space& s = page.space(caption, {330, 320});
        s.look(30, 24);
        s.put(m);
        s.vertices(added(mesh, m), page.series(color), 11);
        page.numbers(name, std::vector<size_t>{m.vertexCount(), m.edges().size() / 2, m.faceCount()});
        page.number(std::string(name) + " Euler", m.topology().euler);
    };
    split(cube, tetra, "the tetrahedron's vertices on the cube", 0, "cube");
    split(tetra, cube, "the cube's vertices on the tetrahedron", 1, "tetrahedron");
    page.note("Each has 12 vertices, 30 edges and 20 faces now, but not the same faces: the edges of the two cross.");
}

void projectiveMorph(Page& page)
{
    const Mesh tetra = turnedTetrahedron(), cube = bookCube();
    MorphMaps maps = projectiveMaps(tetra, cube);
    const Overlay o = overlaid(maps);
    const Mesh m = morphed(o, maps.meshes[0], "cube");
    std::vector<double> volumes;
    for (const double t : fractions) {
        const Mesh now = towardsTarget(m, t);
        volumes.push_back(enclosedVolume(now));
        Space& s = page.space(partOf(t) + "\nvolume " + shortNumber(volumes.back()), {250, 270});
        s.look(30, 24);
        s.put(now);
    }
    page.note("Overlay: 4 + 8 vertices and " + std::to_string(o.crossings()) + " crossings of edges make " + std::to_string(o.vertices()) +
              " vertices, " + std::to_string(m.faceCount()) + " faces. Volume of the tetrahedron " + shortNumber(enclosedVolume(tetra)) +
              ", of the cube " + shortNumber(enclosedVolume(cube)) + ".");
    page.numbers("volume", volumes);
    page.number("tetrahedron", enclosedVolume(tetra));
    page.number("cube", enclosedVolume(cube));
    page.number("vertices", o.vertices());
    page.number("crossings", o.crossings());
    page.number("faces", m.faceCount());
    page.number("Euler", m.topology().euler);
}

/// Triangles between two rings of vertices that run the same way round, each given by how far round it is.
void between(Array<uint32_t>& t, const std::vector<std::pair<double, uint32_t>>& outer, const std::vector<std::pair<double, uint32_t>>& inner)
{
    const auto at = [](const std::vector<std::pair<double, uint32_t>>& r, size_t i) { return r[i % r.size()].first + double(i / r.size()); };
    size_t i = 0, k = 0;
    while (i < outer.size() || k < inner.size()) {
        const bool stepOuter = k >= inner.size() || (i < outer.size() && at(outer, i + 1) <= at(inner, k + 1));
        const uint32_t a = outer[i % outer.size()].second, b = inner[k % inner.size()].second;
        if (stepOuter)
            t.insert(t.end(), {a, outer[++i % outer.size()].second, b});
        else
            t.insert(t.end(), {a, inner[++k % inner.size()].second, b});
    }
}

/// Round a rectangle at a height, anticlockwise seen from above, beginning in the middle of the side towards +X.
std::vector<std::pair<double, uint32_t>> ring(Array<glm::vec3>& p, int n, double x, double z, double y, double offset = 0)
{
    std::vector<std::pair<double, uint32_t>> out;
    for (int i = 0; i < n; ++i) {
        const double s = (i + offset) / n, a = 2 * pi * s, c = std::cos(a), d = -std::sin(a),
                     k = 1 / std::pow(std::pow(std::abs(c), 6) + std::pow(std::abs(d), 6), 1 / 6.0);
        out.emplace_back(s, uint32_t(p.size()));
        p.push_back(glm::vec3(x * k * c, y, z * k * d));
    }
    return out;
}

Mesh colored(Mesh mesh, const std::function<glm::vec3(const glm::vec3&)>& color)
{
    Array<float> c;
    for (const glm::vec3& p : mesh.positions()) {
        const glm::vec3 x = color(p);
        c.insert(c.end(), {x.x, x.y, x.z});
    }
    return mesh.with(floatAttribute("color", Domain::Vertex, 3, c));
}

/// Open below: 6 vertices of the border, 6 under the roof, 3 on its ridge.
Mesh house()
{
    Array<glm::vec3> p{{1, 0, 0.7f}, {1, 0, -0.7f}, {0, 0, -0.7f}, {-1, 0, -0.7f}, {-1, 0, 0.7f}, {0, 0, 0.7f}};
    for (int i = 0; i < 6; ++i) p.push_back({p[size_t(i)].x, 1.f, p[size_t(i)].z});
    p.insert(p.end(), {glm::vec3(1, 1.7f, 0), glm::vec3(0, 1.7f, 0), glm::vec3(-1, 1.7f, 0)});
    Array<uint32_t> t;
    for (uint32_t i = 0; i < 6; ++i) {
        const uint32_t k = (i + 1) % 6;
        t.insert(t.end(), {i, k, 6 + k, i, 6 + k, 6 + i});
    }
    t.insert(t.end(), {6, 7, 12, 7, 8, 13, 7, 13, 12, 8, 9, 14, 8, 14, 13, 9, 10, 14, 10, 11, 13, 10, 13, 14, 11, 6, 12, 11, 12, 13});
    return colored(Mesh::triangles(p, t),
                   [](const glm::vec3& q) { return q.y > 0.99f ? glm::vec3(0.65f, 0.12f, 0.06f) : glm::vec3(0.8f, 0.62f, 0.3f); });
}

/// Open below: 20 vertices of the border, 8 round the bonnet, 4 round the roof.
Mesh car()
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    const auto low = ring(p, 20, 1.5, 0.65, 0), middle = ring(p, 8, 1.4, 0.6, 0.6, 0.5), top = ring(p, 4, 0.6, 0.42, 1.05, 0.5);
    between(t, low, middle);
    between(t, middle, top);
    t.insert(t.end(), {top[0].second, top[1].second, top[2].second, top[0].second, top[2].second, top[3].second});
    return colored(Mesh::triangles(p, t),
                   [](const glm::vec3& q) { return q.y > 0.9f ? glm::vec3(0.5f, 0.7f, 0.85f) : glm::vec3(0.08f, 0.2f, 0.6f); });
}

void edgesOf(Drawing& d, const DomainMesh& map, const Pen& pen)
{
    for (uint32_t e = 0; e < map.edges(); ++e) {
        const glm::dvec3 a = map.at(map.from(map.half(e))).point(), b = map.at(map.to(map.half(e))).point();
        d.line({a.x, a.y}, {b.x, b.y}, pen);
    }
}

glm::dvec2 flat(const DomainMesh& map, uint32_t v)
{
    const glm::dvec3 p = map.at(v).point();
    return {p.x, p.y};
}

void barycentricOverlay(Page& page)
{
    MorphMaps maps = diskMaps(house(), car(), true);
    const Overlay o = overlaid(maps);
    const DomainMesh &a = o.input(0).map, &b = o.input(1).map;
    Drawing& both = page.drawing("both maps on one disk, one border for both", {440, 420});
    edgesOf(both, b, Pen(page.series(1), 1.8f));
    edgesOf(both, a, Pen(page.series(0), 2.4f));
    both.lineKey(page.series(0), "house").lineKey(page.series(1), "car");
    // The inner vertex of the car that lies deepest in a triangle of the house.
    uint32_t best = none;
    double deepest = 0;
    glm::dvec3 weights(0);
    for (uint32_t v = 0; v < b.vertices(); ++v) {
        if (o.where(1, v).kind != Location::Kind::Triangle) continue;
        const glm::dvec3 w = o.placeInOther(1, v).weights;
        if (const double least = std::min({w.x, w.y, w.z}); least > deepest) deepest = least, best = v, weights = w;
    }
    const uint32_t* corner = a.corners().data() + 3 * o.where(1, best).index;
    const glm::dvec2 p = flat(b, best), c[3] = {flat(a, corner[0]), flat(a, corner[1]), flat(a, corner[2])};
    Drawing& one = page.drawing("a vertex of the car in a triangle of the house", {440, 420});
    const char* const names[] = {"A", "B", "C"};
    for (int k = 0; k < 3; ++k) one.polygon({c[(k + 1) % 3], c[(k + 2) % 3], p}, page.tint(page.series(2 + k), 0.35f));
    for (int k = 0; k < 3; ++k) {
        one.line(c[k], c[(k + 1) % 3], Pen(page.series(0), 2.6f));
        one.line(c[k], p, Pen(page.ink(Ink::Text), 1.6f).dashed());
        one.label(c[k], names[k], page.ink(Ink::Text));
        one.label((c[(k + 1) % 3] + c[(k + 2) % 3] + p) / 3.0, shortNumber(weights[k]), page.ink(Ink::Text), Beside::On, 14);
        one.disc(c[k], page.series(0), 10);
    }
    one.disc(p, page.series(1), 11);
    one.label(p, "P", page.ink(Ink::Text), Beside::Auto, 15, true);
    page.note("P = " + shortNumber(weights.x) + " A + " + shortNumber(weights.y) + " B + " + shortNumber(weights.z) +
              " C: the shares of the areas opposite to A, B and C. P cuts the triangle in three.");
    const glm::dvec2 mix = weights.x * c[0] + weights.y * c[1] + weights.z * c[2];
    page.number("sum of weights", weights.x + weights.y + weights.z);
    page.number("residual", glm::distance(mix, p));
    page.number("fold-overs", a.folds().size() + b.folds().size());
    page.numbers("house", std::vector<size_t>{house().vertexCount(), house().edges().size() / 2, house().faceCount()});
    page.numbers("car", std::vector<size_t>{car().vertexCount(), car().edges().size() / 2, car().faceCount()});
}

void barycentricMorph(Page& page)
{
    MorphMaps maps = diskMaps(house(), car(), true);
    const Overlay o = overlaid(maps);
    const Mesh m = morphed(o, maps.meshes[0], "car");
    const Attribute from = *m.find("color"), to = carriedVertexAttribute(o, 1, maps.meshes[1], "color");
    std::vector<double> areas;
    for (const double t : fractions) {
        const Mesh now = towardsTarget(m, t);
        Array<float> mixed;
        for (size_t v = 0; v < m.vertexCount(); ++v)
            for (int k = 0; k < 3; ++k) mixed.push_back(float((1 - t) * from.at(v, k) + t * to.at(v, k)));
        Space& s = page.space(partOf(t), {270, 240});
        s.look(32, 20);
        s.put(now.with(floatAttribute("color", Domain::Vertex, 3, std::move(mixed))));
        areas.push_back(surfaceArea(now));
    }
    page.note("One list of " + std::to_string(m.faceCount()) + " faces with " + std::to_string(m.vertexCount()) +
              " vertices carries both; colours go over as places do.");
    page.numbers("area", areas);
    page.number("house", surfaceArea(house()));
    page.number("car", surfaceArea(car()));
    page.number("vertices", m.vertexCount());
    page.number("faces", m.faceCount());
    page.number("Euler", m.topology().euler);
}

}  // namespace

std::vector<Figure> chapter3MorphFigures()
{
    return {
        {"3.30-parametric-morph-idea", "3.30", "Correspondence by parameters", {"3.16"}, parametricIdea},
        {"3.31-cylinder-torus", "3.31", "A cylinder becomes a torus", {"3.16"}, cylinderToTorus},
        {"3.32-sphere-torus", "3.32", "A sphere becomes a torus", {"3.16"}, sphereToTorus},
        {"3.33-projective-map", "3.33", "Vertices of each projected on the other", {"3.16"}, projectiveMap},
        {"3.34-projective-morph", "3.34", "A tetrahedron becomes a cube", {"3.16"}, projectiveMorph},
        {"3.35-barycentric-overlay", "3.35", "Two maps on one disk", {"3.16"}, barycentricOverlay},
        {"3.36-barycentric-morph", "3.36", "A house becomes a car", {"3.16"}, barycentricMorph},
    };
}

}  // namespace mw::figures
