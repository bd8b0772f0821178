// Sets as masks, one byte an element: what the selection functions share.
#pragma once
#include <cstdint>
#include <vector>

namespace mw::select {

using Mask = std::vector<uint8_t>;

inline std::vector<uint32_t> ticked(const Mask& mask)
{
    size_t n = 0;
    for (const uint8_t m : mask) n += m != 0;
    std::vector<uint32_t> out;
    out.reserve(n);
    for (uint32_t i = 0; i < mask.size(); ++i)
        if (mask[i]) out.push_back(i);
    return out;
}

}  // namespace mw::select
