// The way of a brush as text, exact: "10/-20;12.5/-18".
#pragma once
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/terrain/brush.h"

namespace mw {

std::string strokeText(std::span<const glm::dvec2> places);
/// The inverse. Throws Error naming the place that does not fit; places are finite and at most 1e8 m from the middle.
std::vector<glm::dvec2> parsedStroke(std::string_view text);
/// About how many dabs that makes.
double dabsOf(std::span<const glm::dvec2> places, const Brush& brush);

}  // namespace mw
