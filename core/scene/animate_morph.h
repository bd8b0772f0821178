// A clip that plays a morph target: there and back.
#pragma once
#include "core/scene/scene.h"

namespace mw {

/// Morph targets of what the object shows: those of its base, and one for each modifier that makes one.
size_t morphTargets(const MeshObject& object);
/// True when a clip drives the weights of the node's morph targets.
bool playsMorphs(const Scene& scene, NodeId node);
/// The weight of target number `target` (from 1; 0: the last) goes from 0 to 1 and back over `seconds`, the others stay 0. Throws Error when the node
/// shows no mesh with such a target.
Clip morphClip(const Scene& scene, NodeId node, size_t target, double seconds);
/// A clip for each node of the mesh whose weights none plays; `before`: how many targets it had. Gives the clips.
std::vector<ClipId> animateNewMorphs(Scene& scene, MeshId mesh, size_t before);

}  // namespace mw
