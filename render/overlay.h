// What lies flat over the picture: labels, the legend of a heat map, the orientation marker.
#pragma once
#include "render/canvas.h"
#include "render/draw_context.h"

namespace mw {

void drawLabels(const DrawContext& c, Canvas& canvas);
void drawLegend(const DrawContext& c, Canvas& canvas);
void drawFlats(const DrawContext& c, Canvas& canvas);  ///< handles of tools, over everything
void drawMarker(const DrawContext& c, Canvas& canvas);

/// Counts of a column's values over the range shown, for the legend; values outside are in the first and last bar.
std::vector<size_t> histogramOf(const Column& column, double low, double high, size_t bars);
/// A short number for ticks: three significant digits.
std::string tickText(double v);

}  // namespace mw
