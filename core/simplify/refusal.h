// Why an edge may not be collapsed.
#pragma once
#include <cstdint>

namespace mw {

/// The order is that of the lesson's words.
enum class Refusal : uint8_t { None, Link, Turn, Fold, Feature, Locked, Valence, Error };

}  // namespace mw
