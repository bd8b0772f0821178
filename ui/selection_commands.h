// Commands that change which elements of the active mesh are selected. What takes long on a large mesh runs as a job.
#pragma once
#include <QString>
#include <functional>

#include "core/mesh/select.h"
#include "ui/session.h"

namespace mw::selecting {

/// From the mesh as shown and what is selected of it to what is to be selected. Pure: it may run on a worker.
using Find = std::function<ElementSet(const Mesh&, const ElementSet&, Progress&)>;

/// The mesh whose elements are meant: of the active node, at the level that is shown. Nothing when there is none.
std::optional<Mesh> activeMesh(const Session& session);
ElementKind elementKind(PickKind kind);  ///< faces for objects and joints

/// Selects what `find` finds and makes its kind the one that clicks pick. At once on a small mesh.
void run(Session& session, const QString& name, Find find);
/// Everything of the kind that is picked, or what is not selected of it.
void all(Session& session);
void invert(Session& session);
/// The loop of an edge of a node's mesh: what a double click on it does. `add` keeps what was selected.
void selectLoop(Session& session, NodeId node, uint32_t a, uint32_t b, bool add);

}  // namespace mw::selecting
