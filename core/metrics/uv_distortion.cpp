// Query: how much texture coordinates stretch each face.
#include "core/metrics/uv_distortion.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/metrics/uv_layout.h"

namespace mw {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// Sums over the triangles of a face, or of the mesh, weighted by their area on the surface.
struct Sums {
    double area = 0, chart = 0, angle = 0, angleArea = 0;
    void add(double surface, const Stretch& s)
    {
        if (!(surface > 0)) return;
        area += surface;
        chart += surface * s.s1 * s.s2;
        if (s.s2 <= 1e-12 * s.s1) return;
        angle += surface * s.s1 / s.s2;
        angleArea += surface;
    }
};

std::vector<Sums> sumsOf(const Mesh& mesh, const UvLayout& layout)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    std::vector<Sums> sums(mesh.faceCount());
    for (size_t t = 0; t < cut.faces.size(); ++t) {
        glm::dvec3 p[3];
        glm::dvec2 q[3];
        for (size_t k = 0; k < 3; ++k) {
            p[k] = mesh.positions()[cut.vertices[3 * t + k]];
            q[k] = layout.corners[cut.corners[3 * t + k]];
        }
        const Stretch s = stretchOf(p, q);
        if (std::isfinite(s.s1)) sums[cut.faces[t]].add(0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0])), s);
    }
    return sums;
}

}  // namespace

Stretch stretchOf(const glm::dvec3 (&p)[3], const glm::dvec2 (&q)[3])
{
    // The triangle in its own plane: (0, 0), (x1, 0), (x2, y2).
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double x1 = glm::length(e1), twice = glm::length(glm::cross(e1, e2));
    if (!(x1 > 0) || !(twice > 0)) return {undefined, undefined};
    const double x2 = glm::dot(e1, e2) / x1, y2 = twice / x1;
    const glm::dvec2 du = (q[1] - q[0]) / x1, dv = (q[2] - q[0] - du * x2) / y2;  // columns of the map
    const double a = glm::dot(du, du), b = glm::dot(du, dv), c = glm::dot(dv, dv);
    const double s1 = std::sqrt(0.5 * (a + c + std::hypot(a - c, 2 * b)));
    // From the determinant, which keeps digits that a difference would lose.
    return {s1, s1 > 0 ? std::abs(du.x * dv.y - du.y * dv.x) / s1 : 0};
}

Generator uvDistortion(Mesh input, UvDistortion p, Stage<Table>& stage)
{
    co_yield Step("measure faces").number("faces", double(input.faceCount())).progress(0);
    const UvLayout layout = uvLayoutOf(input, p.set);
    const std::vector<Sums> sums = sumsOf(input, layout);
    Sums all;
    for (const Sums& s : sums) {
        all.area += s.area;
        all.chart += s.chart;
        all.angle += s.angle;
        all.angleArea += s.angleArea;
    }
    const double density = all.area > 0 ? all.chart / all.area : 0;
    Array<double> angle(sums.size(), undefined), area(sums.size(), undefined);
    double worstAngle = 1, least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (size_t f = 0; f < sums.size(); ++f) {
        const Sums& s = sums[f];
        if (s.angleArea > 0) worstAngle = std::max(worstAngle, angle[f] = s.angle / s.angleArea);
        if (!(s.area > 0) || !(density > 0)) continue;
        area[f] = s.chart / s.area / density;
        least = std::min(least, area[f]);
        greatest = std::max(greatest, area[f]);
    }
    Table table;
    table.rows = ElementKind::Face;
    table.columns.push_back({"angle", "", std::move(angle), false});
    table.columns.push_back({"area", "", std::move(area), false});
    table.summary = {{"mean angle distortion", all.angleArea > 0 ? all.angle / all.angleArea : 1},
                     {"greatest angle distortion", worstAngle},
                     {"least area factor", std::isfinite(least) ? least : 0},
                     {"greatest area factor", greatest},
                     {"faces folded over", double(layout.folded.size())},
                     {"seam edges", double(layout.seams)}};
    stage.finish(std::move(table));
}

}  // namespace mw
