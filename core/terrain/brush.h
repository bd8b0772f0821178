// Strokes on a height map.
#pragma once
#include <glm/vec2.hpp>
#include <span>

#include "core/terrain/terrain.h"

namespace mw {

struct Brush {
    enum class Kind { Raise, Lower } kind = Kind::Raise;
    double radius = 85;      ///< metres
    double strength = 0.45;  ///< 0 to 1; at 1 one dab moves the middle by a fiftieth of the maximum height
    double spacing = 0.2;    ///< between dabs, share of the radius
    enum class Falloff { Smooth, Linear, Sphere, Constant } falloff = Falloff::Smooth;
};
/// Share of the strength at a distance from the middle, 0 to 1 of the radius.
double falloffAt(Brush::Falloff f, double distance);

/// Dabs along a polyline of places (local x, z, metres). `carry` is the way since the last dab; begin with a negative number: the first
/// place gets a dab. A stroke in pieces, each beginning at the last place of the piece before, gives to the bit what it gives in one go.
/// Tiles that no dab reaches are shared.
HeightMap stroked(const Terrain& t, const Brush& brush, std::span<const glm::dvec2> places, double& carry);

}  // namespace mw
