// Polygons to begin a curve with: a few shapes, or points given one by one.
#pragma once
#include <string>

#include "core/mesh/curve.h"
#include "core/steps/stage.h"

namespace mw {

/// In the plane z = 0, within a square of side 2 round the origin, unless points are given. O(points).
struct SampleCurve {
    enum class Shape { Zigzag, Wave, Polygon, Star, Spiral, Letter };

    Shape shape = Shape::Zigzag;
    int64_t points = 8;
    std::string given;
    bool closed = false;

    template <class V>
    void describe(V& v)
    {
        v.choice("shape", shape, {"zigzag", "wave", "polygon", "star", "spiral", "letter"},
                 {.title = "Shape", .help = "polygon and star are closed; letter is an S of nine points."});
        v.integer("points", points, {.title = "Points", .help = "How many the shape is sampled at.", .min = 3, .max = 100000, .softMax = 64});
        v.text("given", given, {.title = "Given", .help = "Points instead of a shape: x,y or x,y,z each, with spaces between."});
        v.flag("closed", closed, {.title = "Closed", .help = "The last point is joined to the first."});
    }
};

Generator sampleCurve(SampleCurve parameters, Stage<Curve>& stage);

/// "x,y x,y ..." or with z; spaces or line ends between points. Throws Error that says which point is wrong.
Array<glm::dvec3> pointsIn(std::string_view text);

}  // namespace mw
