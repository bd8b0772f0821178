// Figures of chapter 2 about the structures: face-based, winged edge, half-edge, adjacency.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/figures/drawn_mesh.h"
#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/catalog/catalog.h"
#include "core/mesh/records.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangle_adjacency.h"
#include "core/steps/stepper.h"

namespace mw::figures {
namespace {

using To = RecordLink::To;

std::string nameOf(RecordLink l)
{
    const char* kind[] = {"", "vertex ", "edge ", "face ", "half-edge "};
    return l.to == To::Nothing ? "\u2013" : kind[size_t(l.to)] + std::to_string(l.index);
}

void rows(TablePanel& t, const Record& r, const Page& page, bool rule = true, bool labels = true)
{
    if (rule) t.rule();
    t.row({{r.type, page.ink(Ink::Focus)}, "", {nameOf(r.of), page.ink(Ink::Focus)}});
    for (const Record::Field& f : r.fields) t.row({"  " + f.name, labels ? f.label : "", nameOf(f.link)});
}

RecordLink linkOf(const Record& r, std::string_view name)
{
    for (const Record::Field& f : r.fields)
        if (f.name == name) return f.link;
    return {};
}

glm::dvec3 normalOf(const Mesh& m, uint32_t face)
{
    return glm::dvec3(m.faceNormals()[face]);
}

void faceBased(Page& page)
{
    const Mesh cow = cow3(1400);
    const HalfedgeWalk walk(cow);
    const uint32_t face = nearestFace(cow, {0.4, 1.1, 0.05});
    const Record r = faceRecord(walk, cow, face);
    Space& s = page.space("triangle " + std::to_string(face) + " of the cow and its neighbours", {460, 400});
    s.put(cow);
    double longest = 0;
    std::vector<double> corners, beyond;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = cow.face(face)[i], b = cow.face(face)[(i + 1) % 3];
        longest = std::max(longest, glm::distance(s.at(a), s.at(b)));
    }
    closeUp(s, s.centre(face), normalOf(cow, face), 1.25 * longest);
    s.faces({face}, glm::vec4(glm::vec3(page.ink(Ink::Focus)), 0.75f));
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t v = cow.face(face)[i], t = r.fields[3 + i].link.index;
        s.faces({t}, glm::vec4(glm::vec3(page.ink(Ink::Neighbour)), 0.6f));
        s.words(s.at(v), "p" + std::to_string(i + 1), {page.ink(Ink::Text), Beside::Auto, 18, true});
        s.words(s.centre(t), "t" + std::to_string(i + 1), {page.ink(Ink::Text), Beside::On, 18, true});
        s.disc(s.at(v), page.ink(Ink::Text), 9);
        corners.push_back(v);
        for (const uint32_t u : cow.face(t)) beyond.push_back(u);
    }
    TablePanel& t = page.table("its record", {"field", "", "names"});
    rows(t, r, page, false);
    for (size_t i = 0; i < 3; ++i) rows(t, faceRecord(walk, cow, r.fields[3 + i].link.index), page);
    page.numbers("p", corners);
    page.numbers("corners of t1 t2 t3", beyond);
}

/// What a one-ring walk has done up to a step.
struct Walked {
    std::vector<uint32_t> faces, ring;
    std::vector<std::pair<uint32_t, uint32_t>> refused;  // from, the one that lacks the vertex
    bool closed = false;
};

Walked walked(const Mesh& m, uint32_t v, size_t triangles)
{
    const Operation& op = operation("one-ring-walk");
    Stepper stepper(stepping(op, m, parsed(op.parameters, "vertex=" + std::to_string(v))));
    Walked w;
    while (stepper.forward()) {
        const StepRecord& s = stepper.step();
        if (s.phase == "visit" && w.faces.size() == triangles) break;
        for (const Focus& f : s.focus) {
            const bool visits = s.phase == "start" || s.phase == "visit";
            if (visits && f.kind == ElementKind::Face && f.role == Role::Current) w.faces.push_back(f.index);
            if (visits && f.kind == ElementKind::Vertex && f.role == Role::New) w.ring.push_back(f.index);
            if (s.phase == "refuse" && f.kind == ElementKind::Face && f.role == Role::Rejected) w.refused.emplace_back(w.faces.back(), f.index);
        }
        w.closed = w.closed || s.phase == "close";
    }
    return w;
}

void drawWalk(Page& page, const Mesh& grid, const Walked& w, const std::string& caption)
{
    Drawing& d = page.drawing(caption, {440, 400});
    d.margin = 12;
    for (const uint32_t f : w.faces) fillFace(d, grid, f, page.tint(page.ink(Ink::Neighbour), 0.3f));
    drawEdges(d, grid, Pen(page.ink(Ink::Removed), 1.2f));
    for (size_t i = 0; i + 1 < w.faces.size() + (w.closed ? 1 : 0); ++i) {
        const At a = centreOf(grid, w.faces[i]), b = centreOf(grid, w.faces[(i + 1) % w.faces.size()]);
        const At out(1.28 * a.p), to(1.28 * b.p);  // beside the numbers
        d.arrow(At(0.5 * (a.p + out.p)), At(0.5 * (b.p + to.p)), page.ink(Ink::Focus), 2.5f);
    }
    for (const auto& [from, lacks] : w.refused)
        d.line(At(1.3 * centreOf(grid, from).p), At(0.88 * centreOf(grid, lacks).p), Pen(page.ink(Ink::Rejected), 2).dashed().arrow());
    for (size_t i = 0; i < w.faces.size(); ++i)
        d.words(At(0.8 * centreOf(grid, w.faces[i]).p), std::to_string(i + 1), {page.ink(Ink::Focus), Beside::On, 16, true, true});
    for (size_t i = 0; i < w.ring.size(); ++i) {
        d.disc(placeOf(grid, w.ring[i]), page.ink(Ink::New), 22);
        d.words(placeOf(grid, w.ring[i]), std::to_string(i + 1), {page.ink(Ink::Panel), Beside::On, 14, true, false});
    }
    d.disc({0, 0}, page.ink(Ink::Text), 12);
    d.words({0, 0}, "v", {page.ink(Ink::Text), Beside::Right, 18, true});
    d.lineKey(page.ink(Ink::Focus), "triangle to triangle")
        .lineKey(page.ink(Ink::Rejected), "refused: lacks v")
        .key(page.ink(Ink::New), "ring, as collected");
}

void oneRing(Page& page)
{
    const Mesh grid = hexagonGrid(2);
    const Walked third = walked(grid, 0, 3), all = walked(grid, 0, none);
    drawWalk(page, grid, third, "after " + countText(third.faces.size(), "triangle") + " of " + std::to_string(all.faces.size()));
    drawWalk(page, grid, all,
             "the end: " + countText(all.faces.size(), "triangle") + ", " + countText(all.ring.size(), "vertex", "vertices") + ", " +
                 countText(all.refused.size(), "refusal"));
    page.number("valence", grid.rings().neighboursOf(0).size());
    page.number("triangles", all.faces.size());
    page.number("vertices", all.ring.size());
    page.number("refusals", all.refused.size());
    page.number("triangles at step", third.faces.size());
}

/// The cow seen at one of its edges, the same in both figures.
struct PickedEdge {
    Mesh cow = cow4();
    HalfedgeWalk walk{cow};
    uint32_t halfedge;
    /// An upright edge of its flank whose first half-edge leads upwards.
    PickedEdge() : halfedge(0)
    {
        double least = 1e9;
        for (uint32_t h = 0; h < walk.size(); h += 2) {
            const glm::dvec3 p(cow.positions()[walk.source(h)]), q(cow.positions()[walk.target(h)]);
            const double away = glm::distance(0.5 * (p + q), glm::dvec3(0.4, 1.05, -0.2));
            if (away >= least || q.y - p.y < 0.9 * glm::distance(p, q)) continue;
            least = away;
            halfedge = h;
        }
    }
    Space& view(Page& page, const std::string& caption) const
    {
        Space& s = page.space(caption, {470, 430});
        s.put(cow);
        const uint32_t p = walk.source(halfedge), q = walk.target(halfedge);
        const glm::dvec3 n = normalOf(cow, walk.face(halfedge)) + normalOf(cow, walk.face(halfedge ^ 1));
        closeUp(s, middleOf(cow, p, q).p, n, 1.45 * glm::distance(s.at(p), s.at(q)));
        s.words(s.at(p), "P", {page.ink(Ink::Text), Beside::Below, 19, true});
        s.words(s.at(q), "Q", {page.ink(Ink::Text), Beside::Above, 19, true});
        s.words(s.centre(walk.face(halfedge)), "L", {page.ink(Ink::Neighbour), Beside::On, 22, true});
        s.words(s.centre(walk.face(halfedge ^ 1)), "R", {page.ink(Ink::Neighbour), Beside::On, 22, true});
        return s;
    }
};

void wingedEdge(Page& page)
{
    const PickedEdge e;
    const uint32_t h = e.halfedge, edge = e.walk.ofEdge(h);
    Space& s = e.view(page, "edge " + std::to_string(edge) + " of the cow; both faces clockwise");
    const Record r = wingedEdgeRecord(e.walk, edge);
    s.arrow(s.at(e.walk.source(h)), s.at(e.walk.target(h)), page.ink(Ink::Focus), 4);
    std::vector<double> ends;
    const glm::dvec3 middle = middleOf(e.cow, e.walk.source(h), e.walk.target(h)).p;
    for (const auto& [field, label] :
         {std::pair("left_prev", "a"), std::pair("left_next", "b"), std::pair("right_prev", "c"), std::pair("right_next", "d")}) {
        const uint32_t other = linkOf(r, field).index, u = e.walk.source(2 * other), v = e.walk.target(2 * other);
        s.edges({u, v}, page.ink(Ink::New), 5);
        const glm::dvec3 at = middleOf(e.cow, u, v).p;
        s.words(At(at + 0.16 * (at - middle)), label, {page.ink(Ink::New), Beside::On, 19, true});
        ends.push_back(u);
        ends.push_back(v);
    }
    TablePanel& t = page.table("its records", {"field", "", "names"});
    rows(t, r, page, false);
    rows(t, wingedVertexRecord(e.walk, e.walk.source(h)), page);
    rows(t, wingedVertexRecord(e.walk, e.walk.target(h)), page);
    rows(t, wingedFaceRecord(e.walk, e.walk.face(h)), page);
    rows(t, wingedFaceRecord(e.walk, e.walk.face(h ^ 1)), page);
    page.numbers("ends of a b c d", ends);
    page.numbers("P Q", std::vector<uint32_t>{e.walk.source(h), e.walk.target(h)});
    page.numbers("corners of L", std::vector<uint32_t>(e.cow.face(e.walk.face(h)).begin(), e.cow.face(e.walk.face(h)).end()));
    page.numbers("corners of R", std::vector<uint32_t>(e.cow.face(e.walk.face(h ^ 1)).begin(), e.cow.face(e.walk.face(h ^ 1)).end()));
}

/// An arrow for a half-edge of a mesh in space, set into its face.
void halfedgeArrow(Space& s, const HalfedgeWalk& walk, uint32_t h, const Pen& pen, const std::string& label, double share = 0.13, double along = 0.5)
{
    const auto [a, b] = inset(s.at(walk.source(h)), s.at(walk.target(h)), s.centre(walk.face(h)), share, 0.1);
    s.line(a, b, pen.arrow());
    s.words(At(glm::mix(glm::mix(a.p, b.p, along), s.centre(walk.face(h)), 0.22)), label, {pen.color, Beside::On, 17, true});
}

void halfEdge(Page& page)
{
    const PickedEdge e;
    const HalfedgeWalk& w = e.walk;
    const uint32_t h = e.halfedge, g = w.pair(h);
    Space& s = e.view(page, "half-edge " + std::to_string(h) + " of the cow");
    halfedgeArrow(s, w, h, Pen(page.ink(Ink::Focus), 3.5f), "PQ");
    halfedgeArrow(s, w, g, Pen(page.ink(Ink::Rejected), 3), "QP");
    halfedgeArrow(s, w, w.next(h), Pen(page.ink(Ink::New), 3), "b");
    halfedgeArrow(s, w, w.prev(h), Pen(page.ink(Ink::New), 3), "a");
    TablePanel& t = page.table("the records", {"field", "", "names"});
    rows(t, halfedgeRecord(w, h), page, false);
    rows(t, halfedgeRecord(w, g), page, true, false);
    rows(t, halfedgeVertexRecord(w, w.target(h)), page);
    rows(t, halfedgeFaceRecord(w, w.face(h)), page);
    const Record r = halfedgeRecord(w, h);
    const uint32_t b = linkOf(r, "next").index, a = linkOf(r, "prev").index, pair = linkOf(r, "pair").index;
    page.numbers("PQ", std::vector<uint32_t>{w.source(h), w.target(h)});
    page.numbers("pair", std::vector<uint32_t>{w.source(pair), w.target(pair)});
    page.numbers("next b", std::vector<uint32_t>{w.source(b), w.target(b)});
    page.numbers("prev a", std::vector<uint32_t>{w.source(a), w.target(a)});
    page.numbers("corners of L", std::vector<uint32_t>(e.cow.face(w.face(h)).begin(), e.cow.face(w.face(h)).end()));
    page.number("vert", linkOf(r, "vert").index);
}

void halfEdgeFaces(Page& page)
{
    const Mesh grid = hexagonGrid(1);
    const HalfedgeWalk w(grid);
    Drawing& d = page.drawing("half-edges run anticlockwise in every face; those of a pair run opposite ways", {560, 500});
    for (uint32_t f = 0; f < grid.faceCount(); ++f) fillFace(d, grid, f, page.tint(page.ink(Ink::Neighbour), 0.08f));
    fillFace(d, grid, 0, page.tint(page.ink(Ink::Focus), 0.25f));
    drawEdges(d, grid, Pen(page.ink(Ink::Removed), 1.5f));
    double least = 1e9;
    size_t opposite = 0, inner = 0;
    for (uint32_t h = 0; h < w.size(); ++h) {
        const uint32_t f = w.face(h);
        if (f == none) continue;
        const glm::dvec3 a = placeOf(grid, w.source(h)).p, b = placeOf(grid, w.target(h)).p, c = centreOf(grid, f).p;
        least = std::min(least, (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        inner += w.face(h ^ 1) != none;
        opposite += w.face(h ^ 1) != none && w.source(h) == w.target(h ^ 1) && w.target(h) == w.source(h ^ 1);
        const auto [p, q] = inset(a, b, c, 0.2, 0.08);
        d.arrow(p, q, f == 0 ? page.ink(Ink::Focus) : page.ink(Ink::Line), f == 0 ? 3.f : 2.f);
    }
    const uint32_t e1 = w.next(w.ofFace(0)), e2 = w.next(e1), e3 = w.prev(e1);
    TablePanel& t = page.table("in the marked triangle", {"half-edge", "next", "prev", "pair"});
    const auto name = [&](uint32_t h) { return h == e1 ? "e1" : h == e2 ? "e2" : "e3"; };
    for (const uint32_t h : {e1, e2, e3}) {
        const At m = middleOf(grid, w.source(h), w.target(h));
        d.words(At(glm::mix(m.p, centreOf(grid, 0).p, 0.5)), name(h), {page.ink(Ink::Focus), Beside::On, 18, true});
        const uint32_t pair = w.pair(h), beyond = w.face(pair);
        std::string pairName = name(h) + std::string("\u2032");
        if (beyond != none) d.words(At(glm::mix(m.p, centreOf(grid, beyond).p, 0.5)), pairName, {page.ink(Ink::Line), Beside::On, 18, true});
        if (beyond == none) pairName += ", no face";
        t.row({name(h), name(w.next(h)), name(w.prev(h)), pairName});
    }
    page.number("least area on the left", least);
    page.number("half-edges with a face on both sides", inner);
    page.number("of these opposite to their pair", opposite);
    page.number("next of e1 is e2 and prev is e3", w.next(e1) == e2 && w.prev(e1) == e3 && w.next(e3) == e1);
}

void adjacencyPrimitive(Page& page)
{
    const Mesh cow = cow3(1400);
    const Array<uint32_t> indices = adjacencyIndices(cow);
    const uint32_t face = nearestFace(cow, {0.4, 1.1, 0.05});
    const std::vector<uint32_t> v(indices.begin() + 6 * ptrdiff_t(face), indices.begin() + 6 * ptrdiff_t(face) + 6);
    Space& s = page.space("triangle " + std::to_string(face) + " of the cow with the vertices beyond its sides", {430, 390});
    s.put(cow);
    double longest = 0;
    for (size_t i = 0; i < 6; ++i) longest = std::max(longest, glm::distance(s.at(v[i]), s.at(v[(i + 2) % 6])));
    closeUp(s, s.centre(face), normalOf(cow, face), 0.78 * longest);
    s.faces({face}, glm::vec4(glm::vec3(page.ink(Ink::Focus)), 0.75f));
    s.edges({v[0], v[2], v[2], v[4], v[4], v[0]}, page.ink(Ink::Focus), 4);
    s.edges({v[0], v[1], v[1], v[2], v[2], v[3], v[3], v[4], v[4], v[5], v[5], v[0]}, page.ink(Ink::Neighbour), 4);
    for (size_t i = 0; i < 6; ++i) {
        s.disc(s.at(v[i]), page.ink(i % 2 ? Ink::Neighbour : Ink::Focus), 11);
        s.words(s.at(v[i]), "V" + std::to_string(i), {page.ink(Ink::Text), Beside::Auto, 18, true});
    }
    page.numbers("V0 to V5", v);
    page.numbers("corners", std::vector<uint32_t>(cow.face(face).begin(), cow.face(face).end()));
    const auto third = [&](uint32_t a, uint32_t b) {
        for (uint32_t f = 0; f < cow.faceCount(); ++f)
            if (f != face && std::ranges::count(cow.face(f), a) && std::ranges::count(cow.face(f), b))
                for (const uint32_t u : cow.face(f))
                    if (u != a && u != b) return u;
        return none;
    };
    page.numbers("beyond V0V2, V2V4, V4V0", std::vector<uint32_t>{third(v[0], v[2]), third(v[2], v[4]), third(v[4], v[0])});
    page.row();
    // Two triangles at an edge, by the angle each is folded down.
    std::vector<double> facing;
    const auto folded = [&](double left, double right, bool both, const std::string& kind) {
        const auto down = [](double a) { return glm::vec3(float(std::cos(a)), float(-std::sin(a)), 0); };
        Array<glm::vec3> p{{0, 0, 0.9f}, {0, 0, -0.9f}, glm::vec3(-1, 1, 1) * down(left), down(right)};
        Array<uint32_t> t{0, 1, 2};
        if (both) t.insert(t.end(), {1, 0, 3});
        const Mesh m = Mesh::triangles(std::move(p), std::move(t));
        Space& k = page.space("", {290, 260});
        k.look(-28, 22);
        k.put(m);
        k.edges({0, 1}, page.ink(Ink::Focus), 5);
        Camera c = k.frame.camera;
        c.target = glm::dvec3(0);
        const glm::dvec3 eye = glm::normalize(c.eye());
        std::string text;
        for (uint32_t f = 0; f < m.faceCount(); ++f) {
            const glm::dvec3 n = normalOf(m, f);
            const double towards = glm::dot(n, eye);
            k.arrow(k.centre(f), k.centre(f) + 0.8 * n, page.ink(towards > 0 ? Ink::New : Ink::Removed), 3);
            k.label(k.centre(f) + 0.8 * n, "n" + std::to_string(f + 1), page.ink(Ink::Text), Beside::Auto, 16, true);
            text += std::string(f ? ", " : "") + "n" + std::to_string(f + 1) + "\u00b7view = " + shortNumber(std::round(100 * towards) / 100);
            facing.push_back(towards);
        }
        if (both) {
            const double angle = std::acos(std::clamp(glm::dot(normalOf(m, 0), normalOf(m, 1)), -1.0, 1.0)) * 180 / M_PI;
            text += ", " + std::to_string(int(std::lround(angle))) + "\u00b0 apart";
            facing.push_back(angle);
        }
        k.caption = kind + ": " + (both ? text : "the neighbour is missing");
    };
    folded(0.2, 1.75, true, "silhouette");
    folded(0.75, 0.45, true, "crease");
    folded(0.15, 0, false, "border");
    page.numbers("n1.view, n2.view, angle", facing);
}

void adjacencyFromHalfedges(Page& page)
{
    const Mesh rock = rockpatch();
    const HalfedgeWalk w(rock);
    const Array<uint32_t> indices = adjacencyIndices(rock);
    // The inner one that is widest beside all that must be seen with it, so that its labels have room; the largest at the border.
    uint32_t inner = none, border = none;
    double largest = 0, widest = 0;
    for (uint32_t f = 0; f < rock.faceCount(); ++f) {
        int missing = 0;
        for (size_t k = 0; k < 3; ++k) missing += indices[6 * size_t(f) + 2 * k + 1] == indices[6 * size_t(f) + 2 * k];
        const auto at = [&](size_t k) { return glm::dvec3(rock.positions()[rock.face(f)[k]]); };
        const double area = glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
        if (missing == 0) {
            double reach = 0, side = 0;
            for (size_t k = 0; k < 6; ++k) {
                reach = std::max(reach, glm::distance(glm::dvec3(rock.positions()[indices[6 * size_t(f) + k]]), centreOf(rock, f).p));
                side = std::max(side, glm::distance(at(k % 3), at((k + 1) % 3)));
            }
            if (area / side / reach > widest) widest = area / side / reach, inner = f;
        }
        if (missing != 1 || area < largest) continue;
        border = f;
        largest = area;
    }
    std::vector<double> agree;
    for (const uint32_t face : {inner, border}) {
        const uint32_t* v = &indices[6 * size_t(face)];
        Space& s = page.space(face == inner ? "an inner triangle" : "a border triangle: a missing neighbour repeats a vertex", {430, 400});
        s.put(rock);
        double longest = 0;
        for (size_t i = 0; i < 6; ++i) longest = std::max(longest, glm::distance(s.at(v[i]), s.centre(face)));
        closeUp(s, s.centre(face), normalOf(rock, face), 1.3 * longest);
        s.faces({face}, glm::vec4(glm::vec3(page.ink(Ink::Focus)), 0.6f));
        std::vector<std::string> names(6);
        for (size_t i = 0; i < 6; ++i)
            for (size_t k = 0; k < 6; ++k)
                if (v[k] == v[i] && names[i].find("V" + std::to_string(k)) == std::string::npos)
                    names[i] += (names[i].empty() ? "V" : " = V") + std::to_string(k);
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = v[2 * k], b = v[(2 * k + 2) % 6], heH = w.between(a, b)[0], out = w.pair(heH);
            halfedgeArrow(s, w, heH, Pen(page.ink(Ink::Focus), 3), k == 0 ? "heH" : "", 0.13, 0.25);
            uint32_t found = a;
            if (w.face(out) != none) {
                halfedgeArrow(s, w, out, Pen(page.ink(Ink::Rejected), 2.5f), k == 0 ? "opp" : "", 0.13, 0.25);
                halfedgeArrow(s, w, w.next(out), Pen(page.ink(Ink::Neighbour), 2.5f), k == 0 ? "next" : "");
                found = w.target(w.next(out));
            }
            agree.push_back(found == v[2 * k + 1]);
        }
        for (size_t i = 0; i < 6; ++i) {
            const bool again = names[i].find('=') != std::string::npos;
            if (again && i % 2) continue;  // told beside the vertex it repeats
            s.disc(s.at(v[i]), page.ink(i % 2 ? Ink::Neighbour : Ink::Focus), 10);
            s.words(s.at(v[i]), names[i], {page.ink(again ? Ink::Offender : Ink::Text), Beside::Auto, 17, true});
        }
        page.numbers(face == inner ? "inner" : "border", std::vector<uint32_t>(v, v + 6));
    }
    page.numbers("target of next of opposite is V1, V3, V5", agree);
}

ElementSet answer(const Mesh& m, const char* query, const std::string& element)
{
    const Operation& op = operation("adjacency");
    return std::get<ElementSet>(apply(op, m, parsed(op.parameters, std::string("query=") + query + ",element=" + element)));
}

void mark(Drawing& d, const Mesh& m, const ElementSet& set, glm::vec4 color)
{
    if (set.kind == ElementKind::Vertex)
        for (const uint32_t v : set.indices) d.disc(placeOf(m, v), color, 14);
    if (set.kind == ElementKind::Edge)
        for (size_t i = 0; i + 1 < set.indices.size(); i += 2)
            d.line(placeOf(m, set.indices[i]), placeOf(m, set.indices[i + 1]), Pen(color, 5).gaps(2, 2));
    if (set.kind == ElementKind::Face)
        for (const uint32_t f : set.indices) fillFace(d, m, f, color, 0.08);
}

void queries(Page& page)
{
    page.letters(false);
    const Mesh grid = hexagonGrid(2);
    const uint32_t face = nearestFace(grid, {0.5, 0.3, 0});
    const ElementSet asked[] = {{ElementKind::Vertex, {0}}, {ElementKind::Edge, {0, 1}}, {ElementKind::Face, {face}}};
    const std::string elements[] = {"0", "", std::to_string(face)};
    const auto [a, b] = nearestEdge(grid, {0.5, 0, 0});
    const ElementSet edge{ElementKind::Edge, {a, b}};
    const char* words[] = {"vertex", "edge", "face"};
    const char* found[] = {"vertices", "edges", "faces"};
    std::vector<double> counts;
    for (size_t from = 0; from < 3; ++from) {
        if (from) page.row();
        for (size_t to = 0; to < 3; ++to) {
            const ElementSet set = answer(grid, (std::string(words[from]) + "-" + found[to]).c_str(),
                                          from == 1 ? std::to_string(a) + "~" + std::to_string(b) : elements[from]);
            const size_t count = set.kind == ElementKind::Edge ? set.indices.size() / 2 : set.indices.size();
            counts.push_back(double(count));
            const char letters[] = "VEF";
            Drawing& d =
                page.drawing(std::string(1, letters[from]) + ":\u2212" + letters[to] + "  " + countText(count, words[to], found[to]), {270, 235});
            d.margin = 14;
            const ElementSet& red = from == 1 ? edge : asked[from];
            if (red.kind == ElementKind::Face) mark(d, grid, red, page.ink(Ink::Offender));
            if (set.kind == ElementKind::Face) mark(d, grid, set, page.tint(page.ink(Ink::Neighbour), 0.75f));
            drawEdges(d, grid, Pen(page.ink(Ink::Removed), 1.3f));
            if (set.kind != ElementKind::Face) mark(d, grid, set, page.ink(Ink::Neighbour));
            if (red.kind != ElementKind::Face) mark(d, grid, red, page.ink(Ink::Offender));
        }
    }
    page.note("Red: the element asked about. Blue: the answer. E:\u2212E: all edges that meet an end; F:\u2212F: across edges.");
    page.numbers("counts", counts);
}

}  // namespace

std::vector<Figure> chapter2StructureFigures()
{
    return {
        {"2.07-face-based", "2.7", "Face-based structure", {"2.5"}, faceBased},
        {"2.08-onering-walk", "2.8", "One-ring walk on the face-based structure", {"2.5"}, oneRing},
        {"2.09-winged-edge", "2.9", "Winged edge", {"2.5"}, wingedEdge},
        {"2.10-half-edge", "2.10", "Half-edge", {"2.5"}, halfEdge},
        {"2.11-half-edge-faces", "2.11", "Half-edges of several faces", {"2.5", "2.6"}, halfEdgeFaces},
        {"2.14-adjacency-primitive", "2.14", "The triangle-adjacency primitive", {"2.9", "4.5"}, adjacencyPrimitive},
        {"2.15-adjacency-halfedges", "2.15", "Its six vertices from half-edges", {"2.9"}, adjacencyFromHalfedges},
        {"2.T1-adjacency-queries", "Table 2.1", "The nine adjacency queries", {"2.6"}, queries},
    };
}

}  // namespace mw::figures
