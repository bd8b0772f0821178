// The list of defects as the inspector shows it: what is to be fixed, each offender with a name, what mends it, and what passed. No widgets.
#pragma once
#include <QString>
#include <map>
#include <vector>

#include "core/catalog/parameters.h"
#include "core/mesh/table.h"
#include "core/mesh/topology.h"
#include "core/repair/defects.h"

namespace mw {

/// One thing to look at: a loop, an edge, a face, a few vertices.
struct Offender {
    QString name, figure;
    ElementSet elements;
};

/// One check. Without offenders it passed, when it was measured.
struct Finding {
    QString id, title, figure;
    QString inFull;                   ///< "5 loops, 223 edges"
    QString explanation;              ///< what is wrong with it, one sentence
    QString checked;                  ///< what was looked at, one short sentence
    ElementSet all;                   ///< every offender
    std::vector<Offender> offenders;  ///< the first `maxOffenders`, worst first
    size_t total = 0;
    std::string repair;            ///< an operation that mends it; empty when none is known
    ParameterValues repairValues;  ///< where they differ from its defaults
    QString repairText;            ///< on its button
    bool measured = true;

    bool passed() const { return measured && total == 0; }
    bool toFix() const { return measured && total > 0; }
};

/// A modifier that mends one or several findings.
struct Mending {
    std::string operation;
    ParameterValues values;
    QString findings;  ///< their titles
};

struct Inspection {
    static constexpr size_t maxOffenders = 1000;
    static constexpr size_t intersectionFaces = 300'000;  ///< from here on self-intersections are measured when asked for
    Mesh mesh;                                            ///< held: indices are its own
    size_t vertices = 0, isolated = 0, edges = 0, faces = 0, components = 0;
    long euler = 0;
    std::optional<long> genus;
    std::vector<Finding> findings;  ///< to fix, worst first; then those not measured; then those that passed
    std::map<size_t, size_t> valences, faceSizes;
    double regular = 0;  ///< share of the vertices that have the usual valence

    size_t toFix() const;
    size_t passed() const;
    /// The modifiers that mend all of it, in the order in which they do not undo each other; findings with the same operation share one.
    std::vector<Mending> mendings() const;
};

/// Takes its time on a large mesh: call it on a worker. `everything`: slow checks too, whatever the size. Throws Cancelled.
Inspection inspect(const Mesh& mesh, bool everything = false, Progress* progress = nullptr);

/// Bounds of elements in the mesh's own space.
Bounds boundsOf(const Mesh& mesh, const ElementSet& elements);
/// Vertices that have this many edges.
ElementSet verticesOfValence(const Mesh& mesh, size_t valence, bool orMore);
ElementSet facesOfSize(const Mesh& mesh, size_t corners, bool orMore);

}  // namespace mw
