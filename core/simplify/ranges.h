// Loops over many elements in pieces, on as many threads as there are. What is done for an element must not depend on the pieces.
#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mw {

template <class F>
void inPieces(size_t n, const F& f, size_t grain = 16384)
{
    tbb::parallel_for(tbb::blocked_range<size_t>(0, n, grain), [&](const tbb::blocked_range<size_t>& r) { f(r.begin(), r.end()); });
}

}  // namespace mw
