// The outermost layer of a glTF: is it GLB or JSON, are its lengths true, is the JSON of a size and depth that may be parsed.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/error.h"

namespace mw {

struct GltfContainer {
    nlohmann::json root;
    std::span<const uint8_t> bin;  ///< of the content given
    bool binary = false, hasBin = false;
    size_t jsonCost = 0;  ///< bytes that the parsed JSON takes, roughly
    std::vector<Warning> warnings;
};

/// `content` must outlive the result. Throws Error.
GltfContainer gltfContainer(std::span<const uint8_t> content);

/// What reading `bytes` of files may take in memory: a small multiple of them.
inline uint64_t gltfBudget(uint64_t bytes)
{
    return 8 * bytes + (uint64_t(200) << 20);
}

/// The header and chunks of a GLB around `json` and `bin`. Throws Error beyond 4 GiB.
std::vector<uint8_t> glbContent(const std::string& json, std::span<const uint8_t> bin);

}  // namespace mw
