// A topology report as a worklist: what is to be fixed, each offender as elements to select, and what passed. No widgets.
#pragma once
#include <QString>
#include <map>
#include <vector>

#include "core/mesh/table.h"
#include "core/mesh/topology.h"

namespace mw {

/// One thing to look at: a loop, an edge, a face, a few vertices.
struct Offender {
    QString name, figure;
    ElementSet elements;
};

/// One check. Without offenders it passed.
struct Finding {
    QString id, title, figure;
    QString checked;                  ///< what was looked at, one short sentence
    ElementSet all;                   ///< every offender
    std::vector<Offender> offenders;  ///< the first `maxOffenders`, worst first
    size_t total = 0;
    std::string repair;  ///< an operation that mends it; empty when none is known
    QString repairText;  ///< on its button

    bool passed() const { return total == 0; }
};

struct Inspection {
    static constexpr size_t maxOffenders = 1000;
    Mesh mesh;  ///< held: indices are its own
    size_t vertices = 0, isolated = 0, edges = 0, faces = 0, components = 0;
    long euler = 0;
    std::optional<long> genus;
    std::vector<Finding> findings;  ///< worst first, then those that passed
    std::map<size_t, size_t> valences;
    double regular = 0;  ///< share of the vertices that have the usual valence

    size_t toFix() const;
};

/// Takes its time on a large mesh: call it on a worker.
Inspection inspect(const Mesh& mesh);

/// Bounds of elements in the mesh's own space.
Bounds boundsOf(const Mesh& mesh, const ElementSet& elements);
/// Vertices that have this many edges.
ElementSet verticesOfValence(const Mesh& mesh, size_t valence, bool orMore);

}  // namespace mw
