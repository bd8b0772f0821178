// Motion files of Biovision (BVH): a hierarchy of joints with offsets and channels, then a row of numbers a frame.
#pragma once
#include "core/io/io.h"

namespace mw {

/// A skeleton a ROOT, and one clip when there are frames. Every order of channels is kept, Euler angles as they are, in degrees, one key a
/// frame. Throws Error, Cancelled.
Imported readBvh(const std::filesystem::path& file, Progress* progress = nullptr);
/// Every skeleton, each a ROOT, with the first clip: what was read from a BVH file is written back equal. Other motion is sampled each frame
/// (1/30 s where the clip does not say) and turned into angles Z X Y that do not jump. Gives what BVH cannot hold.
std::vector<Warning> writeBvh(const Scene& scene, const std::filesystem::path& file, Progress* progress = nullptr);

}  // namespace mw
