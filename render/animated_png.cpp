#include "render/animated_png.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <png.h>
#include <zlib.h>

#include "core/error.h"

namespace mw {
namespace {

void put(std::vector<uint8_t>& to, uint32_t value, int bytes = 4)
{
    for (int i = bytes - 1; i >= 0; --i) to.push_back(uint8_t(value >> (8 * i)));
}

uint32_t big(const uint8_t* p)
{
    return uint32_t(p[0]) << 24 | uint32_t(p[1]) << 16 | uint32_t(p[2]) << 8 | p[3];
}

std::vector<uint8_t> encoded(const Picture& picture, const std::string& file)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(picture.width);
    png.height = png_uint_32(picture.height);
    png.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    std::vector<uint8_t> out;
    if (png_image_write_to_memory(&png, nullptr, &size, 0, picture.rgba.data(), 0, nullptr)) {
        out.resize(size);
        if (png_image_write_to_memory(&png, out.data(), &size, 0, picture.rgba.data(), 0, nullptr)) return out;
    }
    throw Error(file, std::string("a picture could not be encoded (") + png.message + ")");
}

}  // namespace

AnimatedPng::AnimatedPng(std::string file, int count, double seconds)
    : file_(std::move(file)), count_(count), milliseconds_(uint16_t(std::clamp(std::lround(1000 * seconds), 1l, 65535l)))
{
    out_ = std::fopen((file_ + ".part").c_str(), "wb");
    if (!out_) throw Error(file_, "the file cannot be written; check the folder and the rights on it");
}

AnimatedPng::~AnimatedPng()
{
    if (!out_) return;
    std::fclose(out_);
    std::error_code ignored;
    std::filesystem::remove(file_ + ".part", ignored);
}

void AnimatedPng::chunk(const char* type, const std::vector<uint8_t>& data)
{
    std::vector<uint8_t> bytes;
    put(bytes, uint32_t(data.size()));
    bytes.insert(bytes.end(), type, type + 4);
    bytes.insert(bytes.end(), data.begin(), data.end());
    put(bytes, uint32_t(crc32(0, bytes.data() + 4, uInt(bytes.size() - 4))));
    if (std::fwrite(bytes.data(), 1, bytes.size(), out_) != bytes.size()) throw Error(file_, "the file could not be written; check the space left");
}

void AnimatedPng::add(const Picture& picture)
{
    const std::vector<uint8_t> png = encoded(picture, file_);
    constexpr size_t signature = 8;
    if (added_ == 0) {
        if (std::fwrite(png.data(), 1, signature, out_) != signature) throw Error(file_, "the file could not be written; check the space left");
        chunk("IHDR", {png.begin() + 16, png.begin() + 29});
        std::vector<uint8_t> control;
        put(control, uint32_t(count_));
        put(control, 0);  // for ever
        chunk("acTL", control);
    }
    std::vector<uint8_t> frame;
    put(frame, sequence_++);
    put(frame, uint32_t(picture.width));
    put(frame, uint32_t(picture.height));
    put(frame, 0);
    put(frame, 0);
    put(frame, milliseconds_, 2);
    put(frame, 1000, 2);
    put(frame, 0, 2);  // neither disposed of nor blended
    chunk("fcTL", frame);
    for (size_t at = signature; at + 12 <= png.size(); at += 12 + big(&png[at])) {
        if (std::memcmp(&png[at + 4], "IDAT", 4) != 0) continue;
        std::vector<uint8_t> data;
        if (added_ > 0) put(data, sequence_++);
        data.insert(data.end(), &png[at + 8], &png[at + 8] + big(&png[at]));
        chunk(added_ > 0 ? "fdAT" : "IDAT", data);
    }
    ++added_;
}

void AnimatedPng::finish()
{
    chunk("IEND", {});
    const bool closed = std::fclose(out_) == 0;
    out_ = nullptr;
    std::error_code failed;
    if (closed) std::filesystem::rename(file_ + ".part", file_, failed);
    if (!closed || failed) throw Error(file_, "the file could not be put in its place; check the rights on the folder and the space left");
}

}  // namespace mw
