// A grid of heights in shared tiles: an edit copies the tiles it touches, and only those go to the graphics card again.
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/array.h"

namespace mw {

/// Cheap to copy. Heights are nominally 0 to 1 (black to white of a picture), but may be anything finite. Sample (0, 0) is the corner of
/// least x and least z of a terrain; x runs along a row.
class HeightMap {
public:
    static constexpr uint32_t tileSize = 128, largestSize = 16385;

    HeightMap() = default;
    /// Preconditions: 2 <= width, height <= largestSize; as many heights as samples, row by row.
    HeightMap(uint32_t width, uint32_t height, std::span<const float> rows);
    static HeightMap flat(uint32_t width, uint32_t height, float value = 0);

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    bool empty() const { return width_ == 0; }
    uint32_t tilesX() const { return (width_ + tileSize - 1) / tileSize; }
    uint32_t tilesY() const { return (height_ + tileSize - 1) / tileSize; }
    /// tileSize * tileSize floats, row by row; what lies beyond the map is 0.
    const Shared<float>& tile(uint32_t tx, uint32_t ty) const { return tiles_[ty * tilesX() + tx]; }
    HeightMap withTile(uint32_t tx, uint32_t ty, Array<float> heights) const;
    void setTile(uint32_t tx, uint32_t ty, Array<float> heights);  ///< for edits of many tiles: the other tiles stay shared with copies
    /// Least and greatest height of a tile's samples; known, not searched.
    std::pair<float, float> range(uint32_t tx, uint32_t ty) const { return ranges_[ty * tilesX() + tx]; }

    float at(uint32_t x, uint32_t y) const { return tile(x / tileSize, y / tileSize)[(y % tileSize) * tileSize + x % tileSize]; }
    /// Bilinear between samples; u, v in 0..1 from the first to the last sample, clamped.
    double sample(double u, double v) const;
    Array<float> rows() const;
    std::pair<float, float> range() const;  ///< of all
    size_t bytes() const;                   ///< of all tiles

private:
    uint32_t width_ = 0, height_ = 0;
    std::vector<Shared<float>> tiles_;
    std::vector<std::pair<float, float>> ranges_;
};
size_t byteSize(const HeightMap& m);
uint64_t contentHash(const HeightMap& m);

}  // namespace mw
