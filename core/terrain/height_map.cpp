#include "core/terrain/height_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/hash.h"

namespace mw {

namespace {

/// Of the part of a tile that is on the map: first column by column, which vectorises.
std::pair<float, float> rangeOf(std::span<const float> tile, uint32_t columns, uint32_t lines)
{
    std::array<float, HeightMap::tileSize> least, most;
    least.fill(tile[0]);
    most.fill(tile[0]);
    for (uint32_t y = 0; y < lines; ++y) {
        const float* row = tile.data() + size_t(y) * HeightMap::tileSize;
        for (uint32_t x = 0; x < columns; ++x) {
            least[x] = row[x] < least[x] ? row[x] : least[x];
            most[x] = row[x] > most[x] ? row[x] : most[x];
        }
    }
    return {*std::min_element(least.begin(), least.begin() + columns), *std::max_element(most.begin(), most.begin() + columns)};
}

}  // namespace

HeightMap::HeightMap(uint32_t width, uint32_t height, std::span<const float> rows) : width_(width), height_(height)
{
    for (uint32_t ty = 0; ty < tilesY(); ++ty)
        for (uint32_t tx = 0; tx < tilesX(); ++tx) {
            Array<float> tile(size_t(tileSize) * tileSize, 0.f);
            const uint32_t columns = std::min(tileSize, width - tx * tileSize), lines = std::min(tileSize, height - ty * tileSize);
            for (uint32_t y = 0; y < lines; ++y)
                std::copy_n(rows.data() + size_t(ty * tileSize + y) * width + tx * tileSize, columns, tile.data() + size_t(y) * tileSize);
            ranges_.push_back(rangeOf(tile, columns, lines));
            tiles_.push_back(std::move(tile));
        }
}

HeightMap HeightMap::flat(uint32_t width, uint32_t height, float value)
{
    HeightMap m;
    m.width_ = width;
    m.height_ = height;
    const Shared<float> tile(Array<float>(size_t(tileSize) * tileSize, value));
    m.tiles_.assign(size_t(m.tilesX()) * m.tilesY(), tile);
    m.ranges_.assign(m.tiles_.size(), {value, value});
    return m;
}

HeightMap HeightMap::withTile(uint32_t tx, uint32_t ty, Array<float> heights) const
{
    HeightMap m = *this;
    m.setTile(tx, ty, std::move(heights));
    return m;
}

void HeightMap::setTile(uint32_t tx, uint32_t ty, Array<float> heights)
{
    const size_t i = size_t(ty) * tilesX() + tx;
    ranges_[i] = rangeOf(heights, std::min(tileSize, width_ - tx * tileSize), std::min(tileSize, height_ - ty * tileSize));
    tiles_[i] = std::move(heights);
}

double HeightMap::sample(double u, double v) const
{
    const double x = std::clamp(u, 0.0, 1.0) * (width_ - 1), y = std::clamp(v, 0.0, 1.0) * (height_ - 1);
    const auto x0 = std::min(uint32_t(x), width_ - 2), y0 = std::min(uint32_t(y), height_ - 2);
    const double fx = x - x0, fy = y - y0;
    return (1 - fy) * ((1 - fx) * double(at(x0, y0)) + fx * double(at(x0 + 1, y0))) +
           fy * ((1 - fx) * double(at(x0, y0 + 1)) + fx * double(at(x0 + 1, y0 + 1)));
}

Array<float> HeightMap::rows() const
{
    Array<float> out(size_t(width_) * height_);
    for (uint32_t y = 0; y < height_; ++y)
        for (uint32_t tx = 0; tx < tilesX(); ++tx) {
            const float* from = tile(tx, y / tileSize).data() + size_t(y % tileSize) * tileSize;
            std::copy_n(from, std::min(tileSize, width_ - tx * tileSize), out.data() + size_t(y) * width_ + tx * tileSize);
        }
    return out;
}

std::pair<float, float> HeightMap::range() const
{
    if (ranges_.empty()) return {0.f, 0.f};
    std::pair<float, float> all = ranges_[0];
    for (const auto& [least, most] : ranges_) all = {std::min(all.first, least), std::max(all.second, most)};
    return all;
}

size_t HeightMap::bytes() const
{
    size_t n = 0;
    for (const Shared<float>& t : tiles_) n += t.bytes();
    return n;
}

size_t byteSize(const HeightMap& m)
{
    return sizeof m + m.bytes();
}

uint64_t contentHash(const HeightMap& m)
{
    Hasher h;
    h.number(m.width());
    h.number(m.height());
    h.array(std::span<const float>(m.rows()));  // not by tile: what lies beyond the map does not count
    return h.value();
}

}  // namespace mw
