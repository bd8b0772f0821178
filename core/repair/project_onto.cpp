#include "core/repair/project_onto.h"

#include "core/error.h"
#include "core/mesh/triangle_tree.h"

namespace mw {

Generator projectOnto(Mesh input, ProjectOnto parameters, Stage<Mesh>& stage)
{
    constexpr size_t piece = 16384;
    if (parameters.other.mesh.triangulation().faces.empty())
        throw Error("project-onto: the other mesh \"" + parameters.other.name + "\" has no faces; name one that has a surface");
    co_yield Step("index").progress(0);
    const TriangleTree tree(parameters.other.mesh);
    Array<glm::vec3> places(input.positions().begin(), input.positions().end());
    const std::vector<glm::dvec3> points(places.begin(), places.end());
    for (size_t first = 0; first < points.size(); first += piece) {
        const size_t count = std::min(piece, points.size() - first);
        const std::vector<ClosestPoint> found = closestPoints(tree, std::span(points).subspan(first, count));
        for (size_t i = 0; i < count; ++i) places[first + i] = glm::vec3(points[first + i] + parameters.amount * (found[i].at - points[first + i]));
        co_yield Step("project").progress(double(first + count) / double(points.size()));
    }
    stage.finish(input.withPositions(std::move(places)));
}

}  // namespace mw
