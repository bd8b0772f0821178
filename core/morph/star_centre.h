// A point from which all of a closed mesh is seen.
#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace mw {

/// A point in front of no triangle (three entries each), so that rays from it meet each direction once; nothing when none was found. Tries the centre
/// of volume, then walks to the nearest point behind the plane it is farthest in front of (relaxation of Agmon and of Motzkin and Schoenberg 1954).
std::optional<glm::dvec3> starCentre(std::span<const glm::dvec3> positions, std::span<const uint32_t> triangles);

}  // namespace mw
