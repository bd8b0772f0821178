// The quick qualities of decimate-quadric: the quadrics of the textbook, other tables and another order. About a hundred times as fast as a plain
// heap over half-edges, and closer to the surface: nothing is remembered (Hoppe 1999), the volume is kept (Lindstrom and Turk 1998), and collapses
// are spread more evenly than by strict greed.
//
//   fast      in blocks that fit into the cache, where there is more than one, up to a cost that leaves two to four times the faces; then as balanced
//   balanced  one queue of buckets, the cheapest first
//   best      balanced, then the vertices are fitted to the old surface (quick_fit.h)
//
// A large mesh is cut into regions by its own order, which are worked on at the same time; what would touch two of them waits for the end. The result
// is the same with any number of threads and on any machine. Memory about 120 bytes a triangle.
#pragma once
#include "core/simplify/decimate_quadric.h"

namespace mw {

Generator decimateQuick(Mesh input, DecimateQuadric parameters, Stage<Mesh>& stage);

}  // namespace mw
