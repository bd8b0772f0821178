#include "ui/viewport/heat_probe.h"

#include <algorithm>
#include <cmath>

#include "core/math/closest.h"
#include "core/math/measure.h"
#include "render/bones.h"
#include "render/colors.h"

namespace mw {
namespace {

double ofVertices(const Array<double>& values, const glm::uvec3& corners, const glm::dvec3& weights)
{
    double sum = 0;
    for (int k = 0; k < 3; ++k)
        if (weights[k] != 0) sum += weights[k] * values[corners[k]];
    return sum;
}

/// Of the nearest edge of the face: at rest, which of them that is hardly depends on a pose.
double ofEdges(const Table& t, size_t column, const DrawObject& o, uint32_t face, const glm::dvec3& at)
{
    double least = INFINITY;
    std::pair<uint32_t, uint32_t> best{none, none};
    const auto corners = o.mesh.face(face);
    for (size_t k = 0; k < corners.size(); ++k) {
        const uint32_t a = corners[k], b = corners[(k + 1) % corners.size()];
        const glm::dvec3 p = o.mesh.positions()[a], q = o.mesh.positions()[b];
        const double d = glm::distance(at, p + closestOnSegment(at, p, q) * (q - p));
        if (d < least) least = d, best = std::minmax(a, b);
    }
    for (size_t e = 0; 2 * e < t.edges.size(); ++e)
        if (std::minmax(t.edges[2 * e], t.edges[2 * e + 1]) == std::pair<const uint32_t&, const uint32_t&>(best.first, best.second))
            return t.columns[column].values[e];
    return NAN;
}

}  // namespace

WorldPlaces::WorldPlaces(const DrawObject& o)
    : worldFromLocal_(o.worldFromLocal), places_(o.pose ? posedPositions(o.mesh, *o.pose) : o.mesh.positions())
{}

std::optional<TrianglePlace> triangleAt(const DrawObject& o, uint32_t face, const glm::dvec3& world)
{
    const WorldPlaces places(o);
    const Mesh::Triangulation& t = o.mesh.triangulation();
    const auto [first, last] = std::equal_range(t.faces.begin(), t.faces.end(), face);
    std::optional<TrianglePlace> found;
    double best = -1e9;
    for (const uint32_t* i = first; i != last; ++i) {
        const size_t k = 3 * size_t(i - t.faces.begin());
        const glm::uvec3 v(t.vertices[k], t.vertices[k + 1], t.vertices[k + 2]);
        const glm::dvec3 w = barycentric(world, places[v.x], places[v.y], places[v.z]);
        const double least = std::min({w.x, w.y, w.z});
        if (!(least > best)) continue;
        best = least;
        found = {v, {t.corners[k], t.corners[k + 1], t.corners[k + 2]}, w};
    }
    return found;
}

std::vector<double> mixed(const Mesh& mesh, std::string_view attribute, const glm::uvec3& vertices, const glm::uvec3& corners,
                          const glm::dvec3& weights)
{
    const Attribute* a = mesh.find(attribute, Domain::Corner);
    const glm::uvec3 at = a ? corners : vertices;
    if (!a) a = mesh.find(attribute, Domain::Vertex);
    std::vector<double> out;
    for (int c = 0; a && c < a->components; ++c) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += weights[k] * a->at(at[k], c);
        out.push_back(sum);
    }
    return out;
}

std::optional<ProbedValue> probed(const DrawObject& o, uint32_t face, const glm::uvec3& corners, const glm::dvec3& weights)
{
    for (const ElementKind rows : {ElementKind::Vertex, ElementKind::Face, ElementKind::Edge}) {
        const HeatMap* heat = heatOf(o, rows);
        if (!heat) continue;
        const Column& column = heat->table->columns[heat->column];
        ProbedValue v{NAN, column.name, column.unit};
        if (rows == ElementKind::Vertex) v.value = ofVertices(column.values, corners, weights);
        if (rows == ElementKind::Face && face < column.values.size()) v.value = column.values[face];
        if (rows == ElementKind::Edge) {
            glm::dvec3 at(0);
            for (int k = 0; k < 3; ++k) at += weights[k] * glm::dvec3(o.mesh.positions()[corners[k]]);
            v.value = ofEdges(*heat->table, heat->column, o, face, at);
        }
        return v;
    }
    return std::nullopt;
}

}  // namespace mw
