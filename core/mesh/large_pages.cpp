#include "core/mesh/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mw {

void preferLargePages([[maybe_unused]] void* data, [[maybe_unused]] size_t bytes)
{
#ifdef __linux__
    constexpr uintptr_t small = 4096, large = uintptr_t(2) << 20;
    const uintptr_t first = (uintptr_t(data) + small - 1) & ~(small - 1), end = (uintptr_t(data) + bytes) & ~(small - 1);
    if (end > first && end - first >= 2 * large) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace mw
