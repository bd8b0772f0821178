#include "core/terrain/terrain.h"

#include "core/math/hash.h"

namespace mw {

glm::dvec2 Terrain::size() const
{
    if (map.empty()) return {extent, extent};
    return {extent, extent * double(map.height() - 1) / double(map.width() - 1)};
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
