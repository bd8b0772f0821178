// What the verbs that make pictures share.
#pragma once
#include <optional>
#include <string>

#include "app/cli/arguments.h"
#include "app/cli/operation_call.h"
#include "render/renderer.h"

namespace mw::cli {

struct PictureSize {
    int width = 1280, height = 800;
};
/// "--size 1280x800". Throws UsageError; each side 1 to 16384.
PictureSize takeSize(Arguments& arguments, PictureSize otherwise);
/// "--theme dark|light"; dark unless said.
Theme takeTheme(Arguments& arguments);
std::optional<Theme> takeThemeIfSaid(Arguments& arguments);

/// How it is drawn: --style, --light, --light-turn, --shadows, --no-grid, --transparent, --theme.
struct PictureLook {
    ViewOptions options;
    std::optional<OperationCall> metric;  ///< values as colours
};
PictureLook takeLook(Arguments& arguments);
/// Lines of a usage text that tell of them.
#define MESHWRIGHT_LOOK_HELP                                                                                                                       \
    "  --style STYLE   shaded (as the materials say), flat (faces and edges), wire, matcap[:NAME] (clay, porcelain, wax, jade, metal, gold,\n"     \
    "                  normal, zebra), checker (squares by texture coordinates), or heat:METRIC[:k=v,...], where METRIC is a\n"                    \
    "                  query of `meshwright algorithms` that gives a number for each vertex or face (heat:vertex-valence)\n"                       \
    "  --light LIGHT   three-point (goes with the camera), studio, overcast, sunset, even (white from everywhere), sun; three-point unless said\n" \
    "  --light-turn D  degrees by which the surroundings are turned about the upright axis\n"                                                      \
    "  --shadows       of the brightest light, on the model and on the ground\n"                                                                   \
    "  --no-grid       no ground lines, axes and marker\n"                                                                                         \
    "  --transparent   the model alone, nothing behind it\n"

/// --camera EYE/TARGET/FOV, as "4,3,2/0,0,0/40"; the angle, vertical, may be left out.
std::optional<Camera> takeCamera(Arguments& arguments);

/// A column of a table as colours over the range that shows most of it.
std::shared_ptr<const HeatMap> heatMapOf(Table table, size_t column = 0);

}  // namespace mw::cli
