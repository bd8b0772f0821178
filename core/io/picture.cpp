#include "core/io/picture.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace mw {

namespace {

constexpr std::array<uint8_t, 8> pngStart{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

size_t word(std::span<const uint8_t> b, size_t at)
{
    return size_t(b[at]) << 24 | size_t(b[at + 1]) << 16 | size_t(b[at + 2]) << 8 | b[at + 3];
}

// Chunks of a PNG as (offset, bytes with header and check sum); empty unless header and pixels are there.
std::vector<std::pair<size_t, size_t>> pngChunks(std::span<const uint8_t> b)
{
    std::vector<std::pair<size_t, size_t>> chunks;
    bool pixels = false;
    for (size_t at = pngStart.size(); at + 12 <= b.size();) {
        const size_t size = word(b, at);
        if (size > b.size() - at - 12) break;
        chunks.emplace_back(at, size + 12);
        const std::string_view type(reinterpret_cast<const char*>(b.data()) + at + 4, 4);
        if (chunks.size() == 1 && (type != "IHDR" || size != 13 || word(b, at + 8) == 0 || word(b, at + 12) == 0)) return {};
        pixels = pixels || type == "IDAT";
        if (type == "IEND") break;
        at += size + 12;
    }
    if (!pixels) chunks.clear();
    return chunks;
}

// Segments up to the frame header, which must be there and have pixels.
bool soundJpeg(std::span<const uint8_t> b)
{
    for (size_t at = 2; at + 9 < b.size();) {
        if (b[at] != 0xFF) return false;
        const uint8_t marker = b[at + 1];
        if (marker == 0xFF) {  // padding
            ++at;
            continue;
        }
        const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (frame) return (b[at + 5] || b[at + 6]) && (b[at + 7] || b[at + 8]);
        if (marker == 0xDA || marker == 0xD9) return false;
        at += 2 + (size_t(b[at + 2]) << 8 | b[at + 3]);
    }
    return false;
}

}  // namespace

std::string pictureType(std::span<const uint8_t> bytes)
{
    if (bytes.size() >= pngStart.size() && std::equal(pngStart.begin(), pngStart.end(), bytes.begin())) return "image/png";
    if (bytes.size() >= 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF) return "image/jpeg";
    return {};
}

std::shared_ptr<const std::vector<uint8_t>> portablePicture(const std::shared_ptr<const std::vector<uint8_t>>& bytes)
{
    if (!bytes) return nullptr;
    const std::string type = pictureType(*bytes);
    if (type == "image/jpeg") return soundJpeg(*bytes) ? bytes : nullptr;
    if (type != "image/png") return nullptr;
    const auto chunks = pngChunks(*bytes);
    if (chunks.empty()) return nullptr;
    constexpr std::array<std::string_view, 7> ignored{"gAMA", "cHRM", "iCCP", "pHYs", "acTL", "fcTL", "fdAT"};
    std::vector<uint8_t> kept(pngStart.begin(), pngStart.end());
    bool changed = false;
    for (const auto& [at, size] : chunks) {
        const std::string_view name(reinterpret_cast<const char*>(bytes->data()) + at + 4, 4);
        if (std::find(ignored.begin(), ignored.end(), name) != ignored.end())
            changed = true;
        else
            kept.insert(kept.end(), bytes->begin() + std::ptrdiff_t(at), bytes->begin() + std::ptrdiff_t(at + size));
    }
    return changed ? std::make_shared<const std::vector<uint8_t>>(std::move(kept)) : bytes;
}

}  // namespace mw
