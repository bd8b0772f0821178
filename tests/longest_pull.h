// How long a run keeps its caller waiting between two steps, when progress is shown and cancels are heard.
#pragma once
#include <algorithm>
#include <time.h>

#include "core/steps/generator.h"

namespace mw::test {

struct Pulls {
    double longest = 0, all = 0;  ///< CPU seconds of this thread, which other work on the machine hardly changes
    size_t count = 0;
    /// Of all the work, so that the speed of the machine does not count.
    double share() const { return longest / all; }
};

/// Runs to the end.
inline Pulls pulled(Generator run)
{
    const auto now = [] {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    };
    Pulls out;
    for (bool more = true; more; ++out.count) {
        const double begin = now();
        more = run.next();
        const double seconds = now() - begin;
        out.longest = std::max(out.longest, seconds);
        out.all += seconds;
    }
    return out;
}

}  // namespace mw::test
