// Around each vertex: its faces' corners and its neighbours, as flat tables.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// corners of vertex v: corner[start[v]] .. corner[start[v+1]-1], ascending. Neighbours likewise, each once, ascending (edges of faces only).
struct Rings {
    Array<uint32_t> start, corner;
    Array<uint32_t> neighbourStart, neighbour;
    Array<uint8_t> sides;  ///< beside `neighbour`: how many sides of faces run along the edge there, 255 for more

    std::span<const uint32_t> cornersOf(uint32_t v) const { return {corner.data() + start[v], start[v + 1] - start[v]}; }
    std::span<const uint32_t> neighboursOf(uint32_t v) const
    {
        return {neighbour.data() + neighbourStart[v], neighbourStart[v + 1] - neighbourStart[v]};
    }
    std::span<const uint8_t> sidesAt(uint32_t v) const { return {sides.data() + neighbourStart[v], neighbourStart[v + 1] - neighbourStart[v]}; }
};

}  // namespace mw
