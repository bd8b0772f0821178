// Height maps as pictures: PNG of 8 and 16 bits in and of 16 out; TGA and PGM in. Black is height 0, white is 1.
#pragma once
#include "core/io/io.h"

namespace mw {

/// A scene with one terrain of default size. Colours become their luma. Throws Error, Cancelled.
Imported readHeightPicture(const std::filesystem::path& file, Progress* progress = nullptr);
HeightMap readHeightMap(const std::filesystem::path& file, std::vector<Warning>* warnings = nullptr, Progress* progress = nullptr);
/// The scene's first terrain, 16 bits grey; heights outside 0 to 1 are cut off and told.
std::vector<Warning> writeHeightPicture(const Scene& scene, const std::filesystem::path& file, Progress* progress = nullptr);
std::vector<Warning> writeHeightMap(const HeightMap& map, const std::filesystem::path& file, Progress* progress = nullptr);

}  // namespace mw
