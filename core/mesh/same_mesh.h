// Whether two meshes are the same arrays: what is kept of one serves the other.
#pragma once
#include <algorithm>

#include "core/mesh/mesh.h"

namespace mw {

/// Places and faces are the same arrays, not only equal numbers; attributes may differ. O(1).
inline bool sameMesh(const Mesh& a, const Mesh& b)
{
    return a.positions().id() == b.positions().id() && a.cornerVertex().id() == b.cornerVertex().id() && a.faceStart().id() == b.faceStart().id();
}

/// What they carry is the same arrays.
inline bool sameAttributes(const Mesh& a, const Mesh& b)
{
    const auto same = [](const Attribute& x, const Attribute& y) { return x.id() == y.id(); };
    return std::equal(a.attributes().begin(), a.attributes().end(), b.attributes().begin(), b.attributes().end(), same);
}

}  // namespace mw
