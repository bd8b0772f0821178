// Figures 3.25 to 3.28: meshes laid out in the plane and on the sphere.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/catalog/others.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/parameterize/embed_planar.h"
#include "core/parameterize/embed_spherical.h"

namespace mw::figures {
namespace {

constexpr double pi = std::numbers::pi;

/// A disk with its place in the plane.
struct Laid {
    Mesh mesh;
    Disk disk;
    std::vector<glm::dvec2> places;
    explicit Laid(const char* source) : mesh(*meshOfSource(source)), disk(diskOf(mesh)), places(planarEmbedding(mesh)) {}

    bool onBorder(uint32_t v) const { return disk.unknown[v] == none; }
    /// The largest distance of an inner vertex from the mean of its neighbours.
    double residual() const
    {
        double worst = 0;
        for (uint32_t v = 0; v < places.size(); ++v) {
            if (onBorder(v)) continue;
            glm::dvec2 sum(0);
            const auto ring = mesh.rings().neighboursOf(v);
            for (const uint32_t w : ring) sum += places[w];
            worst = std::max(worst, glm::distance(sum / double(ring.size()), places[v]));
        }
        return worst;
    }
    /// Degrees from each border vertex to the next, round the origin.
    std::vector<double> steps() const
    {
        std::vector<double> out;
        for (size_t i = 0; i < disk.border.size(); ++i) {
            const glm::dvec2 a = places[disk.border[i]], b = places[disk.border[(i + 1) % disk.border.size()]];
            out.push_back(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)) * 180 / pi);
        }
        return out;
    }
    double offCircle() const
    {
        double worst = 0;
        for (const uint32_t v : disk.border) worst = std::max(worst, std::abs(glm::length(places[v]) - 1));
        return worst;
    }
    std::vector<size_t> counts() const { return {mesh.vertexCount(), mesh.edges().size() / 2, mesh.faceCount()}; }
    std::vector<uint32_t> borderEdges() const
    {
        std::vector<uint32_t> out;
        for (size_t i = 0; i < disk.border.size(); ++i) out.insert(out.end(), {disk.border[i], disk.border[(i + 1) % disk.border.size()]});
        return out;
    }
};

/// The map: all edges, the border stronger.
void net(Page& page, Drawing& d, const Laid& l, float width = 1.8f)
{
    const auto& e = l.mesh.edges();
    for (size_t i = 0; i < e.size(); i += 2) d.line(l.places[e[i]], l.places[e[i + 1]], Pen(page.ink(Ink::Line), width));
    const std::vector<uint32_t> border = l.borderEdges();
    for (size_t i = 0; i < border.size(); i += 2) d.line(l.places[border[i]], l.places[border[i + 1]], Pen(page.series(0), width + 1.4f));
}

/// The shares of the areas opposite to the corners (3.31), along the normal of the triangle.
glm::dvec3 sharesOf(const glm::dvec3& q, const std::array<glm::dvec3, 3>& p)
{
    const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    const auto opposite = [&](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(glm::cross(a - q, b - q), n) / glm::dot(n, n); };
    return {opposite(p[1], p[2]), opposite(p[2], p[0]), opposite(p[0], p[1])};
}

glm::dvec3 towardsEye(const Space& s)
{
    Camera c = s.frame.camera;
    c.target = glm::dvec3(0);
    return glm::normalize(c.eye());
}

/// Of the faces turned to the eye, with no side on the border, the one whose image is large and that is far to the right.
uint32_t wellSeen(const Laid& l, const Space& s)
{
    uint32_t best = 0;
    double most = -1e9;
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), towardsEye(s)));
    for (uint32_t f = 0; f < l.mesh.faceCount(); ++f) {
        const auto v = l.mesh.face(f);
        const auto at = [&](int k) { return glm::dvec3(l.mesh.positions()[v[k]]); };
        if (glm::dot(glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0))), towardsEye(s)) < 0.5) continue;
        if (std::count_if(v.begin(), v.end(), [&](uint32_t w) { return l.onBorder(w); }) > 1) continue;
        const glm::dvec2 a = l.places[v[1]] - l.places[v[0]], b = l.places[v[2]] - l.places[v[0]];
        const double score = a.x * b.y - a.y * b.x + 0.3 * glm::dot(at(0) + at(1) + at(2), right);
        if (score > most) most = score, best = f;
    }
    return best;
}

std::vector<double> asList(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

void embeddingIdea(Page& page)
{
    const Laid house("house");
    Space& s = page.space("the mesh in space", {430, 400});
    s.look(35, 28);
    s.put(house.mesh);
    s.edges(house.borderEdges(), page.series(0), 3.5f);
    const uint32_t face = wellSeen(house, s);
    s.faces({face}, page.ink(Ink::Focus));
    Drawing& d = page.drawing("its image in the plane", {430, 400});
    std::array<glm::dvec3, 3> p, image;
    for (size_t k = 0; k < 3; ++k) {
        p[k] = glm::dvec3(house.mesh.positions()[house.mesh.face(face)[k]]);
        image[k] = glm::dvec3(house.places[house.mesh.face(face)[k]], 0);
    }
    d.polygon({image[0], image[1], image[2]}, page.tint(page.ink(Ink::Focus), 0.55f));
    net(page, d, house);
    for (size_t k = 0; k < 3; ++k) {
        s.disc(p[k], page.ink(Ink::Text), 8);
        s.label(p[k], "P" + std::to_string(k + 1), page.ink(Ink::Text), Beside::Auto, 16, true);
        d.disc(image[k], page.ink(Ink::Text), 8);
        d.label(image[k], "S" + std::to_string(k + 1), page.ink(Ink::Text), Beside::Auto, 16, true);
    }
    const glm::dvec3 weights(0.5, 0.3, 0.2);
    const auto mix = [&](const std::array<glm::dvec3, 3>& c) { return weights.x * c[0] + weights.y * c[1] + weights.z * c[2]; };
    const glm::dvec3 q = mix(p), there = mix(image);
    s.disc(q, page.ink(Ink::New), 11);
    s.label(q, "Q", page.ink(Ink::Text), Beside::Below, 16, true);
    d.disc(there, page.ink(Ink::New), 11);
    d.label(there, "f(Q)", page.ink(Ink::Text), Beside::Auto, 16, true);
    page.link(s, q, d, there, Pen(page.ink(Ink::New), 2.2f).arrow().gaps(8, 9));
    const glm::dvec3 inSpace = sharesOf(q, p), inPlane = sharesOf(there, image);
    page.note("Q = " + shortNumber(inSpace.x) + " P1 + " + shortNumber(inSpace.y) + " P2 + " + shortNumber(inSpace.z) + " P3,  f(Q) = " +
              shortNumber(inPlane.x) + " S1 + " + shortNumber(inPlane.y) + " S2 + " + shortNumber(inPlane.z) + " S3. The border is blue in both.");
    page.numbers("shares in space", asList(inSpace));
    page.numbers("shares in the plane", asList(inPlane));
    page.numbers("house", house.counts());
    page.number("fold-overs", foldedFaces(house.mesh, house.places).size());
}

/// A spring from a to b, its coils along `across`.
void spring(Layer& layer, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& across, double coil, const Pen& pen)
{
    const double length = glm::distance(a, b), straight = std::min(0.18 * length, 3 * coil);
    const int coils = std::max(3, int((length - 2 * straight) / (1.1 * coil)));
    const glm::dvec3 along = (b - a) / length, side = coil * glm::normalize(across);
    std::vector<At> path{a, a + straight * along};
    for (int i = 0; i < coils; ++i) path.emplace_back(a + (straight + (length - 2 * straight) * (i + 0.5) / coils) * along + (i % 2 ? -side : side));
    path.emplace_back(b - straight * along);
    path.emplace_back(b);
    layer.path(std::move(path), pen);
}

/// A nail through a border vertex, from outside.
void pin(Page& page, Drawing& d, const glm::dvec2& at)
{
    const glm::dvec2 out = glm::normalize(at), side(-out.y, out.x);
    d.polygon({at, at + 0.13 * out + 0.055 * side, at + 0.13 * out - 0.055 * side}, page.ink(Ink::Focus));
    d.disc(at, page.ink(Ink::Focus), 11);
}

void springs(Page& page)
{
    const Laid house("house");
    const auto& e = house.mesh.edges();
    Space& s = page.space("a spring along every edge, joined at the vertices V", {470, 440});
    s.look(28, 20);
    s.put(house.mesh);
    s.wires(false);
    Drawing& d = page.drawing("the border pinned, the rest at rest at the vertices P", {470, 440});
    d.margin = 40;
    // Those behind the walls first, so that the others lie over them.
    for (const bool behind : {true, false})
        for (size_t i = 0; i < e.size(); i += 2) {
            const glm::dvec3 a(house.mesh.positions()[e[i]]), b(house.mesh.positions()[e[i + 1]]);
            if (s.hidden(0.5 * (a + b)) != behind) continue;
            spring(s, a, b, glm::cross(b - a, towardsEye(s)), 0.016, Pen(page.ink(behind ? Ink::Faint : Ink::Text), behind ? 1.f : 1.8f));
        }
    size_t drawn = 0;
    for (size_t i = 0; i < e.size(); i += 2, ++drawn) {
        const glm::dvec3 a(house.places[e[i]], 0), b(house.places[e[i + 1]], 0);
        spring(d, a, b, glm::cross(b - a, glm::dvec3(0, 0, 1)), 0.022, Pen(page.ink(Ink::Line), 1.8f));
    }
    size_t pinned = 0;
    for (uint32_t v = 0; v < house.mesh.vertexCount(); ++v) {
        const glm::dvec3 at(house.mesh.positions()[v]);
        const bool border = house.onBorder(v), behind = s.hidden(at);
        const std::string number = std::to_string(v + 1);
        s.disc(at, page.tint(page.ink(border ? Ink::Focus : Ink::Neighbour), behind ? 0.5f : 1.f), behind ? 7 : 10);
        s.words(at, "V" + number, {page.ink(behind ? Ink::Faint : Ink::Text), Beside::Auto, 14, !behind});
        if (border) {
            pin(page, d, house.places[v]);
            ++pinned;
        } else {
            d.disc(house.places[v], page.ink(Ink::Neighbour), 10);
        }
        const glm::dvec2 p = house.places[v];
        const Beside outside = std::abs(p.x) < 1e-6 ? (p.y > 0 ? Beside::Above : Beside::Below) : p.x > 0 ? Beside::Right : Beside::Left;
        d.words(border ? 1.13 * p : p, "P" + number, {page.ink(Ink::Text), border ? outside : Beside::Auto, 14, true});
    }
    d.key(page.ink(Ink::Focus), "pinned: " + std::to_string(pinned))
        .key(page.ink(Ink::Neighbour), "free: " + std::to_string(house.disk.inner.size()));
    page.number("springs", drawn);
    page.number("pinned", pinned);
    page.number("free", house.disk.inner.size());
    page.number("off the circle", house.offCircle());
    page.number("residual", house.residual());
}

void mapPanels(Page& page, const char* name, double azimuth, double elevation, int size)
{
    const Laid l(name);
    const std::string what = name;
    Space& s = page.space(
        "the " + what + ": " + std::to_string(l.disk.inner.size()) + " vertices inside, " + std::to_string(l.disk.border.size()) + " on the border",
        {500, 400});
    s.look(azimuth, elevation);
    s.put(l.mesh);
    s.edges(l.borderEdges(), page.series(0), 3.5f);
    s.numberVertices(page.ink(Ink::Text), page.ink(Ink::Faint), {}, size);
    const std::vector<double> steps = l.steps();
    Drawing& d = page.drawing("its map: steps of " + shortNumber(*std::max_element(steps.begin(), steps.end())) + "\u00b0 on the circle", {500, 400});
    d.arc({0, 0}, 1, 0, 2 * pi, Pen(page.ink(Ink::Faint), 1.2f).dashed());
    net(page, d, l);
    for (uint32_t v = 0; v < l.places.size(); ++v) {
        const glm::dvec2 p = l.places[v];
        const double angle = std::atan2(p.y, p.x) / (pi / 4);
        constexpr Beside round[] = {Beside::Right, Beside::AboveRight, Beside::Above, Beside::AboveLeft,
                                    Beside::Left,  Beside::BelowLeft,  Beside::Below, Beside::BelowRight};
        d.disc(p, l.onBorder(v) ? page.series(0) : page.ink(Ink::Text), l.onBorder(v) ? 9 : 7);
        d.words(p, std::to_string(v),
                {page.ink(Ink::Text), l.onBorder(v) ? round[(std::lround(angle) + 8) % 8] : Beside::Auto, size, false, true, 6});
    }
    const double residual = l.residual();
    const size_t folds = foldedFaces(l.mesh, l.places).size();
    page.note("The " + what + ": " + std::to_string(folds) + " of " + std::to_string(l.mesh.faceCount()) +
              " faces fold over; no inner vertex is farther from the mean of its neighbours than " + shortNumber(residual) + ".");
    page.numbers(what, l.counts());
    page.number(what + " inside", l.disk.inner.size());
    page.number(what + " border", l.disk.border.size());
    page.numbers(what + " steps", steps);
    page.number(what + " off the circle", l.offCircle());
    page.number(what + " fold-overs", folds);
    page.number(what + " residual", residual);
}

void barycentricMaps(Page& page)
{
    mapPanels(page, "house", 28, 20, 14);
    page.row();
    mapPanels(page, "car", -28, 32, 13);
}

/// Signed, by its three corners on the unit sphere (Van Oosterom and Strackee 1983).
double sphericalArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return 2 * std::atan2(glm::dot(a, glm::cross(b, c)), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

glm::dvec3 onSphere(double longitude, double latitude)
{
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

/// The shorter great circle between two places.
std::vector<At> greatArc(const glm::dvec3& a, const glm::dvec3& b, int parts = 16)
{
    std::vector<At> out;
    for (int i = 0; i <= parts; ++i) out.emplace_back(glm::normalize(glm::mix(a, b, double(i) / parts)));
    return out;
}

/// What is on the side of the eye of a line on the sphere.
void visible(Layer& layer, const std::vector<At>& line, const glm::dvec3& eye, const Pen& pen)
{
    std::vector<At> run;
    for (size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && glm::dot(line[i].p, eye) > 0.02) {
            run.push_back(line[i]);
            continue;
        }
        if (run.size() > 1) layer.path(run, pen);
        run.clear();
    }
}

/// A mesh and its places on the sphere.
struct Round {
    Mesh mesh;
    std::vector<glm::dvec3> places;

    glm::dvec3 corner(uint32_t f, int k) const { return places[mesh.face(f)[k]]; }
    glm::dvec3 middle(uint32_t f) const { return glm::normalize(corner(f, 0) + corner(f, 1) + corner(f, 2)); }
    double area(uint32_t f) const { return sphericalArea(corner(f, 0), corner(f, 1), corner(f, 2)); }
    glm::dvec3 normal(uint32_t f) const
    {
        const auto at = [&](int k) { return glm::dvec3(mesh.positions()[mesh.face(f)[k]]); };
        return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    /// The largest image where both angles are easily seen, of a face that is not underneath.
    uint32_t toShow() const
    {
        uint32_t best = 0;
        double most = 0;
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
            const glm::dvec2 at = sphericalCoordinates(middle(f)) * (180 / pi);
            if (at.x < 35 || at.x > 75 || at.y < 25 || at.y > 55 || normal(f).y < -0.2) continue;
            if (area(f) > most) most = area(f), best = f;
        }
        return best;
    }
};

void sphericalPanel(Page& page, Space& s, const Round& r, uint32_t face)
{
    const glm::dvec3 eye = towardsEye(s), p = r.middle(face);
    const glm::dvec2 angles = sphericalCoordinates(p);
    std::vector<At> corners;
    for (int k = 0; k < 3; ++k) {
        for (const At& a : greatArc(r.corner(face, k), r.corner(face, (k + 1) % 3)))
            if (corners.empty() || glm::distance(a.p, corners.back().p) > 1e-9) corners.push_back(a);
    }
    corners.pop_back();  // where it began
    s.polygon(corners, page.ink(Ink::Focus));
    const auto& e = r.mesh.edges();
    for (size_t i = 0; i < e.size(); i += 2) visible(s, greatArc(r.places[e[i]], r.places[e[i + 1]]), eye, Pen(page.ink(Ink::Line), 1.1f));
    std::vector<At> equator, alpha, delta;
    for (int i = 0; i <= 360; ++i) equator.emplace_back(onSphere(i * pi / 180, 0));
    for (int i = 0; i <= 60; ++i) alpha.emplace_back(onSphere(angles.x * i / 60, 0)), delta.emplace_back(onSphere(angles.x, angles.y * i / 60));
    visible(s, equator, eye, Pen(page.ink(Ink::Text), 1.6f).dashed());
    s.path(alpha, Pen(page.series(0), 4));
    s.path(delta, Pen(page.series(3), 4));
    const glm::dvec3 zero(0), foot = onSphere(angles.x, 0);
    s.line(zero, foot, Pen(page.ink(Ink::Text), 1.8f).dashed());
    s.line(zero, p, Pen(page.ink(Ink::Text), 1.8f).dashed());
    s.arrow(zero, glm::dvec3(0, 0, 1.35), page.ink(Ink::Text), 1.8f);
    s.arrow(zero, glm::dvec3(1.3, 0, 0), page.ink(Ink::Text), 1.8f);
    s.arrow(zero, glm::dvec3(0, 1.3, 0), page.ink(Ink::Text), 1.8f);
    s.label({0, 0, 1.35}, "z", page.ink(Ink::Text), Beside::Below, 15);
    s.label({1.3, 0, 0}, "x", page.ink(Ink::Text), Beside::Right, 15);
    s.label({0, 1.3, 0}, "y", page.ink(Ink::Text), Beside::Above, 15);
    s.disc(zero, page.ink(Ink::Text), 7);
    s.label(alpha[30], "\u03b1", page.series(0), Beside::Below, 18, true);
    s.label(delta[24], "\u03b4", page.series(3), Beside::Right, 18, true);
    s.disc(p, page.ink(Ink::New), 11);
    s.label(p, "P", page.ink(Ink::Text), Beside::Auto, 16, true);
}

void sphericalTriangle(Page& page)
{
    const Mesh fine = cow3();
    Round r{applied("decimate-quadric", ("ratio=" + std::to_string(250.0 / double(fine.faceCount()))).c_str(), fine), {}};
    r.places = sphericalEmbedding(r.mesh);
    const uint32_t face = r.toShow();
    const glm::dvec3 n = r.normal(face);
    Space& s = page.space("a closed mesh of " + countText(r.mesh.faceCount(), "triangle"), {450, 430});
    s.look(std::atan2(n.x, n.z) * 180 / pi, std::clamp(std::asin(n.y) * 180 / pi, 10.0, 50.0));
    s.put(r.mesh);
    s.faces({face}, page.ink(Ink::Focus));
    const glm::dvec2 angles = sphericalCoordinates(r.middle(face));
    Space& round = page.space("its map, all edges great circles", {450, 430});
    round.look(angles.x * 90 / pi, 18);
    round.put(sphereMesh(5));
    round.wires(false);
    round.smooth();
    sphericalPanel(page, round, r, face);
    const char* const names[] = {"A", "B", "C"};
    for (int k = 0; k < 3; ++k) {
        s.label(s.at(r.mesh.face(face)[k]), names[k], page.ink(Ink::Text), Beside::Auto, 15, true);
        round.label(r.corner(face, k), names[k], page.ink(Ink::Text), Beside::Auto, 15, true);
    }
    double sum = 0;
    size_t folds = 0;
    for (uint32_t f = 0; f < r.mesh.faceCount(); ++f) {
        sum += r.area(f);
        folds += glm::dot(r.corner(f, 0), glm::cross(r.corner(f, 1), r.corner(f, 2))) <= 0;
    }
    page.note("P: \u03b1 = " + shortNumber(angles.x * 180 / pi) + "\u00b0, \u03b4 = " + shortNumber(angles.y * 180 / pi) +
              "\u00b0. The images of all faces have the area " + shortNumber(sum / (4 * pi)) + " times 4\u03c0, " + std::to_string(folds) +
              " fold over: the sphere is covered once.");
    const glm::dvec3 back = onSphere(angles.x, angles.y);
    page.number("off the point of the angles", glm::distance(back, r.middle(face)));
    page.number("alpha", angles.x);
    page.number("delta", angles.y);
    page.number("area", sum);
    page.number("marked area", r.area(face));
    page.number("fold-overs", folds);
    page.number("Euler", r.mesh.topology().euler);
}

}  // namespace

std::vector<Figure> chapter3EmbeddingFigures()
{
    return {
        {"3.25-embedding-idea", "3.25", "A mesh and its image in the plane", {"3.11", "3.12"}, embeddingIdea},
        {"3.26-springs", "3.26", "Springs along the edges", {"3.12"}, springs},
        {"3.27-barycentric-map", "3.27", "Barycentric maps", {"3.12"}, barycentricMaps},
        {"3.28-spherical-triangle", "3.28", "A triangle and its spherical triangle", {"3.14"}, sphericalTriangle},
    };
}

}  // namespace mw::figures
