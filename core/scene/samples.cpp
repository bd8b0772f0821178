#include "core/scene/samples.h"

#include "core/error.h"

namespace mw {

const std::vector<Sample>& samples()
{
    static const std::vector<Sample> all{
        {"blossom", "Blossom", "A coarse star, rounded by Loop subdivision", blossomScene},
        {"rock", "Scanned rock", "81,000 faces with the holes a scanner leaves: fill, simplify", rockScene},
        {"quadruped", "Dog", "A closed body of quads: subdivide, deform, smooth", quadrupedScene},
        {"gears", "Gears", "Three wheels of genus 5, 6 and 7, with sharp edges", gearsScene},
        {"broken", "Broken pear", "Every defect the inspector knows: repair it", brokenScene},
        {"mannequin", "Mannequin", "A figure with skeleton and skin that walks and breathes", mannequinScene},
        {"terrain", "Terrain", "Hills and a lake by diamond-square: paint on it", terrainScene},
    };
    return all;
}

Scene sampleScene(std::string_view id)
{
    for (const Sample& s : samples())
        if (s.id == id) return s.make();
    std::string list;
    for (const Sample& s : samples()) list += (list.empty() ? "" : ", ") + std::string(s.id);
    throw Error("sample:" + std::string(id), "there is no such sample; there are: " + list);
}

}  // namespace mw
