// Triangle strips: each index after the first two adds a triangle. Book 2.1.
#pragma once
#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

inline constexpr uint32_t restartIndex = 0xFFFFFFFF;

struct Stripify {
    enum class Start { FewestNeighbours, InOrder };
    Start start = Start::FewestNeighbours;
    template <class V>
    void describe(V& v)
    {
        v.choice(
            "start", start, {"fewest-neighbours", "in-order"},
            {.title = "Start at",
             .help = "The triangle a strip starts from: the one with fewest free neighbours, which would be left over later, or simply the next."});
    }
};

/// Strips of all triangles (polygons are cut first), each in one of them. From its start a strip is tried in three directions, to both sides,
/// and the longest is taken. Any soup is accepted: where more than two faces meet, sides that run opposite ways are paired in order; faces that
/// repeat a vertex are strips of their own. Near-linear time.
/// Gives a row a face: column "strip" (of a polygon its first triangle's; NaN for faces of fewer than three corners), the list "indices" (all
/// strips one after the other, with restartIndex between), and in the summary the number of strips, of indices in strips and in a triangle list,
/// and the share saved in per cent.
Generator stripify(Mesh input, Stripify parameters, Stage<Table>& stage);

/// The triangles of strips: (s_i, s_i+1, s_i+2), the first two swapped when i is odd; i starts anew after a restart index.
Array<uint32_t> decodeStrips(std::span<const uint32_t> indices, uint32_t restart = restartIndex);

}  // namespace mw
