// The edits of terrains, as calls of the list of edits. Each is one history entry; what takes time runs as a job.
#pragma once
#include <QString>

#include "ui/session.h"

namespace mw::edits {

/// The active node if it is a terrain, else the first visible one; none when there is no such.
NodeId activeTerrain(const Document& document);
const TerrainObject* terrainOf(const Document& document, NodeId node);
/// The scene with another terrain at a node.
Scene withTerrain(const Document& document, NodeId node, Terrain terrain);
void previewTerrain(Document& document, NodeId node, Terrain terrain);
void commitTerrain(Document& document, NodeId node, Terrain terrain, const QString& what);

/// A terrain by diamond-square, and one made by any source of height maps, as a further node.
void newTerrain(Session& session);
void newTerrain(Session& session, const Operation& source, const ParameterValues& values);
/// Another map for a terrain that is there.
void generate(Session& session, NodeId node, const Operation& source, const ParameterValues& values);
/// In place of the active terrain's map, or as a further terrain. `done` gets the text of an error, or nothing.
void importPicture(Session& session, const QString& file, bool asNew, std::function<void(const QString&)> done);
void exportPicture(Session& session, NodeId node, const QString& file, std::function<void(const QString&)> done);
/// Its surface as a mesh node beside it, within a number of triangles.
void terrainToMesh(Session& session, NodeId node, size_t triangles);

/// Operations that make height maps out of nothing.
std::vector<const Operation*> heightSources();

}  // namespace mw::edits
