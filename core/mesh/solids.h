// Sources: the solids every editor offers, as polygons with texture coordinates. Closed ones have their outside anticlockwise, +Y is up, the
// middle of the box is at the origin, shared vertices are shared (seams lie in the corners' texture coordinates).
#pragma once
#include "core/mesh/describe_length.h"
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Box {
    double width = 1, height = 1, depth = 1;
    int64_t segments = 1;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "width", width, "Width", "Along X.");
        describeLength(v, "height", height, "Height", "Along Y.");
        describeLength(v, "depth", depth, "Depth", "Along Z.");
        v.integer("segments", segments, {.title = "Segments", .help = "Quads along each edge.", .min = 1, .max = 2048, .softMin = 1, .softMax = 128});
    }
};

struct Grid {
    double width = 2, depth = 2;
    int64_t columns = 10, rows = 10;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "width", width, "Width", "Along X.");
        describeLength(v, "depth", depth, "Depth", "Along Z.");
        v.integer("columns", columns, {.title = "Columns", .help = "Quads along X.", .min = 1, .max = 2048, .softMin = 1, .softMax = 128});
        v.integer("rows", rows, {.title = "Rows", .help = "Quads along Z.", .min = 1, .max = 2048, .softMin = 1, .softMax = 128});
    }
};

struct UvSphere {
    double radius = 1;
    int64_t segments = 32, rings = 16;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "radius", radius, "Radius", "Distance of all vertices from the origin.");
        v.integer("segments", segments, {.title = "Segments", .help = "Faces round the axis.", .min = 3, .max = 2048, .softMin = 3, .softMax = 128});
        v.integer("rings", rings, {.title = "Rings", .help = "Faces from pole to pole.", .min = 2, .max = 2048, .softMin = 2, .softMax = 128});
    }
};

enum class Caps { Fan, Polygon, Open };

struct Cylinder {
    double radius = 0.5, height = 1;
    int64_t segments = 32, rings = 1;
    Caps caps = Caps::Polygon;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "radius", radius, "Radius", "Of the vertices round the axis.");
        describeLength(v, "height", height, "Height", "Along Y.");
        v.integer("segments", segments, {.title = "Segments", .help = "Faces round the axis.", .min = 3, .max = 2048, .softMin = 3, .softMax = 128});
        v.integer("rings", rings, {.title = "Rings", .help = "Faces along the axis.", .min = 1, .max = 2048, .softMin = 1, .softMax = 128});
        v.choice("caps", caps, {"fan", "polygon", "open"}, {.title = "Caps", .help = "Ends of triangles, of one polygon each, or none."});
    }
};

struct Cone {
    double radius = 0.5, height = 1;
    int64_t segments = 32, rings = 1;
    Caps caps = Caps::Polygon;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "radius", radius, "Radius", "Of the base.");
        describeLength(v, "height", height, "Height", "From the base to the tip.");
        v.integer("segments", segments, {.title = "Segments", .help = "Faces round the axis.", .min = 3, .max = 2048, .softMin = 3, .softMax = 128});
        v.integer("rings", rings, {.title = "Rings", .help = "Faces from the base to the tip.", .min = 1, .max = 2048, .softMin = 1, .softMax = 128});
        v.choice("caps", caps, {"fan", "polygon", "open"}, {.title = "Base", .help = "Of triangles, of one polygon, or none."});
    }
};

struct Torus {
    double radius = 1, tube = 0.35;
    int64_t segments = 48, sides = 16;
    template <class V>
    void describe(V& v)
    {
        describeLength(v, "radius", radius, "Radius", "From the axis to the middle of the tube.");
        describeLength(v, "tube", tube, "Tube", "Radius of the tube itself.");
        v.integer("segments", segments, {.title = "Segments", .help = "Faces round the axis.", .min = 3, .max = 2048, .softMin = 3, .softMax = 128});
        v.integer("sides", sides, {.title = "Sides", .help = "Faces round the tube.", .min = 3, .max = 2048, .softMin = 3, .softMax = 128});
    }
};

/// 6 n^2 quads, 6 n^2 + 2 vertices; each side has the unit square of texture coordinates.
Generator box(Box parameters, Stage<Mesh>& stage);
/// Flat at y = 0, facing up: an open sheet, columns * rows quads.
Generator grid(Grid parameters, Stage<Mesh>& stage);
/// Quads, triangles at the poles: segments * (rings - 1) + 2 vertices.
Generator uvSphere(UvSphere parameters, Stage<Mesh>& stage);
Generator cylinder(Cylinder parameters, Stage<Mesh>& stage);
Generator cone(Cone parameters, Stage<Mesh>& stage);
/// segments * sides quads and as many vertices. Throws Error when the tube is thicker than the ring.
Generator torus(Torus parameters, Stage<Mesh>& stage);

}  // namespace mw
