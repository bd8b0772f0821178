// The texture coordinates of a mesh as a picture. Painted on any thread; the panel keeps the last picture and moves it while a new one is made.
#pragma once
#include <QImage>
#include <atomic>
#include <glm/vec2.hpp>

#include "core/mesh/table.h"
#include "core/metrics/uv_layout.h"
#include "render/renderer.h"

namespace mw {

/// What is painted; shared and immutable, so that a worker may hold it.
struct UvSubject {
    Mesh mesh;
    UvLayout layout;
    Table distortion;  ///< columns "angle" and "area", a row a face
};

enum class UvColour { None, Angle, Area };

struct UvView {
    glm::dvec2 centre{0.5, 0.5};  ///< in the middle of the picture, v up
    double perUnit = 256;         ///< logical pixels a unit
};

struct UvOptions {
    UvColour colour = UvColour::None;
    Theme theme = Theme::Dark;
    QImage backdrop;       ///< the base colour picture; null: squares
    bool picture = true;   ///< show backdrop or squares
    ElementSet selection;  ///< of the mesh
    double pixelRatio = 1;
};

/// Of `size` logical pixels. Null when `stop` was set on the way.
QImage uvPicture(const UvSubject& subject, const UvView& view, const UvOptions& options, QSize size, const std::atomic<bool>* stop = nullptr);

/// Angle as the 3D view colours it; area from 1/high to high, logarithmic. Canvas and legend take their colours from the same.
struct UvRange {
    double low = 1, high = 2;
};
UvRange uvRangeOf(const UvSubject& subject, UvColour colour);
QColor uvColourOf(UvColour colour, double value, const UvRange& range);
/// The value that has its colour at that share of the legend's bar, 0 to 1.
double uvValueAt(UvColour colour, double share, const UvRange& range);

}  // namespace mw
