// A height map standing in space, and what is asked of it: height, normal, where a ray meets it, a mesh of so many triangles.
#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/mesh/mesh.h"
#include "core/steps/progress.h"
#include "core/terrain/height_map.h"

namespace mw {

/// Local space: x from -extent/2 to extent/2 along the map's rows, z alike by the same spacing of samples, y = height * maximumHeight.
struct Terrain {
    std::string name;
    HeightMap map;
    double extent = 1000;        ///< metres along x
    double maximumHeight = 115;  ///< metres at height 1
    double waterLevel = 0;       ///< metres; below the lowest point: no water
    /// Level of detail (5.1): tessellation levels of patches by distance.
    struct Detail {
        int patches = 16;  ///< along x
        double nearLevel = 64, farLevel = 4, nearDistance = 80, farDistance = 900;
        bool corrected = true;  ///< edges take their level from their own midpoint; false shows the cracks
        bool operator==(const Detail&) const = default;
    } detail;
    /// Where textures begin, shares of maximumHeight, and the slope from which rock shows, degrees.
    struct Layers {
        double sandTo = 0.20, grassTo = 0.48, snowFrom = 0.55, rockSlope = 32;
        bool operator==(const Layers&) const = default;
    } layers;

    glm::dvec2 size() const;                    ///< x and z, metres
    double heightAt(double x, double z) const;  ///< bilinear, clamped at the border
    /// Unit, by (5.7): from four places a spacing of samples away along both axes, on the border at it.
    glm::dvec3 normalAt(double x, double z) const;
    /// First meeting of a ray with the surface; `direction` need not be unit. Local space.
    std::optional<glm::dvec3> meet(glm::dvec3 origin, glm::dvec3 direction) const;
};
Bounds boundsOf(const Terrain& t);
uint64_t contentHash(const Terrain& t);

/// At most so many triangles (at least the few that the border takes), the more where the surface bends; all cells when the budget allows.
/// An open sheet, anticlockwise from above, vertices at samples; where water stands, its surface. Vertices carry "normal" and "color" (the
/// layers), corners "texcoord": 0, 1 at the first sample, as the picture of the map.
Mesh terrainMesh(const Terrain& t, size_t triangleBudget, Progress* progress = nullptr);
/// Largest vertical distance of a sample, or the water over it, from such a mesh, metres.
double terrainMeshError(const Terrain& t, const Mesh& mesh);

}  // namespace mw
