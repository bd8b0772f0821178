// Dabs are laid along the way and added to copies of the tiles they reach, which replace the old ones at the end.
#include "core/terrain/brush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace mw {

namespace {

constexpr double dabsToFull = 50;  // at full strength, from height 0 to 1

/// Calls dab(place) along a polyline.
template <class Dab>
void alongWay(std::span<const glm::dvec2> places, double step, double& carry, const Dab& dab)
{
    if (places.empty()) return;
    if (carry < 0) {
        dab(places[0]);
        carry = 0;
    }
    for (size_t i = 1; i < places.size(); ++i) {
        const glm::dvec2 a = places[i - 1], b = places[i];
        const double length = glm::distance(a, b);
        double at = step - carry;
        for (; at <= length; at += step) dab(a + (b - a) * (at / length));
        carry = length - (at - step);
    }
}

/// A map being painted: tiles are copied when first reached.
class Canvas {
public:
    explicit Canvas(const HeightMap& map) : map_(map) {}

    /// The height at a sample and those right of it in the same tile.
    float* row(uint32_t x, uint32_t y)
    {
        const std::pair place(x / HeightMap::tileSize, y / HeightMap::tileSize);
        auto found = tiles_.find(place);
        if (found == tiles_.end()) {
            const Shared<float>& old = map_.tile(place.first, place.second);
            found = tiles_.emplace(place, Array<float>(old.begin(), old.end())).first;
        }
        return found->second.data() + size_t(y % HeightMap::tileSize) * HeightMap::tileSize + x % HeightMap::tileSize;
    }
    HeightMap result()
    {
        HeightMap out = map_;
        for (auto& [place, heights] : tiles_) out.setTile(place.first, place.second, std::move(heights));
        return out;
    }

private:
    const HeightMap& map_;
    std::map<std::pair<uint32_t, uint32_t>, Array<float>> tiles_;
};

/// Falloffs over the square of the distance, which is what a row of samples has at hand.
template <Brush::Falloff F>
double share(double squared)
{
    if constexpr (F == Brush::Falloff::Smooth) return 1 - squared * (3 - 2 * std::sqrt(squared));
    if constexpr (F == Brush::Falloff::Linear) return 1 - std::sqrt(squared);
    if constexpr (F == Brush::Falloff::Sphere) return std::sqrt(1 - squared);
    return 1;
}

/// Adds to n samples of a row the first of which is `x` from the middle, spacing 1 apart, all in radii; `z` is the row's own distance.
template <Brush::Falloff F>
void addRow(float* heights, size_t n, double x, double spacing, double z, double amount)
{
    for (size_t i = 0; i < n; ++i) {
        const double dx = x + double(i) * spacing;
        const double squared = std::min(1.0, dx * dx + z * z);
        heights[i] = float(double(heights[i]) + amount * share<F>(squared));
    }
}

/// A dab in samples.
struct Dab {
    glm::dvec2 middle;
    double radius, amount;
    Brush::Falloff falloff;

    void add(float* heights, size_t n, uint32_t x, double z) const
    {
        const double from = (x - middle.x) / radius, spacing = 1 / radius;
        switch (falloff) {
            case Brush::Falloff::Smooth:
                return addRow<Brush::Falloff::Smooth>(heights, n, from, spacing, z, amount);
            case Brush::Falloff::Linear:
                return addRow<Brush::Falloff::Linear>(heights, n, from, spacing, z, amount);
            case Brush::Falloff::Sphere:
                return addRow<Brush::Falloff::Sphere>(heights, n, from, spacing, z, amount);
            case Brush::Falloff::Constant:
                return addRow<Brush::Falloff::Constant>(heights, n, from, spacing, z, amount);
        }
    }
};

void paint(Canvas& canvas, const HeightMap& map, const Dab& dab)
{
    const auto inside = [](double at, uint32_t count) { return std::clamp(at, 0.0, double(count)); };
    const auto y0 = uint32_t(inside(std::ceil(dab.middle.y - dab.radius), map.height()));
    const auto y1 = uint32_t(inside(std::floor(dab.middle.y + dab.radius) + 1, map.height()));
    for (uint32_t y = y0; y < y1; ++y) {
        const double z = (y - dab.middle.y) / dab.radius, reach = dab.radius * std::sqrt(std::max(0.0, 1 - z * z));
        auto x = uint32_t(inside(std::ceil(dab.middle.x - reach), map.width()));
        const auto x1 = uint32_t(inside(std::floor(dab.middle.x + reach) + 1, map.width()));
        while (x < x1) {
            const uint32_t end = std::min(x1, (x / HeightMap::tileSize + 1) * HeightMap::tileSize);
            dab.add(canvas.row(x, y), end - x, x, z);
            x = end;
        }
    }
}

}  // namespace

double falloffAt(Brush::Falloff f, double distance)
{
    if (!(distance <= 1)) return 0;
    const double d = std::max(0.0, distance);
    switch (f) {
        case Brush::Falloff::Smooth:
            return share<Brush::Falloff::Smooth>(d * d);
        case Brush::Falloff::Linear:
            return share<Brush::Falloff::Linear>(d * d);
        case Brush::Falloff::Sphere:
            return share<Brush::Falloff::Sphere>(d * d);
        case Brush::Falloff::Constant:
            return 1;
    }
    return 0;
}

HeightMap stroked(const Terrain& t, const Brush& brush, std::span<const glm::dvec2> places, double& carry)
{
    if (t.map.empty() || !(brush.radius > 0)) return t.map;
    const double perMetre = (t.map.width() - 1) / t.extent;
    const double amount = (brush.kind == Brush::Kind::Raise ? 1 : -1) * brush.strength / dabsToFull;
    const glm::dvec2 middle = 0.5 * t.size();
    Canvas canvas(t.map);
    const auto dab = [&](glm::dvec2 place) { paint(canvas, t.map, {(place + middle) * perMetre, brush.radius * perMetre, amount, brush.falloff}); };
    alongWay(places, brush.radius * std::max(brush.spacing, 0.01), carry, dab);
    return canvas.result();
}

}  // namespace mw
