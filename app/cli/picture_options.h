// What the verbs that make pictures share.
#pragma once
#include <string>

#include "app/cli/arguments.h"
#include "render/renderer.h"

namespace mw::cli {

struct PictureSize {
    int width = 1280, height = 800;
};
/// "--size 1280x800". Throws UsageError; each side 1 to 16384.
PictureSize takeSize(Arguments& arguments, PictureSize otherwise);
/// "--theme dark|light".
Theme takeTheme(Arguments& arguments);

/// A column of a table as colours over the range that shows most of it.
std::shared_ptr<const HeatMap> heatMapOf(Table table, size_t column = 0);

}  // namespace mw::cli
