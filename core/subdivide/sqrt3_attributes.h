// Attributes of corners and faces through rounds of sqrt(3) subdivision.
#pragma once
#include "core/subdivide/sqrt3_round.h"

namespace mw {

/// Of the mesh that `round` began with, onto its triangles: after a first round of a pair, or, with the round before, after the second. All
/// attributes of `first.mesh` but those of vertices.
std::vector<Attribute> sqrt3Attributes(const Sqrt3Round& first, const Sqrt3Round* second);

/// Edges across which something of corners or faces is different: 1 by edge.
std::vector<uint8_t> seamsOf(const Sqrt3Round& round);

}  // namespace mw
