// Sets of vertices, edges or faces of one mesh: combined, grown, walked along, converted, and written as text. Pure functions on the mesh as
// indexed, near-linear; none of them needs a manifold.
#pragma once
#include <string>
#include <string_view>

#include "core/mesh/table.h"

namespace mw {

/// Compact text of a set, without commas or plus signs: "0-99;105;200-210"; edges as "3~7;3~9", the lower vertex first. Empty for an empty set.
std::string elementText(const ElementSet& set);
/// The inverse, in any order and with repetitions. Every index must be below `below`: pass the mesh's count, so that hostile text cannot fill the
/// memory. `kind` is Vertex, Edge or Face. Throws Error naming the part that does not fit.
ElementSet parsedElements(ElementKind kind, std::string_view text, size_t below = 50'000'000);

}  // namespace mw
