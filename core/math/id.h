// Stable names of things in a scene.
#pragma once
#include <compare>
#include <cstdint>

namespace mw {

/// Never used again for another thing of the same scene.
template <class Tag>
struct Id {
    uint32_t value = 0;  ///< 0: none
    explicit operator bool() const { return value != 0; }
    auto operator<=>(const Id&) const = default;
};
using NodeId = Id<struct NodeTag>;

}  // namespace mw
