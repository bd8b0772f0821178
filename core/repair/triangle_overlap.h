// Do two triangles meet? Exactly, touching included.
#pragma once
#include <glm/vec3.hpp>

namespace mw {

/// Three corners, not on one line.
struct Corners {
    glm::vec3 at[3];
};

/// No area, exactly.
bool onOneLine(const Corners& t);
/// Closed triangles without a common corner: whether they have a point in common.
bool meet(const Corners& s, const Corners& t);
/// s.at[i] is t.at[j]: whether they have more in common than that corner.
bool meetBeyondCorner(const Corners& s, int i, const Corners& t, int j);
/// Both have the side a, b, and c and d for third corners: whether they lie on each other.
bool meetBeyondSide(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

}  // namespace mw
