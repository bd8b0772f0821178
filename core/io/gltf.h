// glTF 2.0 and GLB: reader (validates every count, offset, index and node cycle before use) and writer. Behind readFile and writeFile.
#pragma once
#include <filesystem>
#include <vector>

#include "core/io/io.h"

namespace mw {

/// Throws Error, Cancelled.
Imported readGltf(const std::filesystem::path& file, Progress* progress);
/// ".gltf" with a ".bin" beside it, or ".glb". Gives what the format could not hold.
std::vector<Warning> writeGltf(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options, Progress* progress);

}  // namespace mw
