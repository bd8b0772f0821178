// The colours of ui/UI.md: theme tokens, roles, colour maps. sRGB, 0 to 1, unless it says linear.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/steps/step.h"
#include "render/renderer.h"

namespace mw {

constexpr glm::vec3 hex(uint32_t rgb)
{
    return {float(rgb >> 16 & 255) / 255.f, float(rgb >> 8 & 255) / 255.f, float(rgb & 255) / 255.f};
}

/// What the view itself draws with.
struct ThemeColors {
    glm::vec3 top, bottom;           ///< of the view's background
    glm::vec3 panel, border, field;  ///< of legend and labels
    glm::vec3 text, text2, bars;     ///< bars: of the histogram
    glm::vec3 grid, wire;
    glm::vec3 skyTop, skyBottom;  ///< of the background when a terrain is there
};
const ThemeColors& themeColors(Theme theme);

inline constexpr glm::vec3 selectedColor = hex(0xFF9A3C), defectColor = hex(0xFF6B5E), haloColor = hex(0x101215);
glm::vec3 roleColor(Role role);

/// The three rows of the colour table, 256 entries of RGBA each: viridis from 6 % on, diverging, the 24 categories.
inline constexpr int heatEntries = 256, categoryCount = 24;
glm::vec3 categoryColor(int i);
enum HeatRow { viridisRow, divergingRow, categoryRow };
std::vector<uint8_t> heatTablePixels();

/// Row of the table that a heat map is shown with: zero in the middle of a range asks for the diverging map.
HeatRow heatRow(const HeatMap& heat);

/// The heat map of an object, when it has one that fits its mesh and has such rows; else null.
const HeatMap* heatOf(const DrawObject& o, ElementKind rows);

glm::vec3 linearOf(glm::vec3 srgb);

}  // namespace mw
