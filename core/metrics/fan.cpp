#include "core/metrics/fan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/mesh/large_pages.h"

namespace mw {

FaceMeasure measureOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double twice = glm::length(n);
    return {twice > 0 ? n / twice : glm::dvec3(0), 0.5 * twice, (a + b + c) / 3.0};
}

Array<FaceMeasure> faceMeasuresOf(const Mesh& mesh)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    const Shared<glm::vec3>& at = mesh.positions();
    const auto ofTriangle = [&](size_t t) { return measureOf(at[cut.vertices[3 * t]], at[cut.vertices[3 * t + 1]], at[cut.vertices[3 * t + 2]]); };
    if (mesh.isTriangles()) {
        Array<FaceMeasure> out = largeArray<FaceMeasure>(mesh.faceCount());
        tbb::parallel_for(tbb::blocked_range<size_t>(0, out.size(), 4096), [&](const auto& part) {
            for (size_t f = part.begin(); f < part.end(); ++f) out[f] = ofTriangle(f);
        });
        return out;
    }
    Array<FaceMeasure> out(mesh.faceCount(), FaceMeasure{glm::dvec3(0), 0, glm::dvec3(0)});
    const size_t n = cut.faces.size();
    for (size_t first = 0, last = 0; first < n; first = last) {
        glm::dvec3 normal(0), centroid(0);
        double area = 0;
        for (; last < n && cut.faces[last] == cut.faces[first]; ++last) {
            const FaceMeasure m = ofTriangle(last);
            normal += m.area * m.normal;
            centroid += m.area * m.centroid;
            area += m.area;
        }
        const double length = glm::length(normal);
        if (length > 0) out[cut.faces[first]] = {normal / length, length, centroid / area};
    }
    return out;
}

std::vector<uint32_t> facesAt(const Mesh& mesh, const FaceCorners& corners, uint32_t vertex)
{
    std::vector<uint32_t> faces;
    for (const uint32_t c : mesh.rings().cornersOf(vertex)) faces.push_back(corners.faceOf(c));
    return faces;
}

decltype(Table::summary) summaryOfMeasured(const Array<double>& values)
{
    double measured = 0, sum = 0, greatest = 0;
    for (const double v : values) {
        if (std::isnan(v)) continue;
        measured += 1;
        sum += v;
        greatest = std::max(greatest, v);
    }
    return {{"measured", measured}, {"mean", measured > 0 ? sum / measured : 0}, {"greatest", greatest}};
}

void addColumn(Table& table, const char* name, const char* unit, size_t rows)
{
    Array<double> values = largeArray<double>(rows);
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    table.columns.push_back({name, unit, std::move(values), false});
}

BorderNeighbours borderNeighboursOf(const Mesh& mesh)
{
    using Place = BorderNeighbours::Place;
    BorderNeighbours b{Array<Place>(mesh.vertexCount(), Place::Inside), Array<uint32_t>(2 * mesh.vertexCount(), none)};
    const auto add = [&](uint32_t v, uint32_t other) {
        if (b.neighbour[2 * v] == none)
            b.neighbour[2 * v] = other;
        else if (b.neighbour[2 * v + 1] == none)
            b.neighbour[2 * v + 1] = other;
        else
            b.place[v] = Place::Branch;
        if (b.place[v] == Place::Inside) b.place[v] = Place::Border;
    };
    Rings own;
    const Rings& rings = ringsOfGoodFaces(mesh, own);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
        for (uint32_t i = rings.neighbourStart[v]; i < rings.neighbourStart[v + 1]; ++i)
            if (rings.sides[i] == 1) add(v, rings.neighbour[i]);
    return b;
}

}  // namespace mw
