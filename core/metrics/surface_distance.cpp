// How far two surfaces are apart.
#include "core/metrics/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/mesh/triangle_tree.h"

namespace mw {

namespace {

constexpr size_t piece = 16384;  // points between two looks up

double areaOf(const Mesh& mesh, size_t triangle)
{
    const uint32_t* v = mesh.triangulation().vertices.data() + 3 * triangle;
    const glm::dvec3 a = mesh.positions()[v[0]], b = mesh.positions()[v[1]], c = mesh.positions()[v[2]];
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

double areaOf(const Mesh& mesh)
{
    double area = 0;
    for (size_t t = 0; t < mesh.triangulation().faces.size(); ++t) area += areaOf(mesh, t);
    return area;
}

/// From one surface to the other: vertices first, then the points spread over it.
struct Direction {
    Direction(const Mesh& from, const Mesh& to, size_t count) : tree(to), vertices(from.vertexCount())
    {
        std::vector<uint8_t> used(vertices, 0);
        for (const uint32_t v : from.cornerVertex()) used[v] = 1;
        onSurface = std::move(used);
        for (const glm::vec3& p : from.positions()) points.emplace_back(p);
        const std::vector<glm::dvec3> spread = spreadPoints(from, count);
        points.insert(points.end(), spread.begin(), spread.end());
        distance.reserve(points.size());
        spacing = spread.empty() ? 0 : std::sqrt(areaOf(from) / double(spread.size()));
    }
    bool done() const { return distance.size() == points.size(); }
    double progress() const { return points.empty() ? 1 : double(distance.size()) / double(points.size()); }
    void next()
    {
        const std::span<const glm::dvec3> rest = std::span(points).subspan(distance.size());
        for (const ClosestPoint& c : closestPoints(tree, rest.first(std::min(piece, rest.size())))) distance.push_back(std::sqrt(c.distance2));
    }
    void summarise();

    TriangleTree tree;
    size_t vertices;
    std::vector<uint8_t> onSurface;  // of vertices: in a face
    std::vector<glm::dvec3> points;
    std::vector<double> distance;
    double spacing = 0, greatest = 0, rms = 0, mean = 0;
};

void Direction::summarise()
{
    const size_t first = points.size() > vertices ? vertices : 0;
    double sum = 0, squares = 0, count = 0;
    for (size_t i = 0; i < distance.size(); ++i) {
        if (i < vertices && !onSurface[i]) continue;  // a loose vertex is no part of the surface
        greatest = std::max(greatest, distance[i]);
        if (i < first) continue;
        sum += distance[i];
        squares += distance[i] * distance[i];
        count += 1;
    }
    if (count == 0) return;
    mean = sum / count;
    rms = std::sqrt(squares / count);
}

void report(Table& table, const Direction& to, const Direction& from, double diagonal)
{
    const auto add = [&](const std::string& name, double value) {
        table.summary.emplace_back(name, value);
        table.summary.emplace_back(name + " %", diagonal > 0 ? 100 * value / diagonal : 0);
    };
    add("hausdorff", std::max(to.greatest, from.greatest));
    add("rms", std::max(to.rms, from.rms));
    add("mean", std::max(to.mean, from.mean));
    add("hausdorff to other", to.greatest);
    add("hausdorff from other", from.greatest);
    add("rms to other", to.rms);
    add("rms from other", from.rms);
    add("mean to other", to.mean);
    add("mean from other", from.mean);
    add("spacing", std::max(to.spacing, from.spacing));
    table.summary.emplace_back("diagonal", diagonal);
    table.summary.emplace_back("points", double(to.points.size() - to.vertices + from.points.size() - from.vertices));
}

}  // namespace

std::vector<glm::dvec3> spreadPoints(const Mesh& mesh, size_t count)
{
    constexpr double g = 1.32471795724474602596;  // the root of x^3 = x + 1
    std::vector<glm::dvec3> out;
    const double all = areaOf(mesh);
    if (!(all > 0) || !std::isfinite(all)) return out;
    out.reserve(count);
    double owed = 0.5;
    for (size_t t = 0; t < mesh.triangulation().faces.size(); ++t) {
        owed += double(count) * areaOf(mesh, t) / all;
        const uint32_t* v = mesh.triangulation().vertices.data() + 3 * t;
        const glm::dvec3 a = mesh.positions()[v[0]], b = mesh.positions()[v[1]], c = mesh.positions()[v[2]];
        for (; owed >= 1 && out.size() < count; owed -= 1) {
            const double i = double(out.size() + 1);
            double x = std::fmod(i / g, 1.0), y = std::fmod(i / (g * g), 1.0);
            if (x + y > 1) x = 1 - x, y = 1 - y;
            out.push_back(a + x * (b - a) + y * (c - a));
        }
    }
    return out;
}

Generator surfaceDistance(Mesh input, SurfaceDistance parameters, Stage<Table>& stage)
{
    const Mesh& other = parameters.other.mesh;
    if (input.triangulation().faces.empty()) throw Error("distance: the mesh has no faces; there is no surface to measure");
    if (other.triangulation().faces.empty())
        throw Error("distance: the other mesh \"" + parameters.other.name + "\" has no faces; name one that has a surface");
    co_yield Step("index").progress(0);
    Direction to(input, other, size_t(parameters.samples));
    while (!to.done()) {
        to.next();
        co_yield Step("to other").progress(0.5 * to.progress());
    }
    Direction from(other, input, size_t(parameters.samples));
    while (!from.done()) {
        from.next();
        co_yield Step("from other").progress(0.5 + 0.5 * from.progress());
    }
    to.summarise();
    from.summarise();
    const double diagonal = other.bounds().diagonal();
    Table table;
    table.rows = ElementKind::Vertex;
    Array<double> absolute(to.distance.begin(), to.distance.begin() + long(to.vertices)), share(absolute.size());
    for (size_t i = 0; i < share.size(); ++i) share[i] = diagonal > 0 ? 100 * absolute[i] / diagonal : 0;
    table.columns.push_back({"distance", "% of box", std::move(share), false});
    table.columns.push_back({"d", "m", std::move(absolute), false});
    report(table, to, from, diagonal);
    stage.finish(std::move(table));
}

}  // namespace mw
