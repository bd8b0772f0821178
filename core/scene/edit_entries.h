// How a function becomes an edit: its parameter struct is described, the function wrapped. For the files that define edits.
#pragma once
#include "core/catalog/entries.h"
#include "core/scene/edit.h"

namespace mw {

/// `heavy`: the window runs it as a job.
template <class P>
Edit editEntry(std::string id, std::string title, std::string summary, void (*apply)(Scene&, const P&, EditRun&),
               std::string (*name)(const Scene&, const P&), bool heavy = false)
{
    return {std::move(id),
            std::move(title),
            std::move(summary),
            described<P>(),
            [apply](Scene& scene, const ParameterValues& values, EditRun& run) { apply(scene, filled<P>(values), run); },
            [name](const Scene& scene, const ParameterValues& values) { return name(scene, filled<P>(values)); },
            heavy};
}

/// "bunny", or "3 nodes".
std::string spoken(const Scene& scene, const std::vector<NodeId>& nodes);

/// The number with its thousands apart: "20,000".
std::string grouped(int64_t n);
/// What differs between two settings of an operation, for the name of a history entry: "faces 20,000", "3 values".
std::string differenceText(const std::vector<Parameter>& parameters, const ParameterValues& before, const ParameterValues& after);
/// The object that a node shows. Throws Error when it shows none.
MeshObject meshOf(const Scene& scene, NodeId node);
/// Throws Error unless it takes `accepts` and makes `yields`.
const Operation& operationOf(const std::string& id, Kind accepts, Kind yields);
/// A name that no node has: "box", "box 2", ...
std::string freeName(const Scene& scene, const std::string& name);
/// Throws Error when a node's mesh is moved by a skin or by morph targets, which `what` ("joining") cannot keep.
void requireStill(const Scene& scene, NodeId node, const char* what);

// The edits, by file; edit.cpp joins them.
std::vector<Edit> sceneEdits();      // edit_scene.cpp: what comes and goes
std::vector<Edit> fileEdits();       // core/io/edit_files.cpp: what comes from files
std::vector<Edit> placementEdits();  // core/io/edit_placement.cpp: units and up axis of what was imported
std::vector<Edit> nodeEdits();       // edit_nodes.cpp: names, places, what is shown
std::vector<Edit> meshEdits();       // edit_mesh.cpp: faces, edges and vertices of meshes
std::vector<Edit> elementEdits();    // edit_elements.cpp: elements in their places
std::vector<Edit> stackEdits();      // edit_stack.cpp: modifiers
std::vector<Edit> materialEdits();   // edit_material.cpp: slots of a mesh, which faces they cover, values of what is in them
std::vector<Edit> textureEdits();    // core/io/edit_texture.cpp: pictures on materials
std::vector<Edit> terrainEdits();    // edit_terrain.cpp: terrains and strokes
std::vector<Edit> clipEdits();       // edit_clips.cpp: motions

}  // namespace mw
