// Base64 of data: URIs.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace mw {

/// Empty when a character is none of the alphabet or the length is impossible. Padding may be missing.
std::optional<std::vector<uint8_t>> decodedBase64(std::string_view text);

}  // namespace mw
