// Modifier: vertices at the same place become one.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Weld {
    double distance = 0;
    bool dropDegenerate = false, dropUnreferenced = false;
    template <class V>
    void describe(V& v)
    {
        v.number("distance", distance,
                 {.title = "Distance",
                  .help = "Vertices no further apart than this become one; 0: only those at exactly the same place.",
                  .unit = "m",
                  .min = 0,
                  .softMax = 0.01});
        v.flag("drop-degenerate", dropDegenerate,
               {.title = "Tidy faces", .help = "Remove repeated corners from faces, and faces of which fewer than three corners are left."});
        v.flag("drop-unreferenced", dropUnreferenced, {.title = "Drop loose vertices", .help = "Remove vertices that no face and no line uses."});
    }
};

/// Goes through the vertices in order: each joins the lowest vertex kept so far that is within `distance`, else it is kept. So the result does not
/// depend on chains of near vertices, and no vertex moves. -0 equals 0. Near-linear time.
/// Faces stay as they are, with the vertices that were kept; a face that has lost its area is kept as well, unless it is to be tidied.
/// A vertex kept has its own attributes. Normals, texture coordinates, tangents and colours that differ among vertices made one move to the
/// corners, so that seams and hard edges survive.
Generator weld(Mesh input, Weld parameters, Stage<Mesh>& stage);

}  // namespace mw
