// Rounded limbs and their smooth union as fields of distances: bodies of animals and figures are made of them.
#pragma once
#include <glm/vec3.hpp>
#include <span>

namespace mw {

/// A cone with a ball at each end. `flat` presses it along an axis about the first ball.
struct Limb {
    glm::dvec3 a, b;
    double ra, rb;
    glm::dvec3 flat{1};
};

/// Negative inside; exact for limbs that are not pressed flat, else a lower bound.
double distanceTo(const Limb& limb, const glm::dvec3& where);
/// All limbs blended over a width of about `blend`: the smooth minimum by exponentials, which does not depend on their order. At most 64.
double blendedDistance(std::span<const Limb> limbs, const glm::dvec3& where, double blend);

}  // namespace mw
