// How long work that is not stepped says how far it is and hears that it should stop.
#pragma once
#include <atomic>

#include "core/error.h"

namespace mw {

/// Shared between a worker and whoever watches it. Both members may be used from any thread.
struct Progress {
    std::atomic<float> fraction{0};  ///< 0 to 1
    std::atomic<bool> cancelled{false};

    /// Worker: says how far it is; throws Cancelled when it should stop.
    void at(float f)
    {
        fraction.store(f, std::memory_order_relaxed);
        if (cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    }
};

}  // namespace mw
