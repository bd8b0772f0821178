#include "core/io/height_picture.h"

#include <algorithm>
#include <cctype>

#include "core/io/height_picture_data.h"

namespace mw {

namespace {

HeightPicture readAny(const std::filesystem::path& file, Progress* progress)
{
    const std::string name = file.string();
    const FileBytes bytes = readBytes(file);
    const std::string_view text = bytes.text();
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return readPng(bytes, name, progress);
    if (text.starts_with("P2") || text.starts_with("P5")) return readPgm(bytes, name, progress);
    if (ending == ".tga") return readTga(bytes, name, progress);  // nothing in it says so
    if (text.empty()) throw Error(name, "is empty; get it again");
    throw Error(name, "does not begin as a PNG or PGM does; save the picture as 8 or 16 bits grey PNG");
}

HeightMap mapOf(const HeightPicture& p)
{
    return HeightMap(p.width, p.height, p.heights);
}

/// What the picture of one terrain says nothing about.
std::vector<Warning> leftOut(const Scene& scene)
{
    std::vector<Warning> lost;
    const size_t others = scene.terrains().size() - 1 + scene.meshes().size();
    if (others > 0)
        lost.push_back(
            {"not-in-picture", "only one terrain goes into a picture; " + std::to_string(others) + " further terrains and meshes are left out", {}});
    return lost;
}

}  // namespace

void checkPictureSize(uint64_t width, uint64_t height, const std::string& file)
{
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width < 2 || height < 2) throw Error(file, "has " + size + "; a height map needs at least 2 x 2");
    if (width > HeightMap::largestSize || height > HeightMap::largestSize)
        throw Error(file, "has " + size + ", the most is " + std::to_string(HeightMap::largestSize) + " along a side; make it smaller first");
}

HeightMap readHeightMap(const std::filesystem::path& file, std::vector<Warning>* warnings, Progress* progress)
{
    HeightPicture p = readAny(file, progress);
    if (warnings) warnings->insert(warnings->end(), p.warnings.begin(), p.warnings.end());
    return mapOf(p);
}

Imported readHeightPicture(const std::filesystem::path& file, Progress* progress)
{
    const HeightPicture p = readAny(file, progress);
    Imported out;
    out.format = p.format;
    out.units = "unknown";
    out.warnings = p.warnings;
    TerrainObject object;
    object.terrain.name = file.stem().string();
    object.terrain.map = mapOf(p);
    Node node;
    node.name = object.terrain.name;
    node.terrain = out.scene.add(std::move(object));
    out.scene.add(std::move(node));
    return out;
}

std::vector<Warning> writeHeightMap(const HeightMap& map, const std::filesystem::path& file, Progress* progress)
{
    std::vector<Warning> warnings;
    HeightMap inside = map;
    if (const auto [least, most] = map.range(); least < 0 || most > 1) {
        Array<float> rows = map.rows();
        const auto cut = std::count_if(rows.begin(), rows.end(), [](float h) { return h < 0 || h > 1; });
        for (float& h : rows) h = std::clamp(h, 0.f, 1.f);
        inside = HeightMap(map.width(), map.height(), rows);
        warnings.push_back({"height-cut", std::to_string(cut) + " heights outside 0 to 1 were cut off; stretch the map first to keep them", {}});
    }
    OutputFile out(file);
    writePng(inside, out, file.string(), progress);
    out.commit();
    return warnings;
}

std::vector<Warning> writeHeightPicture(const Scene& scene, const std::filesystem::path& file, Progress* progress)
{
    if (scene.terrains().empty()) throw Error(file.string(), "a picture holds a terrain, and the scene has none; name a .glb, .obj or .ply file");
    const TerrainObject& object = *scene.find(scene.terrains().front());
    if (object.terrain.map.empty()) throw Error(file.string(), "the terrain \"" + object.terrain.name + "\" has no heights to write");
    std::vector<Warning> lost = leftOut(scene);
    const std::vector<Warning> cut = writeHeightMap(object.terrain.map, file, progress);
    lost.insert(lost.end(), cut.begin(), cut.end());
    return lost;
}

}  // namespace mw
