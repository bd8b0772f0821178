// Time of the processor, for tests that something is quick: a busy machine does not lengthen it.
#pragma once
#include <ctime>

namespace mw {

/// Milliseconds that the calling thread has had so far.
inline double threadMilliseconds()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
}

}  // namespace mw
