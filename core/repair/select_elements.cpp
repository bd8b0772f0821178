// Query: elements of a mesh that have something in common, as a selection.
#include "core/repair/select_elements.h"

#include "core/mesh/select.h"
#include "core/repair/defects.h"

namespace mw {

namespace {

ElementSet found(const Mesh& mesh, const SelectElements& p, ElementKind kind)
{
    switch (p.by) {
        case SelectElements::By::All:
            return allElements(mesh, kind);
        case SelectElements::By::Boundary:
            return boundary(mesh, kind);
        case SelectElements::By::Component:
            return component(mesh, kind, size_t(p.rank - 1));
        case SelectElements::By::Defect:
            return elementsWithDefect(mesh, p.defect);
        case SelectElements::By::Valence:
            return ofValence(mesh, size_t(p.least), size_t(p.most));
        case SelectElements::By::Angle:
            return sharpEdges(mesh, p.angle);
    }
    return {};
}

}  // namespace

ElementSet elementsWithDefect(const Mesh& mesh, const std::string& id, Progress* progress)
{
    DefectOptions options;
    options.selfIntersections = id == "self-intersections";
    std::string checks;
    for (const Defect& d : defectsOf(mesh, options, progress)) {
        checks += (checks.empty() ? "" : ", ") + d.id;
        if (d.id != id) continue;
        ElementSet all{d.offenders.empty() ? ElementKind::Vertex : d.offenders[0].kind, {}};
        for (const ElementSet& o : d.offenders) all.indices.insert(all.indices.end(), o.indices.begin(), o.indices.end());
        return sorted(std::move(all));
    }
    throw Error("there is no check \"" + id + "\"; there are: " + checks + (options.selfIntersections ? "" : ", self-intersections"));
}

Generator selectElements(Mesh input, SelectElements parameters, Stage<ElementSet>& stage)
{
    co_yield Step("find").number("elements", double(input.faceCount())).progress(0);
    const ElementKind kind = parameters.kind == SelectElements::Kind::Vertices ? ElementKind::Vertex
                             : parameters.kind == SelectElements::Kind::Edges  ? ElementKind::Edge
                                                                               : ElementKind::Face;
    stage.finish(converted(input, found(input, parameters, kind), kind, true));
}

}  // namespace mw
