// Levels of detail, worked out on the processor: what the panel shows and what the card draws is one number.
#include "render/terrain_levels.h"

#include <algorithm>
#include <cmath>

namespace mw {
namespace {

constexpr int highestLevel = 64;  // what every OpenGL 4 can do

int whole(double level)
{
    return int(std::ceil(std::clamp(level, 1.0, double(highestLevel))));
}

/// Distances from the eye to points of the ground given in patches from the corner.
class Distances {
public:
    Distances(const Terrain& t, const glm::dmat4& worldFromLocal, glm::dvec3 eye, glm::ivec2 patches)
        : terrain_(t), world_(worldFromLocal), eye_(eye), patches_(patches), size_(t.size())
    {}
    double operator()(double column, double row) const
    {
        const glm::dvec2 share = glm::dvec2(column, row) / glm::dvec2(patches_);
        const double height = std::max(terrain_.maximumHeight * terrain_.map.sample(share.x, share.y), terrain_.waterLevel);
        return glm::distance(eye_, glm::dvec3(world_ * glm::dvec4((share.x - 0.5) * size_.x, height, (share.y - 0.5) * size_.y, 1)));
    }

private:
    const Terrain& terrain_;
    const glm::dmat4& world_;
    glm::dvec3 eye_;
    glm::ivec2 patches_;
    glm::dvec2 size_;
};

}  // namespace

double tessellationLevel(const Terrain::Detail& d, double distance)
{
    const double span = d.farDistance - d.nearDistance;
    const double share = span > 0 ? std::clamp((distance - d.nearDistance) / span, 0.0, 1.0) : distance > d.nearDistance ? 1.0 : 0.0;
    return d.nearLevel - share * (d.nearLevel - d.farLevel);
}

// An inner ring of squares, and four borders that join it to edges of other levels; a grid when all are alike.
size_t TerrainLevels::triangles(size_t p) const
{
    const size_t n = size_t(inner[p]);
    const int* o = &outer[4 * p];
    if (n == 1) return 2;
    size_t sum = 2 * (n - 2) * (n - 2);
    for (int k = 0; k < 4; ++k) sum += size_t(o[k]) + n - 2;
    return sum;
}

size_t TerrainLevels::triangles() const
{
    size_t sum = 0;
    for (size_t p = 0; p < inner.size(); ++p) sum += triangles(p);
    return sum;
}

glm::ivec2 patchesOf(const Terrain& t)
{
    const glm::dvec2 size = t.size();
    const int along = std::clamp(t.detail.patches, 1, 256);
    return {along, std::clamp(int(std::lround(along * size.y / size.x)), 1, 256)};
}

TerrainLevels levelsOf(const Terrain& t, const glm::dmat4& worldFromLocal, glm::dvec3 eye)
{
    TerrainLevels l;
    const glm::ivec2 patches = patchesOf(t);
    l.columns = patches.x;
    l.rows = patches.y;
    const size_t count = size_t(l.columns) * size_t(l.rows);
    l.inner.resize(count);
    l.outer.resize(4 * count);
    l.distance.resize(count);
    const Distances distance(t, worldFromLocal, eye, patches);
    const auto level = [&](double column, double row) { return whole(tessellationLevel(t.detail, distance(column, row))); };
    for (int row = 0; row < l.rows; ++row) {
        for (int column = 0; column < l.columns; ++column) {
            const size_t p = l.patch(column, row);
            int* outer = &l.outer[4 * p];
            l.distance[p] = distance(column + 0.5, row + 0.5);
            l.inner[p] = whole(tessellationLevel(t.detail, l.distance[p]));
            if (!t.detail.corrected) {
                std::fill_n(outer, 4, l.inner[p]);
                continue;
            }
            // Edge correction: the level of an edge comes from its own middle, worked out for one of its patches only.
            outer[0] = column > 0 ? l.outer[4 * l.patch(column - 1, row) + 2] : level(column, row + 0.5);
            outer[1] = row > 0 ? l.outer[4 * l.patch(column, row - 1) + 3] : level(column + 0.5, row);
            outer[2] = level(column + 1, row + 0.5);
            outer[3] = level(column + 0.5, row + 1);
            if (std::any_of(outer, outer + 4, [](int o) { return o > 1; })) l.inner[p] = std::max(l.inner[p], 2);
        }
    }
    return l;
}

}  // namespace mw
