// Motion files of Biovision (BVH): a hierarchy of joints with offsets and channels, then a row of numbers a frame.
#pragma once
#include "core/io/io.h"

namespace mw {

/// One skeleton and one clip. Every order of channels is kept, Euler angles as they are, in degrees, one key a frame. Throws Error, Cancelled.
Imported readBvh(const std::filesystem::path& file, Progress* progress = nullptr);
/// The first skeleton with its clip: what was read from a BVH file is written back equal. Other clips are sampled and turned into angles.
std::vector<Warning> writeBvh(const Scene& scene, const std::filesystem::path& file, Progress* progress = nullptr);

}  // namespace mw
