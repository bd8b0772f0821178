// Query: what it costs to move each vertex to the middle of its ring.
#include "core/metrics/vertex_quadric.h"

#include <algorithm>

namespace mw {

namespace {

class Costs {
public:
    Costs(const Mesh& mesh, const VertexQuadric& p, const Array<FaceMeasure>& measures)
        : quadrics(vertexQuadricsOf(mesh, measures, p.weight)), mesh_(mesh), measures_(measures), corners_(mesh), at_(p.at)
    {
        table.rows = ElementKind::Vertex;
        addColumn(table, "QEM", "", mesh.vertexCount());
        addColumn(table, "distance", "", mesh.vertexCount());
    }
    bool measure(uint32_t v);
    std::vector<uint32_t> facesOf(uint32_t v) const { return facesAt(mesh_, corners_, v); }

    Table table;
    VertexQuadrics quadrics;
    glm::dvec3 place{0};  // of the last vertex
    double weight = 0;    // of all its planes

private:
    glm::dvec3 placeOf(uint32_t v) const;

    const Mesh& mesh_;
    const Array<FaceMeasure>& measures_;
    FaceCorners corners_;
    VertexQuadric::At at_;
};

glm::dvec3 Costs::placeOf(uint32_t v) const
{
    if (at_ == VertexQuadric::At::Plane) {
        AveragePlane plane;
        for (const uint32_t c : mesh_.rings().cornersOf(v)) plane.add(measures_[corners_.faceOf(c)]);
        return plane.point();
    }
    const auto ring = mesh_.rings().neighboursOf(v);
    glm::dvec3 sum(0);
    for (const uint32_t w : ring) sum += glm::dvec3(mesh_.positions()[w]);
    return sum / double(ring.size());
}

bool Costs::measure(uint32_t v)
{
    if (quadrics.planes[v] == 0) return false;
    place = placeOf(v);
    const Quadric& q = quadrics.quadric[v];
    weight = q.xx + q.yy + q.zz;  // the normals are unit
    const double cost = std::max(0.0, q.at(quadrics.local(place)));
    table.columns[0].values[v] = cost;
    table.columns[1].values[v] = std::sqrt(cost / weight);
    return true;
}

}  // namespace

Generator vertexQuadric(Mesh input, VertexQuadric parameters, Stage<Table>& stage)
{
    co_yield Step("gather").number("vertices", double(input.vertexCount())).progress(0);
    input.rings();  // kept with the mesh
    if (!stage.watched()) co_yield Step("gather").progress(0);
    const Array<FaceMeasure> measures = faceMeasuresOf(input);
    if (!stage.watched()) co_yield Step("gather").progress(0);
    Costs costs(input, parameters, measures);
    const double all = double(input.vertexCount());
    stage.show([&costs] { return costs.table; });
    for (uint32_t v = 0; v < input.vertexCount(); ++v) {
        if (!stage.watched() && (v & 8191) == 0) co_yield Step("measure").progress(v / all);
        if (!costs.measure(v) || !stage.watched()) continue;
        const Quadric& q = costs.quadrics.quadric[v];
        const std::vector<uint32_t> faces = costs.facesOf(v);
        co_yield Step("measure")
            .vertex(v, Role::Current, "v")
            .ring(ElementKind::Face, Role::Neighbour, faces)
            .point(glm::vec3(costs.place), Role::New, "p")
            .number("planes", double(costs.quadrics.planes[v]))
            .number("k11", q.xx)
            .number("k12", q.xy)
            .number("k13", q.xz)
            .number("k14", q.bx)
            .number("k22", q.yy)
            .number("k23", q.yz)
            .number("k24", q.by)
            .number("k33", q.zz)
            .number("k34", q.bz)
            .number("k44", q.c)
            .number("cost", costs.table.columns[0].values[v])
            .number("distance", costs.table.columns[1].values[v])
            .progress(v / all);
    }
    costs.table.summary = summaryOfMeasured(costs.table.columns[0].values);
    stage.finish(std::move(costs.table));
}

}  // namespace mw
