// Meshes as drawings of the plane and close-ups of their elements: what several figures want.
#pragma once
#include "app/figures/figure.h"

namespace mw::figures {

/// All edges of a mesh in the plane z = 0.
void drawEdges(Drawing& d, const Mesh& mesh, const Pen& pen);
void fillFace(Drawing& d, const Mesh& mesh, uint32_t face, glm::vec4 fill, double shrunk = 0);
At placeOf(const Mesh& mesh, uint32_t vertex);
At centreOf(const Mesh& mesh, uint32_t face);
At middleOf(const Mesh& mesh, uint32_t a, uint32_t b);
/// From `a` to `b`, moved towards `inside` by a share and shortened at both ends: how half-edges are drawn.
std::pair<At, At> inset(At a, At b, At inside, double share = 0.12, double ends = 0.12);
/// Looks at a place of a mesh straight from outside, with so much to be seen above and below it.
void closeUp(Space& s, glm::dvec3 place, glm::dvec3 normal, double reach, double turn = 0);
/// The edge of a mesh whose middle is nearest to a place; lower vertex first.
std::pair<uint32_t, uint32_t> nearestEdge(const Mesh& mesh, glm::dvec3 place);
uint32_t nearestFace(const Mesh& mesh, glm::dvec3 place);
std::string joined(std::span<const uint32_t> indices, const char* between = " ");

}  // namespace mw::figures
