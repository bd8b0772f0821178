// From a scene and a time to where everything stands.
#pragma once
#include <map>
#include <vector>

#include "core/character/pose.h"
#include "core/scene/scene.h"

namespace mw {

/// What differs from the scene as it rests. Empty: it rests.
struct ScenePose {
    std::map<NodeId, Transform> locals;
    std::map<NodeId, std::vector<double>> weights;  ///< of morph targets, by node
};
/// Of one clip; nodes it does not drive rest.
ScenePose poseAt(const Scene& scene, const Clip& clip, double time);

/// World matrices of all nodes.
std::map<NodeId, glm::dmat4> worldMatrices(const Scene& scene, const ScenePose& pose);
/// Of the mesh that a node shows; null when neither skin nor morph weights move it. `shown` is the evaluated mesh.
std::shared_ptr<const MeshPose> meshPose(const Scene& scene, NodeId node, const Mesh& shown, const ScenePose& pose,
                                         const std::map<NodeId, glm::dmat4>& worlds);
/// The matrix that places a node's mesh: identity when it is skinned.
glm::dmat4 worldFromMesh(const Scene& scene, NodeId node, const std::map<NodeId, glm::dmat4>& worlds);

/// Nodes that are the topmost joints, in tree order: one a skeleton.
std::vector<NodeId> skeletonRoots(const Scene& scene);
/// A skeleton from its root down, all nodes between joints included; posed.
Pose poseOf(const Scene& scene, NodeId skeletonRoot, const ScenePose& pose = {});
/// A clip of rotations and translations that leads from one pose to another of the same skeleton over `seconds`.
Clip keyed(const Pose& from, const Pose& to, double seconds, std::string name);
/// The scene frozen at a pose: meshes posed in their places, nodes where they stand, no skins, clips or morph targets.
Scene frozen(const Scene& scene, const ScenePose& pose, const std::function<Mesh(MeshId)>& shown);

}  // namespace mw
