// Bones of a scene's joints: where they are, how they are coloured, which joint a pixel means.
#pragma once
#include <map>

#include "render/renderer.h"

namespace mw {

/// Of all visible joints. A bone leads from a joint to each of its next joints or end sites; one that has none gets a short stub.
void addBones(Frame& frame, const Scene& scene, const std::map<NodeId, glm::dmat4>& worlds);

/// The colour of every joint (sRGB): the first of 24 that is at least 25 (CIEDE2000) from those of parent, grandparent and siblings.
std::map<NodeId, glm::vec3> boneColors(const Scene& scene);

/// How different two colours look (CIEDE2000, CIE 142-2001); sRGB.
double colorDifference(glm::vec3 a, glm::vec3 b);

/// The joint nearest to a pixel within reach, seen or hidden; else the one whose bone is there. None: nothing near.
NodeId jointAt(const Frame& frame, glm::ivec2 size, glm::dvec2 pixel);

}  // namespace mw
