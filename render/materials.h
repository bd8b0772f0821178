// What a material changes in a draw: the block, the pictures, and the variant of the surface program.
#pragma once
#include <array>

#include "render/draw_context.h"

namespace mw {

/// The sets of texture coordinates that an object's pictures read, at most two; -1: none.
using TexcoordSets = std::array<int, 2>;
TexcoordSets pictureSets(const DrawObject& o);
/// Those that say where it is cut out.
TexcoordSets maskSets(const DrawObject& o);
bool hasNormalMap(const DrawObject& o);
/// Clay, and what looks like it, needs no more than the three lights on a colour.
bool isPlain(const Material& m);
const Material* materialOf(const DrawObject& o, uint32_t slot);

/// Numbers and pictures of a slot; `sets` are those the draw has, -1 for none. Returns the variant bits it needs.
unsigned applyMaterial(DrawContext& c, const DrawObject& o, uint32_t slot, const TexcoordSets& sets, ObjectBlock& b);
/// For shadows: the cut-out alone.
unsigned applyMask(DrawContext& c, const DrawObject& o, uint32_t slot, const TexcoordSets& sets, ObjectBlock& b);

}  // namespace mw
