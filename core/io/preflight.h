// What an export would leave out or change, found without writing: the list a person reads before they press Export.
#pragma once
#include <string>
#include <vector>

#include "core/io/io.h"

namespace mw {

struct PreflightItem {
    enum class Severity { Error, Warning, Note } severity = Severity::Note;
    std::string node;  ///< whom it concerns; empty: all of the scene
    std::string text;  ///< "2 skins are left out: OBJ has no skeletons"
};

/// For a file of this ending (".obj"). `shown` gives the evaluated mesh of each object; errors come first, then what is lost, then notes.
std::vector<PreflightItem> preflight(const Scene& scene, const std::string& ending, const WriteOptions& options,
                                     const std::function<Mesh(MeshId)>& shown);

/// These nodes with what is below them, at their places in the world; joints of their skins stay, too.
Scene onlyNodes(const Scene& scene, const std::vector<NodeId>& nodes);

/// What a written scene amounts to: visible meshes and their faces.
struct ExportedAmount {
    size_t meshes = 0, faces = 0, clips = 0, terrains = 0;
};
ExportedAmount amountOf(const Scene& scene, const std::function<Mesh(MeshId)>& shown);

}  // namespace mw
