// Two meshes on one domain, each in its own way, ready to be overlaid.
#pragma once
#include <glm/mat3x3.hpp>

#include "core/morph/morph.h"
#include "core/morph/morph_mesh.h"

namespace mw {

/// The meshes as overlaid (borders may have got further vertices) with their maps.
struct MorphMaps {
    MorphMesh meshes[2];
    OverlayInput maps[2];
    glm::dvec3 centres[2]{};  ///< projective: from which each is seen
    double turn = 0;          ///< degrees by which the second map was turned
};

/// A mesh on the sphere. `step`: coordinates are rounded to multiples of it, so that places that differ by noise only are one.
OverlayInput onSphere(const MorphMesh& mesh, std::span<const glm::dvec3> directions, int64_t step = 1);
/// Throws Error unless the sphere is covered once.
void requireCovering(const OverlayInput& input, const char* which);

/// Central projection of both. Throws Error when no point sees all of a mesh.
MorphMaps projectiveMaps(const Mesh& first, const Mesh& second);
Generator projectiveMaps(Mesh first, Mesh second, MorphMaps& out);
/// Spread over the sphere, the second turned so that matching points are near. In parts; `out` is set at the end.
Generator sphericalMaps(Mesh first, Mesh second, bool align, MorphMaps& out);
/// In the unit disk with one border for both: each border gets the vertices of the other at the same share of its length.
MorphMaps diskMaps(const Mesh& first, const Mesh& second, bool align);
Generator diskMaps(Mesh first, Mesh second, bool align, MorphMaps& out);

/// A rotation of unit directions of the second mesh that brings its places (moved to a common middle and size) nearest to those of the first. In
/// parts; `turn` is set at the end.
Generator aligningRotation(std::span<const glm::dvec3> firstDirections, std::span<const glm::dvec3> firstPlaces,
                           std::span<const glm::dvec3> secondDirections, std::span<const glm::dvec3> secondPlaces, glm::dmat3& turn);

}  // namespace mw
