// Morphs by the overlay of two maps. Book 3.4.3, 3.4.4.
#pragma once
#include "core/morph/morph.h"

namespace mw {

/// Methods projective, spherical and barycentric.
Generator overlayMorph(Mesh input, Morph parameters, Stage<Mesh>& stage);
/// Method corresponding: both have the same faces.
Generator correspondingMorph(Mesh input, Morph parameters, Stage<Mesh>& stage);

}  // namespace mw
