// Stanford PLY: text and both binary encodings. Behind readFile and writeFile.
#pragma once
#include <filesystem>
#include <vector>

#include "core/io/io.h"

namespace mw {

/// Elements in any order, lists of any type. Vertices: x y z, normals (nx ny nz), colours (red green blue alpha; bytes are divided by 255 and
/// otherwise taken as they stand), texture coordinates (s t, u v, texture_u texture_v; they become corner attributes). Faces: vertex_indices,
/// colours (become corner colours), lists with a number of values for each corner (texcoord and others; become corner attributes). Edges become
/// lines, tristrips triangles. Any other scalar is an attribute of its own name with its stored type; NAME_0, NAME_1, ... are one attribute.
/// What is left out is said in a warning. Counts are tested against the bytes that are there before anything is allocated.
/// Throws Error, Cancelled.
Imported readPly(const std::filesystem::path& file, Progress* progress = nullptr);

/// Polygons and all attributes, with the stored types they came with.
std::vector<Warning> writePly(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress = nullptr);

}  // namespace mw
