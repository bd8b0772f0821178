// Texts that are compiled into the program: lessons, and the source of whatever can be stepped. Nothing is looked for on the disk.
#pragma once
#include <string_view>
#include <vector>

namespace mw {

struct Resource {
    std::string_view path;  ///< in the repository: "resources/lessons/decimate-quadric.json", "core/simplify/decimate_quadric.cpp"
    std::string_view text;
};

/// All of them, by path.
const std::vector<Resource>& resources();
/// By path in the repository, or by a longer path that ends in it (what a compiler calls a file). Empty when there is none.
std::string_view resourceText(std::string_view path);

}  // namespace mw
