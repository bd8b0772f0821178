#include "core/metrics/vertex_quadrics.h"

namespace mw {

VertexQuadrics vertexQuadricsOf(const Mesh& mesh, const Array<FaceMeasure>& measures, PlaneWeight weight)
{
    VertexQuadrics out{mesh.bounds().centre(), Array<Quadric>(mesh.vertexCount(), Quadric()), Array<uint32_t>(mesh.vertexCount(), 0u)};
    for (size_t f = 0; f < measures.size(); ++f) {
        const FaceMeasure& m = measures[f];
        if (!(m.area > 0)) continue;
        Quadric plane;
        plane.addPlane(m.normal, -glm::dot(m.normal, out.local(m.centroid)), weight == PlaneWeight::Area ? m.area : 1);
        for (const uint32_t v : mesh.face(f)) {
            out.quadric[v] += plane;
            ++out.planes[v];
        }
    }
    return out;
}

}  // namespace mw
