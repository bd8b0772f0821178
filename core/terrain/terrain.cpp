#include "core/terrain/terrain.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/math/hash.h"
#include "core/terrain/ray.h"

namespace mw {

glm::dvec2 Terrain::size() const
{
    if (map.empty()) return {extent, extent};
    return {extent, extent * double(map.height() - 1) / double(map.width() - 1)};
}

double Terrain::heightAt(double x, double z) const
{
    return map.empty() ? 0 : maximumHeight * map.sample(x / extent + 0.5, z / size().y + 0.5);
}

glm::dvec3 Terrain::normalAt(double x, double z) const
{
    if (map.empty()) return {0, 1, 0};
    const glm::dvec2 half = 0.5 * size();
    const double spacing = extent / (map.width() - 1);
    const double x0 = std::clamp(x - spacing, -half.x, half.x - spacing), x1 = std::clamp(x + spacing, spacing - half.x, half.x);
    const double z0 = std::clamp(z - spacing, -half.y, half.y - spacing), z1 = std::clamp(z + spacing, spacing - half.y, half.y);
    const glm::dvec3 p1(x0, heightAt(x0, z0), z0), p2(x1, heightAt(x1, z0), z0), p3(x0, heightAt(x0, z1), z1), p4(x1, heightAt(x1, z1), z1);
    return glm::normalize(glm::cross(p3 - p2, p4 - p1));
}

std::optional<glm::dvec3> Terrain::meet(glm::dvec3 origin, glm::dvec3 direction) const
{
    if (map.empty()) return std::nullopt;
    const double perMetre = (map.width() - 1) / extent;
    const glm::dvec3 scale(perMetre, 1, perMetre), shift(0.5 * (map.width() - 1), 0, 0.5 * (map.height() - 1));
    const std::optional<double> t = meetGrid(map, maximumHeight, origin * scale + shift, direction * scale);
    if (!t) return std::nullopt;
    return origin + *t * direction;
}

Bounds boundsOf(const Terrain& t)
{
    Bounds b;
    if (t.map.empty()) return b;
    const glm::dvec2 half = 0.5 * t.size();
    const auto [least, most] = t.map.range();
    b.add({-half.x, t.maximumHeight * double(least), -half.y});
    b.add({half.x, t.maximumHeight * double(most), half.y});
    return b;
}

uint64_t contentHash(const Terrain& t)
{
    Hasher h;
    h.text(t.name);
    h.number(contentHash(t.map));
    h.bytes(&t.extent, sizeof t.extent);
    h.bytes(&t.maximumHeight, sizeof t.maximumHeight);
    h.bytes(&t.waterLevel, sizeof t.waterLevel);
    const Terrain::Detail& d = t.detail;
    const double detail[] = {double(d.patches), d.nearLevel, d.farLevel, d.nearDistance, d.farDistance, double(d.corrected)};
    h.array(std::span<const double>(detail));
    const double layers[] = {t.layers.sandTo, t.layers.grassTo, t.layers.snowFrom, t.layers.rockSlope};
    h.array(std::span<const double>(layers));
    return h.value();
}

}  // namespace mw
