// What moves in a glTF: skins and animations, of nodes that have a place in the scene already.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/character/clip.h"
#include "core/character/skin.h"
#include "core/io/gltf_document.h"

namespace mw {

/// The nodes of the document by their index there.
struct GltfNodes {
    std::vector<NodeId> ids;           ///< none: the scene does not have it
    std::vector<size_t> morphTargets;  ///< of its mesh
};

/// By index in the document; those that cannot be used are left out with a warning. Throws Error.
std::vector<std::optional<Skin>> gltfSkins(GltfDocument& document, const GltfNodes& nodes);
/// Animations with the channels that can be used; the others become warnings. Throws Error.
std::vector<Clip> gltfClips(GltfDocument& document, const GltfNodes& nodes);

/// The mesh without weights of joints that a skin of `slots` does not have; `left` counts the vertices that lost some.
Mesh withinSlots(const Mesh& mesh, size_t slots, size_t& left);

}  // namespace mw
