// What terrains keep on the graphics card: heights by tile, so that a stroke sends only what it touched, and the structure of the ground.
#pragma once
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "core/terrain/height_map.h"
#include "render/gl.h"

namespace mw {

/// One map as a texture of floats with coarser levels. A map larger than the card's textures is taken at every second sample, or fourth.
class HeightTexture {
public:
    /// Makes the texture show the map; returns the bytes sent. Leaves it bound to the unit that is active.
    size_t show(const HeightMap& map);
    GLuint id() { return texture_.id(); }
    glm::ivec2 size() const { return size_; }
    int stride() const { return stride_; }
    uint64_t lastUse = 0;

private:
    void allocate(const HeightMap& map);
    size_t sendTile(const HeightMap& map, uint32_t tx, uint32_t ty);

    gl::Texture texture_;
    HeightMap shown_;  // kept: a tile's address says whether it has changed
    glm::ivec2 size_{0};
    int stride_ = 1, levels_ = 1;
};

class TerrainTextures {
public:
    void beginFrame();  ///< lets go of what was not drawn for long
    HeightTexture& heights(uint32_t node, const HeightMap& map);
    /// Fine structure of grass, rock, sand and snow in four channels; the same for all terrains. It tiles.
    GLuint layers();
    size_t uploadedBytes() const { return uploaded_; }  ///< since beginFrame()

private:
    std::map<uint32_t, HeightTexture> heights_;
    gl::Texture layers_;
    uint64_t frame_ = 0;
    size_t uploaded_ = 0;
};

}  // namespace mw
