#include "core/metrics/fan.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

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
    Array<FaceMeasure> out(mesh.faceCount(), FaceMeasure());
    if (mesh.isTriangles()) {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, out.size(), 4096), [&](const auto& part) {
            for (size_t f = part.begin(); f < part.end(); ++f) out[f] = ofTriangle(f);
        });
        return out;
    }
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

BorderNeighbours borderNeighboursOf(const Mesh& mesh)
{
    using Place = BorderNeighbours::Place;
    const EdgeSides edges = edgeSidesOf(mesh, degenerateFacesOf(mesh));
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
    for (size_t e = 0; e < edges.size(); ++e) {
        if (edges.sides(e).size() != 1) continue;
        add(edges.ends[2 * e], edges.ends[2 * e + 1]);
        add(edges.ends[2 * e + 1], edges.ends[2 * e]);
    }
    return b;
}

}  // namespace mw
