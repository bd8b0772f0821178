// Wavefront OBJ with its MTL libraries and pictures. Behind readFile and writeFile.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/io.h"

namespace mw {

/// The whole file is one mesh. Kept: every vertex and its index, colours after the coordinates, texture coordinates and normals (corner
/// attributes), polygons, lines, objects and groups (face attribute "group"), materials (face attribute "material").
/// A face that names a vertex which is not there, or whose position is not finite, is left out with a warning that names its line; the vertex
/// stays at the centre of the others, so that indices stay. Colours are taken as they stand in the file. Libraries and pictures are only
/// read from the file's folder or below. Comments may state unit and up axis (placement.h). UTF-16 with a byte order mark is understood. Throws
/// Error, Cancelled.
Imported readObj(const std::filesystem::path& file, Progress* progress = nullptr);

/// Writes FILE, FILE's stem + ".mtl" when there are materials, and their pictures beside it. Numbers are the shortest that read back equal.
std::vector<Warning> writeObj(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress = nullptr);

}  // namespace mw
