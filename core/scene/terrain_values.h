// The settings of a terrain that are changed by number, described once for the panel and for the edit.
#pragma once
#include "core/catalog/parameters.h"
#include "core/terrain/terrain.h"

namespace mw {

struct TerrainGround {
    double extent = 1000, maximumHeight = 115, waterLevel = 0;
    template <class V>
    void describe(V& v)
    {
        v.number("extent", extent,
                 {.title = "Extent",
                  .help = "Length of the terrain along X.",
                  .unit = "m",
                  .min = 0.01,
                  .max = 1e7,
                  .softMin = 10,
                  .softMax = 100000,
                  .logarithmic = true});
        v.number("maximumHeight", maximumHeight,
                 {.title = "Maximum height",
                  .help = "Height of white in the height map.",
                  .unit = "m",
                  .min = 0.001,
                  .max = 1e6,
                  .softMin = 1,
                  .softMax = 1000});
        v.number("waterLevel", waterLevel,
                 {.title = "Water level",
                  .help = "What lies lower is under water. Below the lowest point there is none.",
                  .unit = "m",
                  .min = -1e6,
                  .max = 1e6,
                  .softMin = 0,
                  .softMax = 200});
    }
};

struct TerrainDetail {
    int64_t patches = 16;
    double nearLevel = 64, farLevel = 4, nearDistance = 80, farDistance = 900;
    enum class Edges { Corrected, ShowCracks } edges = Edges::Corrected;
    template <class V>
    void describe(V& v)
    {
        v.integer("patches", patches,
                  {.title = "Patches", .help = "Patches along X; each is tessellated by its own distance.", .min = 1, .max = 128, .softMax = 64});
        v.number("nearLevel", nearLevel, {.title = "Near level", .help = "Segments along the edges of near patches.", .min = 1, .max = 64});
        v.number("farLevel", farLevel, {.title = "Far level", .help = "Segments along the edges of far patches.", .min = 1, .max = 64});
        v.number("nearDistance", nearDistance,
                 {.title = "Near distance", .help = "Up to here patches have the near level.", .unit = "m", .min = 0, .max = 1e7, .softMax = 2000});
        v.number("farDistance", farDistance,
                 {.title = "Far distance", .help = "From here on patches have the far level.", .unit = "m", .min = 0, .max = 1e7, .softMax = 5000});
        v.choice("edges", edges, {"corrected", "show-cracks"},
                 {.title = "Edges",
                  .help = "Corrected: an edge has one level for both its patches, from its own middle. Show cracks: each patch uses its own."});
    }
};

struct TerrainLayers {
    double sandTo = 0.2, grassTo = 0.48, snowFrom = 0.55, rockSlope = 32;
    template <class V>
    void describe(V& v)
    {
        const auto share = [](const char* title, const char* help) { return About{.title = title, .help = help, .min = -1, .max = 2}; };
        v.number("sandTo", sandTo, share("Sand to", "Height, as a share of the maximum height, up to which there is sand."));
        v.number("grassTo", grassTo, share("Grass to", "Height, as a share of the maximum height, up to which grass grows."));
        v.number("snowFrom", snowFrom, share("Snow from", "Height, as a share of the maximum height, from which snow lies."));
        v.number("rockSlope", rockSlope,
                 {.title = "Rock from slope", .help = "Ground steeper than this is bare rock.", .unit = "\u00b0", .min = 0, .max = 90});
    }
};

inline ParameterValues groundValues(const Terrain& t)
{
    return {{"extent", t.extent}, {"maximumHeight", t.maximumHeight}, {"waterLevel", t.waterLevel}};
}

inline ParameterValues detailValues(const Terrain::Detail& d)
{
    return {{"patches", int64_t(d.patches)},  {"nearLevel", d.nearLevel},     {"farLevel", d.farLevel},
            {"nearDistance", d.nearDistance}, {"farDistance", d.farDistance}, {"edges", std::string(d.corrected ? "corrected" : "show-cracks")}};
}

inline ParameterValues terrainValues(const Terrain& t)
{
    ParameterValues all = groundValues(t);
    all.merge(detailValues(t.detail));
    const Terrain::Layers& l = t.layers;
    all.merge(ParameterValues{{"sandTo", l.sandTo}, {"grassTo", l.grassTo}, {"snowFrom", l.snowFrom}, {"rockSlope", l.rockSlope}});
    return all;
}

struct TerrainValues {
    TerrainGround ground;
    TerrainDetail detail;
    TerrainLayers layers;
    template <class V>
    void describe(V& v)
    {
        ground.describe(v);
        detail.describe(v);
        layers.describe(v);
    }
    void put(Terrain& t) const
    {
        t.layers = {layers.sandTo, layers.grassTo, layers.snowFrom, layers.rockSlope};
        t.extent = ground.extent;
        t.maximumHeight = ground.maximumHeight;
        t.waterLevel = ground.waterLevel;
        t.detail = {int(detail.patches), detail.nearLevel,   detail.farLevel,
                    detail.nearDistance, detail.farDistance, detail.edges == TerrainDetail::Edges::Corrected};
    }
};

}  // namespace mw
