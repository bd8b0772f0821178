#include "render/height_grid.h"

#include <algorithm>
#include <cmath>

namespace mw {
namespace {

constexpr uint32_t mostQuads = 256;   // along a side
constexpr double heightOfOne = 0.35;  // of the side of the square

/// Multiples of the stride, and the last one.
std::vector<uint32_t> picked(uint32_t count, uint32_t stride)
{
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i + 1 < count; i += stride) all.push_back(i);
    all.push_back(count - 1);
    return all;
}

}  // namespace

HeightGrid::HeightGrid(const HeightMap& map) : map_(map)
{
    const uint32_t longer = std::max({map.width(), map.height(), 2u}) - 1;
    stride_ = (longer + mostQuads - 1) / mostQuads;
    spacing_ = 1.0 / longer;
    const auto [low, high] = map.range();
    const double most = std::max(std::abs(double(low)), std::abs(double(high)));
    scale_ = heightOfOne / std::max(1.0, std::isfinite(most) ? most : 1.0);
}

glm::dvec3 HeightGrid::place(double column, double height, double row) const
{
    const double y = std::isfinite(height) ? height * scale_ : 0;
    return {(column - 0.5 * (map_.width() - 1)) * spacing_, y, (row - 0.5 * (map_.height() - 1)) * spacing_};
}

glm::dvec3 HeightGrid::sample(uint32_t index) const
{
    const uint32_t column = index % map_.width(), row = index / map_.width();
    return place(column, double(map_.at(column, row)), row);
}

Mesh HeightGrid::mesh() const
{
    if (map_.empty()) return {};
    const std::vector<uint32_t> columns = picked(map_.width(), stride_), rows = picked(map_.height(), stride_);
    Array<glm::vec3> positions;
    Array<uint32_t> start{0u}, corners;
    positions.reserve(columns.size() * rows.size());
    for (const uint32_t row : rows)
        for (const uint32_t column : columns) positions.emplace_back(sample(row * map_.width() + column));
    const auto across = uint32_t(columns.size());
    for (uint32_t y = 0; y + 1 < rows.size(); ++y)
        for (uint32_t x = 0; x + 1 < across; ++x) {
            const uint32_t a = y * across + x;
            corners.insert(corners.end(), {a, a + across, a + across + 1, a + 1});
            start.push_back(uint32_t(corners.size()));
        }
    return Mesh(std::move(positions), std::move(start), std::move(corners));
}

}  // namespace mw
