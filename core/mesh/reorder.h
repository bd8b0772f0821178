// The order of vertices and faces: how far it is from that of the surface, and a mesh put in order. Work on a large mesh in random order takes two
// to eight times as long, because neighbours lie nowhere near each other in memory.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

/// How many lines of memory (16 vertices each) are touched for a face, in runs of 1024 successive faces; the mean over a sample. About 0.1 in a mesh
/// that was made or scanned row by row, 0.6 where vertices are shuffled, up to 3 where faces are, too. 0 for meshes too small to matter.
double scatterOf(const Mesh& mesh);
inline constexpr double mostScatterInOrder = 0.3;  ///< beyond it putting in order pays

struct Reorder {
    enum class Method { Automatic, FirstUse, BreadthFirst };
    Method method = Method::Automatic;

    template <class V>
    void describe(V& v)
    {
        v.choice(
            "method", method, {"automatic", "first-use", "breadth-first"},
            {.title = "Method",
             .help = "first-use: vertices as the faces name them, faces stay. breadth-first: from neighbour to neighbour over the surface, faces by "
                     "their lowest vertex. automatic: what the present order needs; a mesh in good order stays as it is."});
    }
};

/// The same mesh with other numbers: all attributes, groups and lines come along, corners keep their order within a face. Vertices that no face
/// uses come last. Deterministic.
Generator reorder(Mesh input, Reorder parameters, Stage<Mesh>& stage);

}  // namespace mw
