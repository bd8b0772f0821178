// Materials of meshes: who uses them, and the names by which edits call them.
#pragma once
#include "core/scene/scene.h"

namespace mw {

enum class TextureKind { BaseColor, MetallicRoughness, Normal, Occlusion, Emissive };
inline const std::vector<std::string>& textureKinds()
{
    static const std::vector<std::string> all{"base-color", "metallic-roughness", "normal", "occlusion", "emissive"};
    return all;
}

Material::Texture& textureOf(Material& m, TextureKind k);
const Material::Texture& textureOf(const Material& m, TextureKind k);

/// Slots of mesh objects that have it.
size_t users(const Scene& scene, MaterialId id);
/// Its name where only one has it, else "#7".
std::string materialText(const Scene& scene, MaterialId id);
MaterialId materialOf(const Scene& scene, std::string_view text);  ///< throws Error
/// "Material", "Material 2", ...: a name that no material has yet.
std::string freshMaterialName(const Scene& scene, const std::string& wanted);
/// The material of a slot of the node's mesh. Throws Error when the node has no mesh, or the mesh no such slot.
MaterialId materialAt(const Scene& scene, NodeId node, int64_t slot);
/// Materials and pictures that nothing uses go.
void dropUnusedPayloads(Scene& scene);

}  // namespace mw
