// Matcaps: the picture of a lit sphere, looked up by the normal. Made by formulas; no GL here.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace mw {

struct Matcap {
    const char* name;                      ///< "clay", ...
    const char* title;                     ///< as the menu says it
    glm::vec3 (*shade)(glm::vec3 normal);  ///< linear; view space, unit, z towards the eye
};

std::span<const Matcap> matcaps();
/// The one of that name; null when there is none.
const Matcap* findMatcap(std::string_view name);

/// RGBA, 8 bit, sRGB; the bottom row first. Beyond the sphere the colours of its rim go on.
std::vector<uint8_t> matcapPixels(const Matcap& m, int side);

}  // namespace mw
