// What is wrong with a mesh, as a worklist: each kind explained in one sentence, with its elements and the operation that mends it.
#pragma once
#include <string>
#include <vector>

#include "core/mesh/table.h"
#include "core/steps/progress.h"

namespace mw {

/// One check and what it found; without elements it passed.
struct Defect {
    std::string id;           ///< "holes", "nonmanifold-edges", ...: stable, for scripts
    std::string title;        ///< "Holes"
    std::string explanation;  ///< one sentence: what it is and what it breaks
    std::string checked;      ///< one sentence, when it passed: "Every edge has two faces."
    /// Each offender by itself: a loop of edges, an edge, a face, a component's faces; worst first. Kinds agree within one defect.
    std::vector<ElementSet> offenders = {};
    std::string repair = {};            ///< id of the operation that mends it; empty when none does
    std::string repairParameters = {};  ///< "k=v,k=v", where they differ from the operation's defaults
    bool passed() const { return offenders.empty(); }
};

struct DefectOptions {
    bool selfIntersections = true;  ///< the slow one
    double tinyComponent = 0.01;    ///< a component is tiny when its box diagonal is below this share of the mesh's
};

/// Every check, worst first, those that passed at the end: nonmanifold-edges, nonmanifold-vertices, coincident-vertices, degenerate-faces,
/// duplicate-faces, orientation, self-intersections, tiny-components, holes, isolated-vertices. Run in this order, the repairs do not undo
/// each other. Self-intersections have none; their offenders are groups of faces that hang together by intersecting. Coincident vertices are
/// only those that can become one without making the surface non-manifold. Throws Cancelled.
std::vector<Defect> defectsOf(const Mesh& mesh, const DefectOptions& options = {}, Progress* progress = nullptr);

}  // namespace mw
