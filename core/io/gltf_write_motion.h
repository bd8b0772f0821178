// What moves, on its way out: skins and animations of nodes that have their places in the file.
#pragma once
#include <map>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/io/gltf_builder.h"
#include "core/scene/scene.h"

namespace mw {

/// Where nodes went. A skinned mesh may be carried by another node of the file than the one it belongs to.
struct GltfPlaces {
    struct Shown {
        size_t node = 0, targets = 0;  ///< what carries its mesh; morph targets that were written
    };
    std::map<NodeId, size_t> nodes;
    std::map<NodeId, Shown> meshes;
};

/// Roots that need a common parent, because glTF wants one above all joints of a skin. Each root is in one group at most.
std::vector<std::vector<NodeId>> rootsToJoin(const Scene& scene);

/// Gives the index of the skin. A joint that it names twice gets a second node below the first.
size_t addSkin(GltfBuilder& builder, const Scene& scene, const Skin& skin, const GltfPlaces& places);
/// Skins without a mesh, for skeletons of which no joint is in `done`: without one, other programs take joints for plain nodes.
void addSkeletons(GltfBuilder& builder, const Scene& scene, const GltfPlaces& places, const std::set<NodeId>& done);

/// One animation a clip. Euler angles and single coordinates become rotations and translations, with keys where those had some.
void addAnimations(GltfBuilder& builder, const Scene& scene, const GltfPlaces& places, std::vector<Warning>& warnings);

}  // namespace mw
