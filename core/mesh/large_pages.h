// Memory in large pages, where the system has them: fresh memory of many megabytes costs half as much when it does not come 4 KB at a time.
#pragma once
#include "core/mesh/array.h"

namespace mw {

/// Asks for large pages for memory that was not yet written to, if it is large. Never fails; changes no byte.
void preferLargePages(void* data, size_t bytes);

template <class T>
void preferLargePages(Array<T>& a)
{
    preferLargePages(a.data(), a.capacity() * sizeof(T));
}

/// Not filled. For large results.
template <class T>
Array<T> largeArray(size_t n)
{
    Array<T> a;
    a.reserve(n);
    preferLargePages(a);
    a.resize(n);
    return a;
}

}  // namespace mw
