#include "core/metrics/fan.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <utility>

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
    Array<FaceMeasure> out(mesh.faceCount(), FaceMeasure());
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

std::vector<uint32_t> facesAt(const Mesh& mesh, const Array<uint32_t>& faceOf, uint32_t vertex)
{
    std::vector<uint32_t> faces;
    for (const uint32_t c : mesh.rings().cornersOf(vertex)) faces.push_back(faceOf[c]);
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

namespace {

using Edge = std::pair<uint32_t, uint32_t>;  // the lower vertex first

/// For each side of the faces that are not degenerate.
template <class Body>
void forSides(const Mesh& mesh, const std::vector<uint8_t>& degenerate, const Body& body)
{
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        if (!degenerate.empty() && degenerate[f]) continue;
        const uint32_t first = mesh.faceStart()[f], last = mesh.faceStart()[f + 1];
        for (uint32_t c = first; c < last; ++c)
            body(c, Edge(std::minmax({mesh.cornerVertex()[c], mesh.cornerVertex()[c + 1 < last ? c + 1 : first]})));
    }
}

/// The edges of one face alone, ascending.
std::vector<Edge> borderEdgesOf(const Mesh& mesh)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    const Array<uint32_t> opposite = oppositeCornersOf(mesh, degenerate);
    std::vector<Edge> open;
    if (std::find(opposite.begin(), opposite.end(), none) == opposite.end()) return open;
    std::vector<bool> atOpen(mesh.vertexCount());
    forSides(mesh, degenerate, [&](uint32_t c, const Edge& e) {
        if (opposite[c] != none) return;
        open.push_back(e);
        atOpen[e.first] = atOpen[e.second] = true;
    });
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    // A side without an opposite is no border where others share its edge, be it a pair or one of the same direction.
    std::vector<uint32_t> sides(open.size());
    forSides(mesh, degenerate, [&](uint32_t, const Edge& e) {
        if (!atOpen[e.first] || !atOpen[e.second]) return;
        const auto i = std::lower_bound(open.begin(), open.end(), e);
        if (i != open.end() && *i == e) ++sides[size_t(i - open.begin())];
    });
    size_t kept = 0;
    for (size_t i = 0; i < open.size(); ++i)
        if (sides[i] == 1) open[kept++] = open[i];
    open.resize(kept);
    return open;
}

}  // namespace

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
    for (const auto& [v, w] : borderEdgesOf(mesh)) {
        add(v, w);
        add(w, v);
    }
    return b;
}

}  // namespace mw
