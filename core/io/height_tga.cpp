// Truevision TGA: grey and true colour, plain and run-length coded (types 2, 3, 10, 11).
#include <algorithm>

#include "core/io/height_picture_data.h"

namespace mw {

namespace {

constexpr size_t headerSize = 18;

struct Header {
    int type = 0, bits = 0;
    uint32_t width = 0, height = 0;
    size_t pixels = 0;  // where they begin
    bool fromTop = false, fromRight = false;

    bool grey() const { return type == 3 || type == 11; }
    bool coded() const { return type >= 8; }
    size_t pixelBytes() const { return size_t(bits / 8); }
};

Header headerOf(const FileBytes& bytes, const std::string& file)
{
    if (bytes.size() < headerSize) throw Error(file, "has " + std::to_string(bytes.size()) + " bytes, the header of a TGA has 18; get it again");
    const auto* b = reinterpret_cast<const uint8_t*>(bytes.data());
    const auto word = [&](size_t at) { return uint32_t(b[at] | b[at + 1] << 8); };
    Header h{b[2], b[16], word(12), word(14), 0, (b[17] & 32) != 0, (b[17] & 16) != 0};
    if (h.type != 2 && h.type != 3 && h.type != 10 && h.type != 11)
        throw Error(file,
                    "is no TGA of grey or true colours (type " + std::to_string(h.type) + " at byte 2, known are 2, 3, 10 and 11); save it as one");
    if (h.grey() ? h.bits != 8 : h.bits != 24 && h.bits != 32)
        throw Error(file, "has " + std::to_string(h.bits) + " bits a pixel (byte 16); save it with 8 as grey, or with 24 or 32 as colours");
    checkPictureSize(h.width, h.height, file);
    // A colour map may lie there, though these types do not use it.
    h.pixels = headerSize + b[0] + (b[1] ? size_t(word(5)) * ((b[7] + 7u) / 8) : 0);
    return h;
}

[[noreturn]] void failShort(const Header& h, const FileBytes& bytes, const std::string& file)
{
    throw Error(file, "ends too early: its header announces " + std::to_string(h.width) + " x " + std::to_string(h.height) + " pixels, its " +
                          std::to_string(bytes.size()) + " bytes do not hold them; get it again");
}

/// Plain pixels of all, whatever the coding.
Array<uint8_t> decoded(const Header& h, const FileBytes& bytes, const std::string& file)
{
    const auto* at = reinterpret_cast<const uint8_t*>(bytes.data()) + std::min(h.pixels, bytes.size());
    const auto* end = reinterpret_cast<const uint8_t*>(bytes.end());
    const size_t size = h.pixelBytes(), count = size_t(h.width) * h.height;
    // A packet of 1 + size bytes gives at most 128 pixels.
    if (h.coded() ? count > size_t(end - at) / (1 + size) * 128 + 128 : count * size > size_t(end - at)) failShort(h, bytes, file);
    if (!h.coded()) return Array<uint8_t>(at, at + count * size);
    Array<uint8_t> out(count * size);
    for (uint8_t* to = out.data(); to < out.data() + out.size();) {
        if (at == end) failShort(h, bytes, file);
        const bool run = *at & 128;
        const size_t n = std::min(size_t(*at++ & 127) + 1, size_t(out.data() + out.size() - to) / size), needed = run ? size : n * size;
        if (size_t(end - at) < needed) failShort(h, bytes, file);
        for (size_t i = 0; i < n * size; ++i) to[i] = at[run ? i % size : i];
        at += needed;
        to += n * size;
    }
    return out;
}

}  // namespace

HeightPicture readTga(const FileBytes& bytes, const std::string& file, Progress* progress)
{
    const Header h = headerOf(bytes, file);
    const Array<uint8_t> pixels = decoded(h, bytes, file);
    HeightPicture out{h.width, h.height, Array<float>(size_t(h.width) * h.height), "TGA, " + std::to_string(h.bits) + " bits", {}};
    bool colours = false;
    for (uint32_t y = 0; y < h.height; ++y) {
        if (progress && y % 64 == 0) progress->at(float(y) / float(h.height));
        const uint8_t* row = pixels.data() + size_t(h.fromTop ? y : h.height - 1 - y) * h.width * h.pixelBytes();
        for (uint32_t x = 0; x < h.width; ++x) {
            const uint8_t* p = row + size_t(h.fromRight ? h.width - 1 - x : x) * h.pixelBytes();
            colours = colours || (!h.grey() && (p[0] != p[1] || p[1] != p[2]));
            out.heights[size_t(y) * h.width + x] = h.grey() ? float(p[0] / 255.0) : luma(p[2] / 255.0, p[1] / 255.0, p[0] / 255.0);
        }
    }
    if (colours) out.warnings.push_back(colourWarning());
    return out;
}

}  // namespace mw
