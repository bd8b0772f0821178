// A mesh as a disk with inner vertices and one border, and convex outlines to pin the border to. Book 3.3.2.
#pragma once
#include <glm/vec2.hpp>

#include "core/mesh/mesh.h"

namespace mw {

struct Disk {
    Mesh triangles;                ///< the mesh with polygons cut; vertices as they were
    std::vector<uint32_t> border;  ///< once round with the mesh on the left, from its lowest vertex
    Array<uint32_t> inner;         ///< vertices of faces that are not on the border, ascending
    Array<uint32_t> unknown;       ///< of each vertex: its place in `inner`, else none
};

/// Throws Error that names what keeps the mesh from being one and what to do about it.
Disk diskOf(const Mesh& mesh);

enum class PlanarOutline { Circle, Square, Chord };

/// Where the vertices of Disk::border go, anticlockwise. Circle: radius 1, equal steps from (1, 0). Chord: the same, steps in the ratio of
/// the lengths of the edges. Square: from -1 to 1, along the sides in that ratio, corners at vertices where the mesh has corners, too, as far as
/// they are about a quarter of the way apart; no side gets an inner edge with both ends on it when that can be helped.
std::vector<glm::dvec2> outlinePlaces(const Disk& disk, PlanarOutline outline);

}  // namespace mw
