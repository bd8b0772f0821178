// Listing 2.1: the ring of a vertex walked on the face-based structure, from triangle to neighbouring triangle. Book 2.5.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct OneRingWalk {
    int64_t vertex = 0, face = -1;
    template <class V>
    void describe(V& v)
    {
        v.integer("vertex", vertex, {.title = "Vertex", .help = "Whose ring is walked: its index.", .min = 0, .max = 4e9, .softMax = 1000});
        v.integer(
            "face", face,
            {.title = "First triangle", .help = "One that has the vertex; -1: the one of lowest index.", .min = -1, .max = 4e9, .softMax = 1000});
    }
};

/// The vertices around one vertex: those of the fan of triangles that the first one belongs to. A vertex inside with k neighbours takes k
/// triangles and refuses k neighbours (each triangle has one that lacks the vertex); at a boundary the walk starts again from the first triangle
/// the other way round. Throws Error when a face is not a triangle, there is no such vertex, or the triangle does not have it.
Generator oneRingWalk(Mesh input, OneRingWalk parameters, Stage<ElementSet>& stage);

}  // namespace mw
