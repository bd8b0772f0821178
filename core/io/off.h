// OFF of Geomview: text and binary, with colours, normals and texture coordinates. Behind readFile and writeFile.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/io/io.h"

namespace mw {

/// Does a file with this start say that it is OFF? ("OFF", "COFF", "STCNOFF", "# by hand\nOFF 8 6 0", ...)
bool isOff(std::string_view start);

/// Kept: every vertex and its index, polygons, normals (N), colours of vertices (C) and faces (they become corner colours), texture coordinates
/// (ST; they become corner attributes), numbers of a colour map (face attribute "color_index"). 4OFF is divided by its fourth value; nOFF is read
/// when it has three dimensions. Binary files are big-endian, as Geomview has them, or little-endian; the counts tell which. Counts are tested
/// against the bytes that are there before anything is allocated. Throws Error naming the line or byte; Cancelled.
Imported readOff(const std::filesystem::path& file, Progress* progress = nullptr);

/// Binary is big-endian, as Geomview reads it. Numbers in text are the shortest that read back equal.
std::vector<Warning> writeOff(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress = nullptr);

}  // namespace mw
