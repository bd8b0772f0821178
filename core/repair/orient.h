// Modifier: neighbouring faces turn the same way, closed pieces show their outside.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

struct Orient {
    enum class Outside { Outward, Majority, KeepFirst };

    Outside outside = Outside::Outward;
    bool cut = false;

    template <class V>
    void describe(V& v)
    {
        v.choice("outside", outside, {"outward", "majority", "keep-first"},
                 {.title = "Outside",
                  .help = "Outward: closed pieces by their signed volume, open ones as most of their faces. Majority: as most faces of a piece. "
                          "Keep first: as the first face of a piece."});
        v.flag("cut", cut,
               {.title = "Cut one-sided surfaces",
                .help = "A Moebius strip cannot be oriented: cut it open along the edges where it still disagrees. No face is lost."});
    }
};

/// Floods each piece over its edges of two faces and turns every face as its neighbour; then the piece as a whole is turned or not. Edges of
/// more faces separate pieces (see repair.h). Each piece is judged by itself, so a shell within another one ends up facing outward, too.
/// A surface of one side only cannot be oriented: the flood (breadth first from its lowest face) meets itself along one cut, whose edges stay
/// inconsistent, or are opened with `cut`. A face that is turned keeps its first corner; values of corners go with their corners, creases with
/// their edges; stored normals of turned faces are negated, the sign of tangents likewise. O(n).
Generator orient(Mesh input, Orient parameters, Stage<Mesh>& stage);

}  // namespace mw
