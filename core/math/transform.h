// Translation, rotation and scale, as nodes and joints have them.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace mw {

struct Transform {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 scale{1};
    glm::dmat4 matrix() const;  ///< parent from local
    bool operator==(const Transform&) const = default;
};
/// The nearest translation, rotation, scale; `exact` false when the matrix shears.
Transform transformOf(const glm::dmat4& m, bool* exact = nullptr);

}  // namespace mw
