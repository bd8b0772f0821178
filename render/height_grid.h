// How a height map is shown where there is no terrain: a grid of quads on a square of side 1, heights scaled to be read.
#pragma once
#include "core/mesh/mesh.h"
#include "core/terrain/height_map.h"

namespace mw {

class HeightGrid {
public:
    explicit HeightGrid(const HeightMap& map);

    /// Samples a quad spans; 1: vertices and faces of the mesh are samples and cells.
    uint32_t stride() const { return stride_; }
    glm::dvec3 place(double column, double height, double row) const;
    glm::dvec3 sample(uint32_t index) const;
    Mesh mesh() const;

private:
    const HeightMap& map_;
    uint32_t stride_;
    double spacing_, scale_;
};

}  // namespace mw
