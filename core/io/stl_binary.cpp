// Binary STL to arrays. Two bytes of each facet may be its colour, in one of two ways.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "core/io/stl_data.h"

namespace mw {

namespace {

constexpr Finding trailingFinding{"trailing-bytes", "file goes on after its last facet: ignored", "files go on after their last facet"};

template <class T>
T little(const char* p)
{
    unsigned char b[sizeof(T)];
    std::memcpy(b, p, sizeof(T));
    uint32_t v = 0;
    for (size_t i = sizeof(T); i-- > 0;) v = v << 8 | b[i];
    if constexpr (sizeof(T) == 4)
        return std::bit_cast<T>(v);
    else
        return T(v);
}

glm::vec3 fiveBits(uint32_t first, uint32_t second, uint32_t third)
{
    return glm::vec3(float((first & 31) / 31.0), float((second & 31) / 31.0), float((third & 31) / 31.0));
}

/// VisCAM and SolidView: bit 15 says that there is a colour, blue in the lowest bits. Magics: the header has "COLOR=" and the colour of whatever has
/// none of its own, which bit 15 tells, red in the lowest bits.
void colors(const FileBytes& bytes, size_t count, StlData& data)
{
    const auto bits = [&](size_t f) { return uint32_t(little<uint16_t>(bytes.data() + stlHeader + f * stlFacet + 48)); };
    const std::string_view header = bytes.text().substr(0, 80);
    const size_t magics = header.find("COLOR=");
    const bool isMagics = magics != header.npos && magics + 10 <= header.size();
    bool any = false;
    for (size_t f = 0; f < count && !any; ++f) any = isMagics ? bits(f) != 0 : (bits(f) & 0x8000) != 0;
    if (!any && !isMagics) return;
    glm::vec3 common(1);
    for (int k = 0; isMagics && k < 3; ++k) common[k] = float(uint8_t(header[magics + 6 + size_t(k)]) / 255.0);
    data.colors.resize(count);
    for (size_t f = 0; f < count; ++f) {
        const uint32_t b = bits(f);
        const bool own = isMagics ? any && (b & 0x8000) == 0 : (b & 0x8000) != 0;
        data.colors[f] = !own ? common : isMagics ? fiveBits(b, b >> 5, b >> 10) : fiveBits(b >> 10, b >> 5, b);
    }
}

/// "Meshwright; units: millimetres, up: z" here, "UNITS=mm" elsewhere.
void header(std::string_view text, StlData& data)
{
    text = text.substr(0, std::min(text.find('\0'), text.size()));
    for (size_t i = 0; i + 5 < text.size(); ++i)
        if (i == 0 || !std::isalpha(static_cast<unsigned char>(text[i - 1]))) {
            const size_t end = text.find_first_of(",;", i);
            data.stated.listen(trimmed(text.substr(i, end == text.npos ? end : end - i)));
        }
}

}  // namespace

void parseStlBinary(const FileBytes& bytes, const std::string& file, StlData& data, Progress* progress)
{
    if (bytes.size() < stlHeader)
        throw Error(file, "is neither STL text (\"solid\" and facets) nor long enough for binary STL; check that it is an STL file");
    const uint64_t announced = little<uint32_t>(bytes.data() + 80), room = (bytes.size() - stlHeader) / stlFacet;
    if (announced > room)
        throw Error(
            file, "byte 80: announces " + std::to_string(announced) + " facets, but there are " + std::to_string(room) + "; copy or export it again");
    const size_t count = size_t(announced);
    if (3 * announced >= none - 2) throw Error(file, "more elements than 32-bit indices can number; split the file");
    if (stlHeader + count * stlFacet < bytes.size()) data.findings.add(trailingFinding);
    header(bytes.text().substr(0, 80), data);
    data.corners.expect(3 * count);
    for (size_t f = 0; f < count; ++f) {
        const char* p = bytes.data() + stlHeader + f * stlFacet + 12;
        for (int k = 0; k < 3; ++k, p += 12) data.corners.push({little<float>(p), little<float>(p + 4), little<float>(p + 8)});
        if (progress && (f & 0xffff) == 0) progress->at(0.5f * float(f) / float(count));
    }
    colors(bytes, count, data);
}

}  // namespace mw
