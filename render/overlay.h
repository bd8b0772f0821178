// What lies flat over the picture: labels, the legend of a heat map, the orientation marker.
#pragma once
#include <optional>

#include "render/canvas.h"
#include "render/draw_context.h"

namespace mw {

/// From the top left, in device pixels.
struct Rectangle {
    glm::vec2 low, high;
};
/// Where a label goes: beside its point, where it covers none of those `taken`, which it joins; further above or below within the picture
/// where they crowd; nowhere when there is no room at all.
std::optional<Rectangle> placeLabel(glm::vec2 at, glm::vec2 extent, float gap, glm::vec2 picture, std::vector<Rectangle>& taken);
void drawLabels(const DrawContext& c, Canvas& canvas);
void drawLegend(const DrawContext& c, Canvas& canvas);
void drawFlats(const DrawContext& c, Canvas& canvas);  ///< handles of tools, over everything
void drawMarker(const DrawContext& c, Canvas& canvas);

/// Counts of a column's values over the range shown, for the legend; values outside are in the first and last bar.
std::vector<size_t> histogramOf(const Column& column, double low, double high, size_t bars);
/// A short number for ticks: three significant digits.
std::string tickText(double v);

}  // namespace mw
