// A foreign file as a Scene, by Assimp. What it gives is looked through as any other thing from outside.
#pragma once
#include <filesystem>

#include "core/io/io.h"

namespace mw {

/// FBX, X, MD5, COLLADA, 3D Studio. Nodes are all kept, with the names they have; names that bones or motions go by are unique. Polygons
/// stay polygons; vertices at one place with equal weights and morphs are one (normals and texture coordinates lie at corners). Several
/// meshes of one name at one node are one mesh with material slots (Assimp cuts by material), others of that node become nodes below it. Where the
/// format says lengths and axes, a node at the root turns them into metres with +Y up. Throws Error; may crash where Assimp does.
Imported readByAssimp(const std::filesystem::path& file);

}  // namespace mw
