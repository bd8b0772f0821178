// Encoded pictures (PNG, JPEG) as textures.
#pragma once
#include "core/scene/scene.h"
#include "render/gpu_cache.h"

namespace mw {

/// RGBA, 8 bit, top row first, as decoded. Throws Error for what is no PNG or JPEG, is broken, or has more than 64 million pixels.
struct DecodedImage {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;
};
DecodedImage decodeImage(std::span<const uint8_t> bytes);

struct PictureSampling {
    bool repeat = true;
    bool color = true;  ///< sRGB, read as linear; else numbers
};
/// Fills the bound 2D texture, with mip levels; returns its bytes.
size_t fillTexture(const DecodedImage& image, PictureSampling sampling);
/// A picture that cannot be read becomes white, numbers a half: the scene is still shown.
GLuint imageTexture(GpuCache& cache, const std::shared_ptr<const std::vector<uint8_t>>& encoded, PictureSampling sampling);

}  // namespace mw
