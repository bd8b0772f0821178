// Several results of one input side by side, seen by one camera, with values as colours over one range.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/cli/picture_options.h"
#include "render/offscreen.h"

namespace mw::cli {

/// One frame for each variant of `base`: the operation run on every mesh of it. A name without operation ("as-is") leaves them as they are.
struct Variant {
    std::string name;
    std::optional<OperationCall> call;
};
/// `--compare` as often as it is said. Throws UsageError when it is said once, or more than nine times.
std::vector<Variant> takeVariants(Arguments& arguments);
std::vector<Frame> variantFrames(const Frame& base, std::span<const Variant> variants, Progress* progress);
/// The same range for all heat maps: least to greatest of what each would show.
void shareRange(std::vector<Frame>& frames);
/// The same camera for all: where everything of all of them just fits.
void shareCamera(std::vector<Frame>& frames, double aspect);
/// Beside each other, in rows of three at most; their names in the corners. The whole picture has this size.
Picture sideBySide(Offscreen& offscreen, std::vector<Frame>& frames, std::span<const Variant> variants, const PictureSize& size);
/// Pixels of one of `count` views.
PictureSize viewSize(const PictureSize& size, size_t count);

}  // namespace mw::cli
