// Height tiles to the card, and noise for the ground.
#include "render/terrain_textures.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace mw {
namespace {

constexpr uint64_t keptFrames = 120;
constexpr int coarsestLevel = 7;  // of a tile of 128
constexpr GLenum makingUnit = GL_TEXTURE0 + 15;
constexpr uint32_t tile = HeightMap::tileSize;

/// Half as many samples along both axes: each the mean of four.
std::vector<float> halved(const std::vector<float>& from, uint32_t side)
{
    const uint32_t half = side / 2;
    std::vector<float> to(size_t(half) * half);
    for (uint32_t y = 0; y < half; ++y)
        for (uint32_t x = 0; x < half; ++x) {
            const float* a = from.data() + size_t(2 * y) * side + 2 * x;
            to[size_t(y) * half + x] = 0.25f * (a[0] + a[1] + a[side] + a[side + 1]);
        }
    return to;
}

// ---- Noise that repeats after a whole number of cells ----

uint32_t scrambled(uint32_t x, uint32_t y, uint32_t seed)
{
    uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h = (h ^ h >> 15) * 0x2C1B3C6Du;
    h = (h ^ h >> 12) * 0x297A2D39u;
    return h ^ h >> 15;
}

/// Gradient noise, about -1 to 1; repeats after `cells` along both axes.
float noise(float x, float y, uint32_t cells, uint32_t seed)
{
    const float fx = std::floor(x), fy = std::floor(y), u = x - fx, v = y - fy;
    const auto corner = [&](int dx, int dy) {
        const float angle = float(scrambled((uint32_t(fx) + uint32_t(dx)) % cells, (uint32_t(fy) + uint32_t(dy)) % cells, seed)) * 1.4629181e-9f;
        return std::cos(angle) * (u - float(dx)) + std::sin(angle) * (v - float(dy));
    };
    const auto ease = [](float t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const float a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1), s = ease(u);
    return 1.5f * (a + s * (b - a) + ease(v) * (c + s * (d - c) - a - s * (b - a)));
}

struct Octaves {
    uint32_t cells;  // of the coarsest
    int count;
    float gain;
    uint32_t seed;
    bool ridged = false;  // creases where the noise changes sign
};

float sum(float u, float v, const Octaves& o)
{
    float value = 0, weight = 1, all = 0;
    for (int k = 0; k < o.count; ++k) {
        const uint32_t cells = o.cells << k;
        const float n = noise(u * float(cells), v * float(cells), cells, o.seed + uint32_t(k));
        value += weight * (o.ridged ? 1 - 2 * std::abs(n) : n);
        all += weight;
        weight *= o.gain;
    }
    return value / all;
}

constexpr int layerSide = 512;

std::vector<uint8_t> layerPixels()
{
    std::vector<uint8_t> pixels(size_t(layerSide) * layerSide * 4);
    const auto byte = [](float v) { return uint8_t(std::lround(255 * std::clamp(0.5f + 0.5f * v, 0.f, 1.f))); };
    for (int y = 0; y < layerSide; ++y) {
        for (int x = 0; x < layerSide; ++x) {
            const float u = (float(x) + 0.5f) / layerSide, v = (float(y) + 0.5f) / layerSide;
            const float bend = 0.05f * sum(u, v, {3, 2, 0.5f, 61});
            uint8_t* p = &pixels[4 * (size_t(y) * layerSide + size_t(x))];
            p[0] = byte(1.5f * sum(u, v, {8, 5, 0.8f, 11}));                                                        // tufts
            p[1] = byte(1.1f * sum(u, v, {5, 5, 0.62f, 23, true}) - 0.1f);                                          // clefts
            p[2] = byte(0.5f * std::sin(6.2831853f * (14 * v + 22 * bend)) + 1.1f * sum(u, v, {16, 4, 0.7f, 37}));  // ripples
            p[3] = byte(1.3f * sum(u, v, {4, 4, 0.5f, 53}));                                                        // drifts
        }
    }
    return pixels;
}

}  // namespace

void HeightTexture::allocate(const HeightMap& map)
{
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto side = [&](uint32_t n) { return int((n - 1) / uint32_t(stride_)) + 1; };
    for (stride_ = 1; side(std::max(map.width(), map.height())) > largest;) stride_ *= 2;
    size_ = {std::max(2, side(map.width())), std::max(2, side(map.height()))};
    levels_ = 1;
    while (levels_ <= coarsestLevel && std::min(size_.x, size_.y) >> levels_ >= 1) ++levels_;
    for (int level = 0; level < levels_; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, GL_R32F, std::max(1, size_.x >> level), std::max(1, size_.y >> level), 0, GL_RED, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels_ - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

size_t HeightTexture::sendTile(const HeightMap& map, uint32_t tx, uint32_t ty)
{
    const Shared<float>& from = map.tile(tx, ty);
    const auto stride = uint32_t(stride_);
    uint32_t side = tile / stride;
    std::vector<float> values(size_t(side) * side);
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) values[size_t(y) * side + x] = from[size_t(y * stride) * tile + x * stride];
    size_t bytes = 0;
    for (int level = 0; level < levels_ && side > 0; ++level) {
        const glm::ivec2 at(int(tx * side), int(ty * side)), room = glm::max(size_ >> level, glm::ivec2(1)) - at;
        const glm::ivec2 sent = glm::min(glm::ivec2(int(side)), room);
        if (sent.x > 0 && sent.y > 0) {
            glPixelStorei(GL_UNPACK_ROW_LENGTH, GLint(side));
            glTexSubImage2D(GL_TEXTURE_2D, level, at.x, at.y, sent.x, sent.y, GL_RED, GL_FLOAT, values.data());
            bytes += size_t(sent.x) * size_t(sent.y) * sizeof(float);
        }
        values = halved(values, side);
        side /= 2;
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return bytes;
}

size_t HeightTexture::show(const HeightMap& map)
{
    glActiveTexture(makingUnit);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    const bool anew = shown_.width() != map.width() || shown_.height() != map.height();
    if (anew) allocate(map);
    size_t bytes = 0;
    for (uint32_t ty = 0; ty < map.tilesY(); ++ty)
        for (uint32_t tx = 0; tx < map.tilesX(); ++tx)
            if (anew || shown_.tile(tx, ty).id() != map.tile(tx, ty).id()) bytes += sendTile(map, tx, ty);
    shown_ = map;
    return bytes;
}

void TerrainTextures::beginFrame()
{
    ++frame_;
    uploaded_ = 0;
    std::erase_if(heights_, [&](const auto& h) { return h.second.lastUse + keptFrames < frame_; });
}

HeightTexture& TerrainTextures::heights(uint32_t node, const HeightMap& map)
{
    HeightTexture& t = heights_[node];
    t.lastUse = frame_;
    uploaded_ += t.show(map);
    return t;
}

GLuint TerrainTextures::layers()
{
    if (layers_) return layers_.get();
    const std::vector<uint8_t> pixels = layerPixels();
    glActiveTexture(makingUnit);
    glBindTexture(GL_TEXTURE_2D, layers_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, layerSide, layerSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    uploaded_ += pixels.size();
    return layers_.get();
}

}  // namespace mw
