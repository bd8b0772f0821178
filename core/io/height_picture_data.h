// What the readers of height pictures give; each is bounded by the bytes of its file.
#pragma once
#include "core/error.h"
#include "core/io/file.h"
#include "core/mesh/array.h"
#include "core/steps/progress.h"
#include "core/terrain/height_map.h"

namespace mw {

struct HeightPicture {
    uint32_t width = 0, height = 0;
    Array<float> heights;  ///< 0 black to 1 white, row by row from the top
    std::string format;    ///< "PNG, 16 bits"
    std::vector<Warning> warnings;
};

// Of the bytes of `file`; throw Error, Cancelled.
HeightPicture readPng(const FileBytes& bytes, const std::string& file, Progress* progress);
HeightPicture readTga(const FileBytes& bytes, const std::string& file, Progress* progress);
HeightPicture readPgm(const FileBytes& bytes, const std::string& file, Progress* progress);
/// 16 bits grey. Heights must lie in 0 to 1.
void writePng(const HeightMap& map, OutputFile& out, const std::string& file, Progress* progress);

/// Throws unless a map can have this size.
void checkPictureSize(uint64_t width, uint64_t height, const std::string& file);
/// Brightness of a colour (Rec. 709), 0 to 1 as its parts.
inline float luma(double red, double green, double blue)
{
    return red == green && green == blue ? float(red) : float(0.2126 * red + 0.7152 * green + 0.0722 * blue);
}
inline Warning colourWarning()
{
    return {"height-from-colour", "has colours; their brightness is taken as height", {}};
}

}  // namespace mw
