// An artist's mannequin made by code: a smooth closed body, a skeleton, weights and motions. What lessons and tests of characters start from.
#pragma once
#include <string>
#include <vector>

#include "core/character/pose.h"
#include "core/mesh/mesh.h"

namespace mw {

/// A motion as one key a frame of every joint.
struct MannequinMotion {
    std::string name;
    std::vector<double> times;                       ///< seconds from 0; the last frame equals the first
    std::vector<glm::dvec3> hips;                    ///< where the hips are, one a frame
    std::vector<std::vector<glm::dquat>> rotations;  ///< by joint, one a frame; empty: it rests
};

/// 1.75 m tall, facing +Z, +X is its left, arms half lowered; all rest rotations are none, so that a joint's rotation is that of its bone.
struct Mannequin {
    Skeleton skeleton;                     ///< Hips first
    std::vector<glm::dmat4> inverseBind;   ///< by joint
    Mesh mesh;                             ///< quads, with "joints" and "weights" (slots are joints)
    std::vector<MannequinMotion> motions;  ///< "Walk": on the spot, as on a treadmill; "Idle"
};

/// How fast the ground passes below its feet in "Walk", m/s.
inline constexpr double mannequinWalkSpeed = 1.0;

Skeleton mannequinSkeleton();
/// The surface where a field of distance is 0: rounded limbs along the bones, blended (mannequin_body.cpp).
Mesh mannequinBody();
/// "joints" and "weights" by bone heat (Baran and Popovic 2007): each vertex takes heat from the nearest bone it sees, and the surface conducts it.
Mesh withBoneHeat(const Mesh& body, const Skeleton& skeleton);
/// From gait curves; legs follow from where the feet are. The body must have its weights: feet stand on the ground by it.
std::vector<MannequinMotion> mannequinMotions(const Skeleton& skeleton, const Mesh& body);
Mannequin mannequin();

}  // namespace mw
