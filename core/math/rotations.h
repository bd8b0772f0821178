// Orientations said in several ways, and paths between two of them (book chapter 6). Quaternions are unit, w first in glm.
#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace mw {

/// Rotation about one axis (0 x, 1 y, 2 z), radians.
glm::dquat aboutAxis(int axis, double angle);
/// Product of three rotations about `axes` by `angles`, first one leftmost: an intrinsic sequence, as channels of a BVH file.
glm::dquat quaternionOf(const int axes[3], const double angles[3]);
/// The shorter arc at constant speed (6.38); near each other by normalised mixing.
glm::dquat slerp(const glm::dquat& a, glm::dquat b, double t);

/// Several paths between the same two orientations; what the rotation lab steps through. Angles in degrees, so that a path shows its own.
struct Rotations {
    struct Sample {
        double t;
        glm::dquat orientation;
        glm::dvec3 euler;  ///< the angles it was made of; NaN for paths that have none
    };
    struct Path {
        const char* name;  ///< "euler", "slerp"; static storage
        std::vector<Sample> samples;
    };
    glm::dquat from{1, 0, 0, 0}, to{1, 0, 0, 0};
    std::vector<Path> paths;
};
size_t byteSize(const Rotations& r);
uint64_t contentHash(const Rotations& r);

}  // namespace mw
