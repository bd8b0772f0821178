// The extension MESHWRIGHT_project: what a project file keeps beside the plain glTF that any viewer shows. Base meshes with their polygons,
// attributes, lines and groups, modifier stacks, nodes, materials, images, skins, clips and terrains, with the ids they had, in buffer views of
// their own; and a hash of the plain part, by which a change by another program is noticed.
//
//   "MESHWRIGHT_project": { "version": 2, "core": {"hash": HEX, "views": N, "bytes": N}, "roots": [ID...],
//       "nodes": [...], "meshes": [...], "materials": [...], "images": [...], "skins": [...], "clips": [...], "terrains": [...] }
//
// Version 1 had no skins, clips and terrains.
#pragma once
#include <map>

#include "core/io/gltf_builder.h"
#include "core/io/gltf_document.h"
#include "core/scene/scene.h"

namespace mw {

inline constexpr const char* projectExtension = "MESHWRIGHT_project";
inline constexpr int projectVersion = 2;

/// Adds the extension to a finished plain glTF. `imageViews` has the views of pictures that are in it already.
void addProject(GltfBuilder& builder, const Scene& scene, const std::map<const void*, size_t>& imageViews);

bool hasProject(const GltfDocument& document);
/// False when the plain part is not the one it was saved with. Throws Error when the project says nothing usable about it.
bool projectIsIntact(const GltfDocument& document);
/// The scene as it was saved. Throws Error when anything in it is damaged or of a newer version.
Scene readProject(GltfDocument& document);

}  // namespace mw
