// A skeleton as flat arrays, and a pose of it with targets: what kinematics work on. Scenes give them by core/scene/scene_pose.h.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/math/id.h"
#include "core/math/transform.h"
#include "core/mesh/mesh.h"

namespace mw {

struct Joint {
    std::string name;
    uint32_t parent = none;  ///< always before its children
    Transform rest;
    NodeId node;       ///< of the scene it was taken from
    bool end = false;  ///< an end site: a place without motion of its own
};
struct Skeleton {
    std::vector<Joint> joints;
};

/// Where a joint is wanted, world space.
struct PoseTarget {
    uint32_t joint;
    glm::dvec3 at;
};

/// Cheap to copy but for the transforms. World space is that of the scene, metres.
struct Pose {
    std::shared_ptr<const Skeleton> skeleton;
    std::vector<Transform> locals;  ///< by joint
    glm::dmat4 worldFromParent{1};  ///< of the parents of roots
    std::vector<PoseTarget> targets;
    size_t size() const { return locals.size(); }
};
std::vector<glm::dmat4> worldMatrices(const Pose& p);
std::vector<glm::dvec3> jointPlaces(const Pose& p);
/// The joint of that name, or "#INDEX": joints first, as listings of a file number them, then end sites. Throws Error that lists what is near.
uint32_t jointOf(const Skeleton& s, std::string_view name);
/// What jointOf() finds this joint by: its name, or its number where others have that name.
std::string calledBy(const Skeleton& s, uint32_t joint);
size_t byteSize(const Pose& p);
uint64_t contentHash(const Pose& p);

}  // namespace mw
