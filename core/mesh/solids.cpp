// Box, grid, sphere, cylinder, cone and torus. All but the first two are profiles turned about +Y.
#include "core/mesh/solids.h"

#include <cmath>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <tuple>

#include "core/error.h"
#include "core/mesh/polygons.h"

namespace mw {

namespace {

/// A point of a profile: distance from the axis and height, and how far along it is.
struct Along {
    double radius, y, v;
};

/// Turns a profile, given from below upwards on the outside, about +Y. Where it meets the axis there is one vertex. `closed` joins its ends.
/// `bottom` and `top` close open ends by one polygon each.
Mesh turned(const std::vector<Along>& profile, int64_t segments, bool closed, bool bottom, bool top)
{
    Polygons out;
    const uint32_t n = uint32_t(segments);
    std::vector<uint32_t> first;
    for (const Along& a : profile) {
        first.push_back(uint32_t(out.positions.size()));
        for (uint32_t s = 0; s < (a.radius > 0 ? n : 1); ++s) {
            const double angle = 2 * std::numbers::pi * double(s) / double(n);
            out.positions.push_back({float(a.radius * std::sin(angle)), float(a.y), float(a.radius * std::cos(angle))});
        }
    }
    const auto vertex = [&](size_t row, uint32_t s) { return first[row] + (profile[row].radius > 0 ? s % n : 0); };
    const auto place = [&](double s, double v) { return glm::dvec2(s / double(n), v); };
    const size_t rows = profile.size() - (closed ? 0 : 1);
    for (size_t r = 0; r < rows; ++r) {
        const size_t up = (r + 1) % profile.size();
        const double below = profile[r].v, above = up == 0 ? 1 : profile[up].v;
        for (uint32_t s = 0; s < n; ++s) {
            const bool tipBelow = profile[r].radius == 0, tipAbove = profile[up].radius == 0;
            out.corner(vertex(r, s), place(tipBelow ? s + 0.5 : s, below));
            if (!tipBelow) out.corner(vertex(r, s + 1), place(s + 1, below));
            if (!tipAbove) out.corner(vertex(up, s + 1), place(s + 1, above));
            out.corner(vertex(up, s), place(tipAbove ? s + 0.5 : s, above));
            out.endFace();
        }
    }
    const auto cap = [&](size_t row, bool upwards) {
        for (uint32_t s = 0; s < n; ++s) {
            const uint32_t k = upwards ? s : n - 1 - s;
            const double angle = 2 * std::numbers::pi * double(k) / double(n);
            out.corner(vertex(row, k), {0.5 + 0.5 * std::sin(angle), 0.5 + (upwards ? -0.5 : 0.5) * std::cos(angle)});
        }
        out.endFace();
    };
    if (bottom) cap(0, false);
    if (top) cap(profile.size() - 1, true);
    return out.mesh();
}

void addSide(std::vector<Along>& profile, double r0, double r1, double height, int64_t rings)
{
    for (int64_t i = 0; i <= rings; ++i) {
        const double t = double(i) / double(rings);
        profile.push_back({i == rings ? r1 : r0 + (r1 - r0) * t, height * (t - 0.5), t});
    }
}

}  // namespace

Generator box(Box p, Stage<Mesh>& stage)
{
    Polygons out;
    std::map<std::tuple<int64_t, int64_t, int64_t>, uint32_t> known;
    const int64_t n = p.segments;
    const glm::dvec3 size(p.width, p.height, p.depth);
    const auto vertex = [&](const glm::i64vec3& g) {
        const auto [at, isNew] = known.emplace(std::tuple(g.x, g.y, g.z), uint32_t(out.positions.size()));
        if (isNew) out.positions.push_back(glm::vec3(size * (glm::dvec3(g) / double(n) - 0.5)));
        return at->second;
    };
    // Each side: its origin, and its two directions, anticlockwise from outside.
    static constexpr glm::ivec3 sides[6][3] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}},
                                               {{1, 0, 1}, {0, 0, -1}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                               {{0, 1, 1}, {1, 0, 0}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
    for (const auto& side : sides)
        for (int64_t j = 0; j < n; ++j)
            for (int64_t i = 0; i < n; ++i) {
                for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                    out.corner(vertex(glm::i64vec3(side[0]) * n + glm::i64vec3(side[1]) * (i + a) + glm::i64vec3(side[2]) * (j + b)),
                               glm::dvec2(double(i + a), double(j + b)) / double(n));
                out.endFace();
            }
    stage.finish(out.mesh());
    co_return;
}

Generator grid(Grid p, Stage<Mesh>& stage)
{
    Polygons out;
    const uint32_t w = uint32_t(p.columns), h = uint32_t(p.rows);
    for (uint32_t y = 0; y <= h; ++y)
        for (uint32_t x = 0; x <= w; ++x)
            out.positions.push_back(glm::vec3(glm::dvec3(p.width * (x / double(w) - 0.5), 0, p.depth * (y / double(h) - 0.5))));
    for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x) {
            for (const auto& [a, b] : {std::pair{0u, 0u}, {0u, 1u}, {1u, 1u}, {1u, 0u}})
                out.corner((y + b) * (w + 1) + x + a, {(x + a) / double(w), 1 - (y + b) / double(h)});
            out.endFace();
        }
    stage.finish(out.mesh());
    co_return;
}

Generator uvSphere(UvSphere p, Stage<Mesh>& stage)
{
    std::vector<Along> profile;
    for (int64_t i = 0; i <= p.rings; ++i) {
        const double t = double(i) / double(p.rings), angle = std::numbers::pi * (t - 0.5);
        const bool pole = i == 0 || i == p.rings;
        profile.push_back({pole ? 0 : p.radius * std::cos(angle), pole ? (i == 0 ? -p.radius : p.radius) : p.radius * std::sin(angle), t});
    }
    stage.finish(turned(profile, p.segments, false, false, false));
    co_return;
}

Generator cylinder(Cylinder p, Stage<Mesh>& stage)
{
    std::vector<Along> profile;
    const bool fan = p.caps == Caps::Fan, polygon = p.caps == Caps::Polygon;
    if (fan) profile.push_back({0, -0.5 * p.height, 0});
    addSide(profile, p.radius, p.radius, p.height, p.rings);
    if (fan) profile.push_back({0, 0.5 * p.height, 1});
    stage.finish(turned(profile, p.segments, false, polygon, polygon));
    co_return;
}

Generator cone(Cone p, Stage<Mesh>& stage)
{
    std::vector<Along> profile;
    if (p.caps == Caps::Fan) profile.push_back({0, -0.5 * p.height, 0});
    addSide(profile, p.radius, 0, p.height, p.rings);
    stage.finish(turned(profile, p.segments, false, p.caps == Caps::Polygon, false));
    co_return;
}

Generator torus(Torus p, Stage<Mesh>& stage)
{
    if (p.tube >= p.radius)
        throw Error("the tube of a torus must be thinner than its ring: tube " + std::to_string(p.tube) + ", radius " + std::to_string(p.radius));
    std::vector<Along> profile;
    for (int64_t i = 0; i < p.sides; ++i) {
        const double t = double(i) / double(p.sides), angle = 2 * std::numbers::pi * t;
        profile.push_back({p.radius + p.tube * std::cos(angle), p.tube * std::sin(angle), t});
    }
    stage.finish(turned(profile, p.segments, true, false, false));
    co_return;
}

}  // namespace mw
