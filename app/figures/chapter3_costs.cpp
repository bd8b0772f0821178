// Figures 3.01 to 3.09: costs of vertices and edges, and what simplification does with them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "app/figures/figures.h"
#include "app/figures/models.h"
#include "core/mesh/rings.h"
#include "core/mesh/select.h"
#include "core/mesh/submesh.h"
#include "core/mesh/topology.h"
#include "core/metrics/fan.h"
#include "core/simplify/collapse_edge.h"
#include "core/steps/stepper.h"

namespace mw::figures {
namespace {

Table measured(const char* id, const Mesh& mesh, const char* parameters = "")
{
    const Operation& op = operation(id);
    return std::get<Table>(apply(op, mesh, parsed(op.parameters, parameters)));
}

/// Its middle up along +y, and wider by a factor.
Mesh upright(const Mesh& mesh, double across = 1)
{
    Array<glm::vec3> p(mesh.positions().begin(), mesh.positions().end());
    for (glm::vec3& v : p) v = {float(v.x * across), v.z, float(-v.y * across)};
    return mesh.withPositions(std::move(p));
}

struct Averaged {
    AveragePlane plane;
    double area = 0, meanLength = 0, longest = 0;
    std::vector<FaceMeasure> faces;
};

/// Of the faces at vertex 0, which are all there are.
Averaged averaged(const Mesh& fanMesh)
{
    Averaged a;
    glm::dvec3 sum(0);
    for (const FaceMeasure& f : faceMeasuresOf(fanMesh)) {
        a.faces.push_back(f);
        a.plane.add(f);
        sum += f.area * f.normal;
        a.area += f.area;
    }
    a.meanLength = glm::length(sum) / a.area;
    const glm::dvec3 v = fanMesh.positions()[0];
    for (const uint32_t w : fanMesh.rings().neighboursOf(0)) a.longest = std::max(a.longest, glm::distance(v, glm::dvec3(fanMesh.positions()[w])));
    return a;
}

/// A square of the average plane, its normal and the way of vertex 0 to it.
void showPlane(Page& page, Space& s, const Averaged& a, const glm::dvec3& v, double side)
{
    const glm::dvec3 n = a.plane.normal(), c = a.plane.point(), x = side * glm::normalize(glm::cross(n, glm::dvec3(0.4, 0.1, 1))),
                     y = glm::cross(n, x);
    s.path({c + x + y, c - x + y, c - x - y, c + x - y}, Pen(page.ink(Ink::New), 2).dashed(), true);
    const double d = a.plane.height(v);
    s.line(v, v - d * n, Pen(page.ink(Ink::Focus), 3));
    s.disc(v - d * n, page.ink(Ink::New), 8);
    s.disc(v, page.ink(Ink::Focus), 11);
}

void averagePlane(Page& page)
{
    const Mesh mesh = upright(fan(6, 1));
    const Averaged a = averaged(mesh);
    const glm::dvec3 v = mesh.positions()[0], n = a.plane.normal();
    Space& s = page.space("the fan of v and its average plane", {620, 470});
    s.look(20, 22);
    s.put(mesh);
    s.frame.options.xray = true;
    for (const FaceMeasure& f : a.faces) {
        s.disc(f.centroid, page.ink(Ink::Neighbour), 7);
        s.arrow(f.centroid, f.centroid + 0.35 * f.normal, page.ink(Ink::Neighbour), 1.8f);
    }
    showPlane(page, s, a, v, 1.05);
    s.arrow(a.plane.point(), a.plane.point() + 0.5 * n, page.ink(Ink::New), 2.6f);
    const double d = std::abs(a.plane.height(v));
    s.label(v, "v", page.ink(Ink::Focus), Beside::Above, 17, true);
    s.label(a.faces[4].centroid + 0.35 * a.faces[4].normal, "n_i", page.ink(Ink::Neighbour));
    s.label(a.faces[4].centroid, "p_i", page.ink(Ink::Neighbour));
    s.label(a.plane.point(), "p_avg", page.ink(Ink::New), Beside::BelowRight);
    s.label(v - 0.4 * d * n, "d = " + shortNumber(d), page.ink(Ink::Focus), Beside::Left);
    s.lineKey(page.ink(Ink::Neighbour), "centroids and normals of the faces").lineKey(page.ink(Ink::New), "n_avg, p_avg and the average plane");
    page.note("d = |n_avg \u00b7 (v \u2212 p_avg)| = " + shortNumber(d) + ", longest edge " + shortNumber(a.longest) + ": cost " +
              shortNumber(d / a.longest) + ". The sum of A n over the sum of A has the length " + shortNumber(a.meanLength) + " and is made unit.");
    page.number("d", d);
    page.number("length of the mean", a.meanLength);
    page.number("cost", d / a.longest);
    page.number("unit normal", glm::length(n));
}

void sameDistance(Page& page)
{
    std::vector<double> distances, costs;
    for (const double across : {1.9, 0.55}) {
        const Mesh mesh = upright(fan(6, 0.9), across);
        const Averaged a = averaged(mesh);
        const double d = std::abs(a.plane.height(mesh.positions()[0]));
        const char* name = across > 1 ? "v" : "w";
        Space& s = page.space(std::string(name) + ": d = " + shortNumber(d) + ", d / longest edge = " + shortNumber(d / a.longest), {430, 320});
        s.look(20, 18);
        s.frame.options.xray = true;
        s.put(mesh);
        showPlane(page, s, a, mesh.positions()[0], 0.75 * across);
        s.label(mesh.positions()[0], name, page.ink(Ink::Focus), Beside::Above, 17, true);
        distances.push_back(d);
        costs.push_back(d / a.longest);
    }
    page.numbers("d", distances);
    page.numbers("d / longest edge", costs);
}

constexpr double patchAzimuth = 30, patchElevation = 25;

void planarity(Page& page)
{
    const Mesh mesh = rockpatch();
    const Table t = measured("vertex-planarity", mesh);
    Space& s = page.space("cost d / longest edge of each vertex; on the border it is not defined", {640, 500});
    s.look(patchAzimuth, patchElevation);
    s.put(mesh);
    s.heat(t, 0, 1, 0, true);
    std::vector<uint32_t> border;
    size_t undefined = 0;
    for (const auto& loop : mesh.topology().boundaryLoops) border.insert(border.end(), loop.begin(), loop.end());
    for (const double v : t.columns[0].values) undefined += std::isnan(v);
    s.vertices(border, glm::vec4(1), 7);
    s.key(glm::vec4(1), "on the border");
    page.number("border vertices", border.size());
    page.number("undefined", undefined);
    page.number("vertices", mesh.vertexCount());
}

void boundaryCost(Page& page)
{
    const Mesh whole = rockpatch();
    const Table t = measured("boundary-distance", whole);
    uint32_t v = 0;
    double best = -1;
    for (uint32_t i = 0; i < whole.vertexCount(); ++i)
        if (t.columns[0].values[i] > best) best = t.columns[0].values[i], v = i;
    const BorderNeighbours border = borderNeighboursOf(whole);
    const glm::dvec3 at = whole.positions()[v], p = whole.positions()[border.neighbour[2 * v]], q = whole.positions()[border.neighbour[2 * v + 1]];
    ElementSet near{ElementKind::Vertex, {v}};
    for (int i = 0; i < 4; ++i) near = grown(whole, near);
    std::vector<bool> named(whole.faceCount(), false);
    for (const uint32_t f : converted(whole, near, ElementKind::Face).indices) named[f] = true;
    const Mesh piece = splitFaces(whole, named).named;
    const glm::dvec3 normal = whole.vertexNormals()[v];
    Space& s = page.space("the border bends by d at v", {560, 430});
    s.look(glm::degrees(std::atan2(normal.x, normal.z)), glm::degrees(std::asin(std::clamp(normal.y, -1.0, 1.0))));
    s.put(piece);
    const glm::dvec3 foot = p + glm::dot(at - p, q - p) / glm::dot(q - p, q - p) * (q - p);
    s.line(p, q, Pen(page.ink(Ink::New), 2.6f));
    s.line(at, foot, Pen(page.ink(Ink::Focus), 3));
    s.line(at, p, Pen(page.ink(Ink::Neighbour), 3));
    s.line(at, q, Pen(page.ink(Ink::Neighbour), 3));
    for (const auto& [place, name] : {std::pair(p, "p"), std::pair(q, "q")}) {
        s.disc(place, page.ink(Ink::Neighbour), 10);
        s.label(place, name, page.ink(Ink::Neighbour), Beside::Auto, 17, true);
    }
    s.disc(at, page.ink(Ink::Focus), 11);
    s.label(at, "v", page.ink(Ink::Focus), Beside::Auto, 17, true);
    s.label(0.5 * (at + foot), "d", page.ink(Ink::Focus));
    const double direct = glm::length(glm::cross(at - p, q - p)) / glm::distance(p, q);
    page.note("d = |(v \u2212 p) \u00d7 (q \u2212 p)| / |q \u2212 p| = " + shortNumber(direct));
    page.number("d", best);
    page.number("d again", direct);
    page.number("to the foot", glm::distance(at, foot));
}

void edgeCost(Page& page)
{
    const Mesh mesh = rockpatch();
    const Table t = measured("edge-dihedral", mesh, "form=normalised,k1=1,k2=1");
    const auto [least, most] = std::minmax_element(t.columns[0].values.begin(), t.columns[0].values.end());
    Space& s = page.space("cost of each edge: angle / \u03c0 + length / longest", {640, 500});
    s.look(patchAzimuth, patchElevation);
    s.put(mesh);
    s.wires(false);
    s.heat(t, 0, 1, 0, true);
    page.number("edges", mesh.edges().size() / 2);
    page.number("values", t.columns[0].values.size());
    page.number("least", *least);
    page.number("most", *most);
    page.number("legend", 2.0);
}

/// V, E, F of a mesh as it is; vertices that no face uses are not counted.
std::string counts(const Mesh& m, std::array<double, 3>& out)
{
    const TopologyReport& t = m.topology();
    out = {double(t.vertices), double(t.edges), double(t.faces)};
    return "V " + std::to_string(t.vertices) + ", E " + std::to_string(t.edges) + ", F " + std::to_string(t.faces);
}

/// Before, hole, after of the first vertex that decimation takes out.
void removalRow(Page& page, const Mesh& mesh, const std::string& what, std::vector<double>& change, std::vector<double>& ring)
{
    const Operation& op = operation("decimate-vertices");
    Stepper steps(stepping(op, mesh, parsed(op.parameters, "threshold=0.01")));
    std::array<double, 3> before{}, hole{}, after{};
    while (steps.forward() && !steps.atEnd()) {
        const StepRecord step = steps.step();
        const Mesh now = std::get<Mesh>(valueOf(steps.value()));
        const bool pick = step.phase == "pick", open = step.phase == "hole", closed = step.phase == "retriangulate";
        if (!pick && !open && !closed) continue;
        std::array<double, 3>& n = pick ? before : open ? hole : after;
        const std::string text = counts(now, n);
        Space& s = page.space((pick ? what + ": " : open ? "hole: " : "after: ") + text, {290, 220});
        s.look(0, 0);
        s.put(now);
        std::vector<uint32_t> faces, outline;
        for (const Focus& f : step.focus) {
            if (f.kind == ElementKind::Face) faces.push_back(f.index);
            if (f.kind == ElementKind::Vertex && f.role == Role::Neighbour) outline.push_back(f.index);
            if (f.kind == ElementKind::Vertex && f.role == Role::Current) s.vertices({f.index}, page.ink(Ink::Focus), 13);
        }
        if (!faces.empty()) s.faces(faces, glm::vec4(glm::vec3(page.ink(closed ? Ink::New : Ink::Removed)), 0.35f));
        s.vertices(outline, page.ink(Ink::Neighbour), 9);
        if (closed) {
            ring.push_back(double(outline.size()));
            break;
        }
    }
    for (size_t i = 0; i < 3; ++i) change.push_back(after[i] - before[i]);
}

void vertexRemoval(Page& page)
{
    const Mesh convex = hexagonGrid(2);
    Array<glm::vec3> moved(convex.positions().begin(), convex.positions().end());
    for (const uint32_t v : convex.rings().neighboursOf(0))
        if (moved[v].x > 0.9f) moved[v].x = 0.35f;  // one of the ring comes near: it is no more convex, still a star
    const Mesh star = convex.withPositions(std::move(moved));
    std::vector<double> change, ring;
    removalRow(page, convex, "inside, convex ring", change, ring);
    page.row();
    removalRow(page, star, "inside, star", change, ring);
    page.row();
    removalRow(page, triangleGrid(4, 2), "on the border", change, ring);
    page.letters(false);
    page.numbers("change of V, E, F", change);
    page.numbers("ring", ring);
}

void edgeCollapse(Page& page)
{
    const Mesh before = triangleGrid(5, 4, 0.8);
    EdgeCollapser collapser(before);
    const uint32_t p = 14, q = 15;
    const EdgeCollapser::Judgement j = collapser.judge(p, q, CollapsePlace::Optimal);
    const glm::vec3 to = collapser.mesh().position(j.place);
    std::vector<uint32_t> gone{j.half / 3, collapser.mesh().twin(j.half) / 3};
    Array<glm::vec3> half(before.positions().begin(), before.positions().end());
    for (const uint32_t v : {p, q}) half[v] = glm::mix(half[v], to, 0.6f);
    const Mesh during = before.withPositions(std::move(half)), after = collapser.collapsed(j);
    std::array<double, 3> b{}, a{};
    const std::string textBefore = counts(before, b), textAfter = counts(after, a);
    const auto panel = [&](const Mesh& m, const std::string& caption) -> Space& {
        Space& s = page.space(caption, {360, 300});
        s.look(-28, 12);
        s.put(m);
        return s;
    };
    for (const bool first : {true, false}) {
        const Mesh& m = first ? before : during;
        Space& s = panel(m, first ? "before: " + textBefore : "both ends move to P'");
        s.faces(gone, glm::vec4(glm::vec3(page.ink(Ink::Offender)), 0.5f));
        s.edges({p, q}, page.ink(Ink::Focus), 4);
        s.disc(to, page.ink(Ink::New), 9);
        s.label(m.positions()[p], "P", page.ink(Ink::Text), Beside::Left, 16, true);
        s.label(m.positions()[q], "Q", page.ink(Ink::Text), Beside::Right, 16, true);
        if (first) s.key(page.ink(Ink::Offender), "the two faces that vanish");
    }
    Space& s = panel(after, "after: " + textAfter);
    s.disc(to, page.ink(Ink::New), 11);
    s.label(to, "P'", page.ink(Ink::New), Beside::Above, 16, true);
    page.number("legal", j.legal());
    page.numbers("change of V, E, F", std::vector<double>{a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

struct Illegal {
    std::vector<glm::dvec2> places;
    std::vector<std::array<uint32_t, 3>> faces;
    std::vector<const char*> names;  ///< of the first places
};

Mesh flatMesh(const Illegal& x)
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (const glm::dvec2& v : x.places) p.emplace_back(float(v.x), float(v.y), 0.f);
    for (const auto& [a, b, c] : x.faces) {  // anticlockwise
        const glm::dvec2 u = x.places[b] - x.places[a], v = x.places[c] - x.places[a];
        const bool turned = u.x * v.y - u.y * v.x < 0;
        t.insert(t.end(), {a, turned ? c : b, turned ? b : c});
    }
    return Mesh::triangles(std::move(p), std::move(t));
}

void illegalCollapse(Page& page)
{
    const Illegal cases[] = {
        {{{0, 0}, {2, 0}, {1, 0.6}, {1, 1.8}, {1, -1.2}, {-1.3, 0.9}, {3.3, 0.9}, {1, 3}, {-0.8, -1.2}, {2.8, -1.2}},
         {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}, {0, 1, 4}, {0, 3, 5}, {3, 7, 5}, {3, 6, 7}, {1, 6, 3}, {0, 5, 8}, {0, 8, 4}, {1, 4, 9}, {1, 9, 6}},
         {"P", "Q", "A", "C", "B"}},
        {{{0, -0.7}, {0.2, 0.7}, {-1.4, -0.7}, {-1.2, 0.7}, {1.4, -0.7}, {1.6, 0.7}},
         {{2, 0, 3}, {0, 1, 3}, {0, 4, 1}, {4, 5, 1}},
         {"P", "Q", "C", "A", "B", "D"}},
        {{{0, 0}, {2, 0}, {0.6, 0.25}, {0.9, -0.8}, {0.3, 1.3}, {1.7, 1.3}, {3, 0.2}, {2.1, -1.2}, {-0.8, -0.9}, {-1, 0.4}},
         {{0, 1, 2}, {0, 2, 4}, {2, 5, 4}, {1, 5, 2}, {1, 6, 5}, {1, 7, 6}, {1, 3, 7}, {0, 3, 1}, {0, 8, 3}, {0, 9, 8}, {0, 4, 9}},
         {"P", "Q", "A", "B", "C"}}};
    std::vector<double> refusals;
    for (const Illegal& x : cases) {
        const Mesh mesh = flatMesh(x);
        EdgeCollapser collapser(mesh);
        const EdgeCollapser::Judgement j = collapser.judge(0, 1, CollapsePlace::Middle);
        refusals.push_back(double(j.verdict.refusal));
        std::string reason = reasonAgainst(j);
        for (size_t at = reason.find(' ', 34); at != reason.npos && at + 34 < reason.size() + 34; at = reason.find(' ', at + 34)) reason[at] = '\n';
        Drawing& d = page.drawing(reason, {330, 300});
        if (j.verdict.refusal == Refusal::Link) d.polygon({x.places[0], x.places[1], x.places[3]}, page.tint(page.ink(Ink::Offender), 0.3f));
        if (j.verdict.refusal == Refusal::Turn) {
            d.polygon({x.places[0], x.places[2], x.places[4]}, page.tint(page.ink(Ink::Removed), 0.35f));
            const glm::dvec2 to = 0.5 * (x.places[0] + x.places[1]);
            d.path({to, x.places[2], x.places[4]}, Pen(page.ink(Ink::Offender), 2).dashed(), true);
        }
        for (size_t e = 0; e < mesh.edges().size(); e += 2)
            d.line(mesh.positions()[mesh.edges()[e]], mesh.positions()[mesh.edges()[e + 1]], Pen(page.ink(Ink::Line), 1.8f));
        d.line(x.places[0], x.places[1], Pen(page.ink(Ink::Focus), 4));
        for (size_t i = 0; i < x.names.size(); ++i) {
            d.disc(x.places[i], page.ink(i < 2 ? Ink::Focus : Ink::Neighbour), 9);
            d.label(x.places[i], x.names[i], page.ink(Ink::Text), Beside::Auto, 16, true);
        }
    }
    page.numbers("reasons", refusals);
}

void simplification(Page& page)
{
    const Mesh original = cow3();
    std::vector<double> triangles, wanted, euler, hausdorff;
    for (const double share : {1.0, 0.25, 0.1, 0.02}) {
        const auto target = size_t(std::llround(share * double(original.faceCount())));
        const Mesh mesh = share == 1 ? original : applied("decimate-quadric", ("stop=faces,faces=" + std::to_string(target)).c_str(), original);
        const Operation& op = operation("distance");
        const Table t = std::get<Table>(apply(op, mesh, {}, nullptr, {{"other", original}}));
        const std::map<std::string, double> found(t.summary.begin(), t.summary.end());
        const double far = share == 1 ? 0 : found.at("hausdorff %");
        Space& s = page.space(countText(mesh.faceCount(), "triangle") + ", Hausdorff error " + shortNumber(far) + " %", {400, 310});
        s.look(40, 15);
        s.put(mesh);
        if (share == 0.25) page.row();
        triangles.push_back(double(mesh.faceCount()));
        wanted.push_back(double(target));
        euler.push_back(double(mesh.topology().euler));
        hausdorff.push_back(far);
    }
    page.note("Errors are shares of the diagonal of the box, the greater of both directions, sought at 200,000 points on each surface.");
    page.numbers("triangles", triangles);
    page.numbers("wanted", wanted);
    page.numbers("V-E+F", euler);
    page.numbers("hausdorff %", hausdorff);
}

}  // namespace

std::vector<Figure> chapter3CostFigures()
{
    return {
        {"3.01-average-plane", "3.1", "The average plane of a vertex", {"3.1"}, averagePlane},
        {"3.02-same-distance", "3.2", "The same distance, another curvature", {"3.1"}, sameDistance},
        {"3.03-planarity", "3.3", "Planarity of vertices", {"3.1"}, planarity},
        {"3.04-boundary-cost", "3.4", "Cost of a vertex of the border", {"3.1"}, boundaryCost},
        {"3.05-edge-cost", "3.5", "Cost of edges", {"3.1"}, edgeCost},
        {"3.06-vertex-removal", "3.6", "Removing vertices", {"3.2"}, vertexRemoval},
        {"3.07-edge-collapse", "3.7", "Collapse of an edge", {"3.3"}, edgeCollapse},
        {"3.08-illegal-collapse", "3.8", "Edges that must not collapse", {"3.3"}, illegalCollapse},
        {"3.09-simplification", "3.9", "Simplification", {"3.4"}, simplification},
    };
}

}  // namespace mw::figures
