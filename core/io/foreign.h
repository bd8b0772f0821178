// Formats that are read by another library in a program of its own, meshwright-import, under limits of time and memory: whatever happens
// there is a message here. Its result comes as our own project on a pipe.
#pragma once
#include <string_view>

#include "core/io/io.h"

namespace mw {

/// By ending, lower case with dot: .fbx .x .md5mesh .md5anim .dae .3ds
bool isForeign(std::string_view ending);
/// Throws Error (also when the program crashed, took too long or too much memory), Cancelled.
Imported readForeign(const std::filesystem::path& file, Progress* progress = nullptr);

}  // namespace mw
