// Figure 3.29: a point and a triangle.
#include <glm/geometric.hpp>

#include "app/figures/figures.h"
#include "core/math/point_triangle.h"

namespace mw::figures {
namespace {

constexpr glm::dvec3 a{0, 0, 0}, b{4, 0.4, 0}, c{1.2, 3, 0};

void abc(Page& page, Layer& s)
{
    s.path({a, b, c}, Pen(page.ink(Ink::Line), 2.4f), true);
    s.label(a, "A", page.ink(Ink::Text), Beside::BelowLeft, 17, true);
    s.label(b, "B", page.ink(Ink::Text), Beside::Right, 17, true);
    s.label(c, "C", page.ink(Ink::Text), Beside::Above, 17, true);
}

std::string signOf(double v)
{
    return v > 0 ? "+" : v < 0 ? "\u2212" : "0";
}

/// The triangle in its own plane, moved aside, and the arrows from its corners to Q.
void inclusion(Page& page, Drawing& d, const glm::dvec3& p, const glm::dvec3& aside, std::vector<double>& signs)
{
    const PointTriangle r = pointTriangle(p, a, b, c);
    const glm::dvec3 corner[] = {a + aside, b + aside, c + aside}, q = r.foot + aside;
    d.polygon({corner[0], corner[1], corner[2]}, page.tint(page.ink(Ink::Neighbour), 0.18f));
    d.path({corner[0], corner[1], corner[2]}, Pen(page.ink(Ink::Line), 2.4f), true);
    const char* names[] = {"A", "B", "C"};
    const Beside side[] = {Beside::BelowLeft, Beside::BelowRight, Beside::Above};
    for (int i = 0; i < 3; ++i) {
        d.arrow(corner[i], q, Pen(page.ink(r.t[i] < 0 ? Ink::Offender : Ink::Focus), 2.2f).gaps(4, 6));
        d.label(corner[i], names[i], page.ink(Ink::Text), side[i], 17, true);
        const glm::dvec3 middle = 0.5 * (corner[i] + corner[(i + 1) % 3]), out = glm::normalize(middle - (corner[0] + corner[1] + corner[2]) / 3.0);
        // Beside the middle of the side; the one that says outside within, where no line runs.
        const glm::dvec3 beside = r.t[i] < 0 ? glm::mix(corner[i], corner[(i + 1) % 3], 0.3) - 0.36 * out : middle + 0.33 * out;
        d.words(beside, "t" + std::to_string(i + 1) + " " + signOf(r.t[i]), {page.ink(r.t[i] < 0 ? Ink::Offender : Ink::Text), Beside::On, 15, true});
        signs.push_back(r.t[i] > 0 ? 1 : r.t[i] < 0 ? -1 : 0);
    }
    d.disc(q, page.ink(Ink::Focus), 10);
    d.label(q, "Q", page.ink(Ink::Focus), Beside::Right, 17, true);
    if (r.inside) return;
    const glm::dvec3 x = r.closest + aside;
    d.line(q, x, Pen(page.ink(Ink::New), 2.6f).dashed());
    d.disc(x, page.ink(Ink::New), 10);
    d.label(x, "closest", page.ink(Ink::New), Beside::AboveLeft, 15, true);
}

void pointAndTriangle(Page& page)
{
    const glm::dvec3 p(1.7, 1.1, 2.1), outside(3.4, 2.6, 1);
    const PointTriangle r = pointTriangle(p, a, b, c), o = pointTriangle(outside, a, b, c);
    Space& s = page.space("D = " + shortNumber(r.distance) + ", the foot Q is inside", {430, 400});
    s.look(-28, -58);
    s.wires(false);
    s.put(Mesh::triangles(Array<glm::vec3>{a, b, c}, Array<uint32_t>{0, 1, 2}));
    abc(page, s);
    s.arrow(a + 0.05 * (b - a) + 0.05 * (c - a), a + 0.05 * (b - a) + 0.05 * (c - a) + 1.2 * r.normal, page.ink(Ink::Neighbour), 2.4f);
    s.label(a + 1.2 * r.normal, "n", page.ink(Ink::Neighbour), Beside::Left, 16, true);
    s.line(p, r.foot, Pen(page.ink(Ink::New), 2.8f));
    s.disc(p, page.ink(Ink::Focus), 11);
    s.disc(r.foot, page.ink(Ink::New), 10);
    s.label(p, "P", page.ink(Ink::Focus), Beside::Above, 17, true);
    s.label(r.foot, "Q", page.ink(Ink::New), Beside::BelowRight, 17, true);
    s.label(0.5 * (p + r.foot), "D", page.ink(Ink::New), Beside::Right, 16, true);
    Drawing& d = page.drawing("signs of t1, t2, t3: inside, and outside with the closest point", {720, 400});
    std::vector<double> in, out;
    inclusion(page, d, p, glm::dvec3(0), in);
    inclusion(page, d, outside, {6, 0, 0}, out);
    page.number("D", r.distance);
    page.number("P to Q", glm::distance(p, r.foot));
    page.numbers("signs inside", in);
    page.numbers("signs outside", out);
    page.number("inside", r.inside);
    page.number("outside is inside", o.inside);
    page.number("closest to Q", glm::distance(o.closest, o.foot));
    double least = 1e9;
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        least = std::min(least, glm::distance(o.foot, u + closestOnSegment(o.foot, u, v) * (v - u)));
    page.number("nearest side to Q", least);
}

}  // namespace

std::vector<Figure> chapter3DistanceFigures()
{
    return {{"3.29-point-triangle", "3.29", "A point and a triangle", {"3.15"}, pointAndTriangle}};
}

}  // namespace mw::figures
