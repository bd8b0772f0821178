// Query: elements of a mesh that have something in common, as a selection.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/progress.h"
#include "core/steps/stage.h"

namespace mw {

struct SelectElements {
    enum class Kind { Vertices, Edges, Faces } kind = Kind::Faces;
    enum class By { All, Boundary, Component, Defect, Valence, Angle } by = By::Boundary;
    std::string defect = "holes";
    int64_t rank = 1, least = 0, most = 5;
    double angle = 30;
    template <class V>
    void describe(V& v)
    {
        v.choice("kind", kind, {"vertices", "edges", "faces"}, {.title = "Kind", .help = "What is selected."});
        v.choice("by", by, {"all", "boundary", "component", "defect", "valence", "angle"}, {.title = "By", .help = "What they have in common."});
        v.text("defect", defect,
               {.title = "Defect", .help = "Id of a check: holes, nonmanifold-edges, self-intersections, and so on.", .when = "by=defect"});
        v.integer(
            "rank", rank,
            {.title = "Component", .help = "1: the one with most faces, 2: the next.", .min = 1, .max = 4e9, .softMax = 100, .when = "by=component"});
        v.integer("least", least,
                  {.title = "Valence from", .help = "Fewest edges at a vertex.", .min = 0, .max = 4e9, .softMax = 20, .when = "by=valence"});
        v.integer("most", most,
                  {.title = "Valence to", .help = "Most edges at a vertex.", .min = 0, .max = 4e9, .softMax = 20, .when = "by=valence"});
        v.number("angle", angle,
                 {.title = "Angle", .help = "Edges whose faces bend more than this.", .unit = "°", .min = 0, .max = 180, .when = "by=angle"});
    }
};

/// Whatever `by` finds is converted to `kind`: down to all that belongs to it, up to what it touches. Throws Error when the defect is none.
Generator selectElements(Mesh input, SelectElements parameters, Stage<ElementSet>& stage);

/// All elements that one check of defectsOf() finds; of the kind of its offenders. Throws Error that lists the checks, Cancelled.
ElementSet elementsWithDefect(const Mesh& mesh, const std::string& defect, Progress* progress = nullptr);

}  // namespace mw
