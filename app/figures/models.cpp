// Shapes for the figures: grids, fans, a cow of limbs, a piece of the rock, two joined rings.
#include "app/figures/models.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/catalog/catalog.h"
#include "core/error.h"
#include "core/math/limb.h"
#include "core/mesh/submesh.h"
#include "core/mesh/surface_net.h"
#include "core/mesh/topology.h"
#include "core/scene/samples.h"

namespace mw::figures {
namespace {

using glm::dvec3;

/// The left half; it looks along +Z, and stands on y = 0.
const Limb cowLimbs[] = {
    // trunk, neck
    {{0, 1.05, 0.55}, {0, 1.02, 0.0}, 0.33, 0.37},
    {{0, 1.02, 0.0}, {0, 1.08, -0.55}, 0.37, 0.34},
    {{0, 1.18, 0.62}, {0, 1.42, 1.00}, 0.26, 0.19},
    // skull, muzzle, ear, horn
    {{0, 1.50, 1.05}, {0, 1.44, 1.20}, 0.21, 0.18},
    {{0, 1.44, 1.20}, {0, 1.30, 1.46}, 0.16, 0.13},
    {{0.12, 1.58, 1.00}, {0.34, 1.60, 0.96}, 0.10, 0.075},
    // legs
    {{0.20, 0.90, 0.55}, {0.22, 0.45, 0.55}, 0.17, 0.12},
    {{0.22, 0.45, 0.55}, {0.22, 0.07, 0.56}, 0.115, 0.115},
    {{0.20, 0.95, -0.60}, {0.23, 0.50, -0.62}, 0.21, 0.13},
    {{0.23, 0.50, -0.62}, {0.22, 0.07, -0.62}, 0.12, 0.115},
    // tail
    {{0, 1.30, -0.82}, {0, 1.02, -1.06}, 0.10, 0.085},
    {{0, 1.02, -1.06}, {0, 0.72, -1.10}, 0.085, 0.10},
};

std::vector<double> lines(double from, double to, double step)
{
    std::vector<double> at;
    const int n = std::max(2, int(std::lround((to - from) / step)));
    for (int i = 0; i <= n; ++i) at.push_back(from + (to - from) * i / n);
    return at;
}

std::vector<double> mirrored(double to, double step)
{
    const std::vector<double> half = lines(0, to, step);
    std::vector<double> at;
    for (size_t i = half.size() - 1; i > 0; --i) at.push_back(-half[i]);
    at.insert(at.end(), half.begin(), half.end());
    return at;
}

Mesh cow(double step)
{
    const auto field = [](const dvec3& p) { return std::max(blendedDistance(cowLimbs, {std::abs(p.x), p.y, p.z}, 0.05), -p.y); };
    return mirroredSurfaceNet({mirrored(0.62, step), lines(-0.2, 1.95, step), lines(-1.45, 1.80, step)}, field);
}

Mesh grid(int columns, int rows, bool triangles, double bent)
{
    Array<glm::vec3> p;
    Array<uint32_t> start{0u}, corners;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) p.emplace_back(c, r, bent * std::sin(M_PI * c / columns) * std::sin(M_PI * r / rows));
    const auto face = [&](std::initializer_list<uint32_t> of) {
        corners.insert(corners.end(), of);
        start.push_back(uint32_t(corners.size()));
    };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const uint32_t a = uint32_t(r * (columns + 1) + c), b = a + 1, d = a + uint32_t(columns) + 1, e = d + 1;
            if (triangles) {
                face({a, b, e});
                face({a, e, d});
            } else {
                face({a, b, e, d});
            }
        }
    return Mesh(std::move(p), std::move(start), std::move(corners));
}

}  // namespace

Mesh applied(const char* id, const char* parameters, const Mesh& mesh)
{
    const Operation& op = operation(id);
    return std::get<Mesh>(apply(op, op.accepts == Kind::Nothing ? Value() : Value(mesh), parsed(op.parameters, parameters)));
}

Mesh stripCube()
{
    Array<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i >> 2 & 1, i >> 1 & 1, i & 1);
    Array<uint32_t> t{0, 1, 2, 2, 1, 3, 2, 3, 7, 7, 3, 1, 7, 1, 5, 5, 1, 4, 5, 4, 7, 7, 4, 6, 7, 6, 2, 2, 6, 4, 2, 4, 0, 0, 4, 1};
    return Mesh::triangles(std::move(p), std::move(t));
}

Mesh cow4()
{
    return cow(0.105);
}

Mesh cow3(size_t faces)
{
    const Mesh fine = triangulated(cow(0.045));  // in coarser grids some edges have four faces
    const double ratio = double(faces) / double(fine.faceCount());
    return ratio >= 1 ? fine : applied("decimate-quadric", ("ratio=" + std::to_string(ratio)).c_str(), fine);
}

Mesh triangleGrid(int columns, int rows, double bent)
{
    return grid(columns, rows, true, bent);
}

Mesh quadGrid(int columns, int rows)
{
    return grid(columns, rows, false, 0);
}

Mesh hexagonGrid(int rings)
{
    Array<glm::vec3> p;
    std::vector<std::pair<int, int>> at;  // along the axes at 0 and 60 degrees
    for (int a = -rings; a <= rings; ++a)
        for (int b = -rings; b <= rings; ++b)
            if (std::abs(a + b) <= rings) at.emplace_back(a, b);
    const auto away = [](std::pair<int, int> c) { return (std::abs(c.first) + std::abs(c.second) + std::abs(c.first + c.second)) / 2; };
    std::stable_sort(at.begin(), at.end(), [&](auto x, auto y) { return away(x) < away(y); });
    for (const auto& [a, b] : at) p.emplace_back(a + 0.5 * b, b * std::sqrt(0.75), 0);
    Array<uint32_t> t;
    const auto index = [&](int a, int b) {
        const auto found = std::find(at.begin(), at.end(), std::pair(a, b));
        return found == at.end() ? none : uint32_t(found - at.begin());
    };
    for (const auto& [a, b] : at) {
        const uint32_t o = index(a, b), right = index(a + 1, b), up = index(a, b + 1), down = index(a + 1, b - 1);
        if (right != none && up != none) t.insert(t.end(), {o, right, up});
        if (down != none && right != none) t.insert(t.end(), {o, down, right});
    }
    return Mesh::triangles(std::move(p), std::move(t));
}

Mesh rockpatch()
{
    const Scene rock = rockScene();
    const Mesh coarse = applied("decimate-quadric", "ratio=0.085", rock.find(rock.meshes().front())->base);
    const dvec3 middle = glm::normalize(dvec3(0.3, 0.75, 0.5));
    KeptElements kept(coarse);
    for (size_t f = 0; f < coarse.faceCount(); ++f) {
        dvec3 sum(0);
        for (const uint32_t v : coarse.face(f)) sum += dvec3(coarse.positions()[v]);
        const dvec3 d = glm::normalize(sum);
        const double ragged = 0.10 * std::sin(7 * d.x + 3) * std::cos(9 * d.y) + 0.05 * std::sin(23 * d.x);
        kept.faces[f] = std::acos(std::clamp(glm::dot(d, middle), -1.0, 1.0)) < 0.70 + ragged;
    }
    kept.vertices.assign(coarse.vertexCount(), false);
    for (size_t f = 0; f < coarse.faceCount(); ++f)
        if (kept.faces[f])
            for (const uint32_t v : coarse.face(f)) kept.vertices[v] = true;
    Mesh patch = submesh(coarse, kept).without(names::color);
    const TopologyReport& t = patch.topology();
    if (t.components != 1 || t.boundaryLoops.size() != 1 || t.euler != 1 || !t.manifold() || patch.faceCount() < 500 || patch.faceCount() > 2000)
        throw Error("the piece of the rock is no disk of 500 to 2000 triangles: choose another part of it");
    return patch;
}

Mesh torus2()
{
    // Two rings that touch, melted together: the field is a smooth minimum of their distances.
    const auto ring = [](const dvec3& p, double x) {
        const double q = std::hypot(p.x - x, p.z) - 0.62;
        return std::hypot(q, p.y) - 0.24;
    };
    const auto field = [&](const dvec3& p) {
        const double a = ring(p, -0.74), b = ring(p, 0.74), k = 12;
        return -std::log(std::exp(-k * a) + std::exp(-k * b)) / k;
    };
    return triangulated(mirroredSurfaceNet({mirrored(1.8, 0.12), lines(-0.5, 0.5, 0.12), lines(-1.1, 1.1, 0.12)}, field));
}

Mesh torusMesh(double radius, double tube, int segments, int sides)
{
    const std::string values = "radius=" + std::to_string(radius) + ",tube=" + std::to_string(tube) + ",segments=" + std::to_string(segments) +
                               ",sides=" + std::to_string(sides);
    return triangulated(applied("torus", values.c_str(), {}));
}

Mesh sphereMesh(int subdivisions)
{
    return applied("icosphere", ("subdivisions=" + std::to_string(subdivisions)).c_str(), {});
}

Mesh fan(int k, double height, bool closed)
{
    Array<glm::vec3> p{glm::vec3(0, 0, float(height))};
    Array<uint32_t> t;
    const int corners = closed ? k : k + 1;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * M_PI * i / (closed ? k : k + 2);
        p.emplace_back(std::cos(a), std::sin(a), 0);
    }
    for (int i = 0; i < k; ++i) t.insert(t.end(), {0u, uint32_t(1 + i), uint32_t(1 + (i + 1) % corners)});
    return Mesh::triangles(std::move(p), std::move(t));
}

Mesh triangulated(const Mesh& mesh)
{
    return Mesh::triangles(mesh.positions(), mesh.triangulation().vertices);
}

}  // namespace mw::figures
