// The edits of a modifier stack, as calls of the list of edits. Each is one history entry.
#pragma once
#include <QString>

#include "core/scene/document.h"
#include "ui/session.h"

namespace mw::edits {

/// The mesh object of the active node; none when there is no such.
MeshId activeMesh(const Document& document);
QString titleOf(const Modifier& m);  ///< of its operation, or the id when unknown here

/// Without values, parameters that name another mesh get the only other one there is. A morph comes with a clip that plays it.
void addModifier(Document& document, MeshId mesh, const Operation& op, ParameterValues values = {});
void removeModifier(Document& document, MeshId mesh, size_t index);
void moveModifier(Document& document, MeshId mesh, size_t from, size_t to);
void duplicateModifier(Document& document, MeshId mesh, size_t index);
void enableModifier(Document& document, MeshId mesh, size_t index, bool on);
void previewValues(Document& document, MeshId mesh, size_t index, const ParameterValues& values);
void commitValues(Document& document, MeshId mesh, size_t index, const ParameterValues& values, const QString& what);
/// The result of the first `levels` rows becomes the base; at once when it is known, else as a job.
void applyStack(Session& session, MeshId mesh, size_t levels);

void removeNodes(Session& session, const std::vector<NodeId>& nodes);
void setVisible(Document& document, const std::vector<NodeId>& nodes, bool visible);
void rename(Document& document, NodeId node, const QString& name);

}  // namespace mw::edits
