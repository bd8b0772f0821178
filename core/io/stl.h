// STL: text and binary. Behind readFile and writeFile.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/io/io.h"

namespace mw {

/// Is a file of this size and start surely STL? Binary: 84 + 50 n bytes with n in its place. Text: "solid" and a facet.
bool isStl(std::string_view start, uint64_t size);

/// Corners at exactly the same place become one vertex; facets keep their order, degenerate ones stay. Normals of facets are not kept: they follow
/// from the corners. Solids of text files become groups, colours of facets (VisCAM, SolidView and Magics) colours of corners. A loop of more than
/// three vertices is a polygon. What a cut text file has is read, with a warning; a binary file must have the facets it announces.
/// Throws Error naming the line or byte; Cancelled.
Imported readStl(const std::filesystem::path& file, Progress* progress = nullptr);

/// Triangles. Binary keeps one colour a facet, in five bits a channel; text keeps groups as solids. What is lost is said.
std::vector<Warning> writeStl(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress = nullptr);

}  // namespace mw
