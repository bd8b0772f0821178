// Tessellation levels of a terrain's patches by distance (5.1): one whole number an edge, shared by the patches on both its sides.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/terrain/terrain.h"

namespace mw {

/// (5.1), between the far and the near level.
double tessellationLevel(const Terrain::Detail& detail, double distance);

struct TerrainLevels {
    int columns = 0, rows = 0;     ///< patches along x and z
    std::vector<int> inner;        ///< of patches, row by row
    std::vector<int> outer;        ///< four a patch in OpenGL's order: least x, least z, greatest x, greatest z
    std::vector<double> distance;  ///< from the eye to each patch's centre, metres

    size_t patch(int column, int row) const { return size_t(row) * size_t(columns) + size_t(column); }
    size_t triangles(size_t patch) const;  ///< of one patch, as the tessellator makes them with equal spacing
    size_t triangles() const;
};

/// Patches along x and z: nearly square ones.
glm::ivec2 patchesOf(const Terrain& t);
TerrainLevels levelsOf(const Terrain& t, const glm::dmat4& worldFromLocal, glm::dvec3 eye);

}  // namespace mw
