// Query: how far each vertex is off the average plane of its fan.
#include "core/metrics/vertex_planarity.h"

#include <algorithm>

#include "core/metrics/fan.h"

namespace mw {

namespace {

/// One vertex after the other, so that a step can stop at each.
class Planarity {
public:
    Planarity(const Mesh& mesh, BorderNeighbours border) : mesh_(mesh), measures_(faceMeasuresOf(mesh)), corners_(mesh), border_(std::move(border))
    {
        table.rows = ElementKind::Vertex;
        addColumn(table, "d / longest edge", "", mesh.vertexCount());
        addColumn(table, "d", "", mesh.vertexCount());
    }
    std::vector<uint32_t> facesOf(uint32_t v) const { return facesAt(mesh_, corners_, v); }
    bool inside(uint32_t v) const { return border_.place[v] == BorderNeighbours::Place::Inside; }
    void measure(uint32_t v);

    Table table;
    double longest = 0, height = 0;  // of the last vertex
    glm::vec3 foot{0}, at{0};

private:
    const Mesh& mesh_;
    Array<FaceMeasure> measures_;
    FaceCorners corners_;
    BorderNeighbours border_;
};

void Planarity::measure(uint32_t v)
{
    const Rings& rings = mesh_.rings();
    const glm::dvec3 p = mesh_.positions()[v];
    AveragePlane plane;
    for (const uint32_t c : rings.cornersOf(v)) plane.add(measures_[corners_.faceOf(c)]);
    double square = 0;
    for (const uint32_t w : rings.neighboursOf(v)) {
        const glm::dvec3 side = glm::dvec3(mesh_.positions()[w]) - p;
        square = std::max(square, glm::dot(side, side));
    }
    longest = std::sqrt(square);
    height = 0;
    foot = at = mesh_.positions()[v];
    if (!inside(v) || !plane.defined() || !(longest > 0)) return;
    const glm::dvec3 normal = plane.normal();
    height = glm::dot(normal, p - plane.point());
    foot = p - height * normal;
    table.columns[0].values[v] = std::abs(height) / longest;
    table.columns[1].values[v] = std::abs(height);
}

}  // namespace

Generator vertexPlanarity(Mesh input, VertexPlanarity, Stage<Table>& stage)
{
    co_yield Step("gather").number("vertices", double(input.vertexCount())).progress(0);
    input.rings();  // kept with the mesh
    if (!stage.watched()) co_yield Step("gather").progress(0);
    BorderNeighbours border = borderNeighboursOf(input);
    if (!stage.watched()) co_yield Step("gather").progress(0);
    Planarity p(input, std::move(border));
    const double all = double(input.vertexCount());
    stage.show([&p] { return p.table; });
    for (uint32_t v = 0; v < input.vertexCount(); ++v) {
        p.measure(v);
        if (!stage.watched()) {
            if ((v & 8191) == 0) co_yield Step("measure").progress(v / all);
            continue;
        }
        const std::vector<uint32_t> faces = p.facesOf(v);
        if (p.inside(v))
            co_yield Step("measure")
                .vertex(v, Role::Current, "v")
                .ring(ElementKind::Face, Role::Neighbour, faces)
                .point(p.foot, Role::New, "p")
                .segment(p.at, p.foot, Role::New, "d")
                .number("faces", double(faces.size()))
                .number("d", std::abs(p.height))
                .number("longest", p.longest)
                .number("cost", p.table.columns[0].values[v])
                .progress(v / all);
        else
            co_yield Step("border")
                .vertex(v, Role::Rejected, "v")
                .ring(ElementKind::Face, Role::Neighbour, faces)
                .number("faces", double(faces.size()))
                .progress(v / all);
    }
    p.table.summary = summaryOfMeasured(p.table.columns[0].values);
    stage.finish(std::move(p.table));
}

}  // namespace mw
