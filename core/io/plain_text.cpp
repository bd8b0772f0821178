// Text files as UTF-8 with '\n' at the ends of lines, whatever program wrote them.
#include <algorithm>
#include <cstring>

#include "core/io/file.h"

namespace mw {

namespace {

/// UTF-16 code units to UTF-8. Broken pairs become U+FFFD.
FileBytes fromUtf16(const FileBytes& bytes, bool bigEndian)
{
    const auto unit = [&](size_t i) {
        const uint32_t a = uint8_t(bytes.data()[2 * i]), b = uint8_t(bytes.data()[2 * i + 1]);
        return bigEndian ? a << 8 | b : b << 8 | a;
    };
    std::string out;
    out.reserve(bytes.size() / 2 + 16);
    const size_t units = bytes.size() / 2;
    for (size_t i = 1; i < units; ++i) {
        uint32_t c = unit(i);
        if (c >= 0xd800 && c < 0xe000) {
            const uint32_t low = c < 0xdc00 && i + 1 < units ? unit(i + 1) : 0;
            const bool pair = low >= 0xdc00 && low < 0xe000;
            c = pair ? 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00) : 0xfffd;
            i += pair;
        }
        if (c < 0x80) {
            out += char(c);
            continue;
        }
        if (c >= 0x10000) out += char(0xf0 | c >> 18);
        if (c >= 0x800) out += char(c >= 0x10000 ? 0x80 | (c >> 12 & 0x3f) : 0xe0 | c >> 12);
        out += char(c >= 0x800 ? 0x80 | (c >> 6 & 0x3f) : 0xc0 | c >> 6);
        out += char(0x80 | (c & 0x3f));
    }
    FileBytes text(out.size());
    std::copy(out.begin(), out.end(), text.data());
    return text;
}

}  // namespace

FileBytes plainText(FileBytes bytes, const std::string& file)
{
    if (bytes.text().starts_with("\xff\xfe") || bytes.text().starts_with("\xfe\xff")) {
        if (bytes.size() % 2) throw Error(file, "is UTF-16 text of an odd number of bytes; save it as UTF-8");
        bytes = fromUtf16(bytes, bytes.text()[0] == '\xfe');
    }
    if (bytes.text().starts_with("\xef\xbb\xbf")) std::memset(bytes.data(), ' ', 3);
    if (!std::memchr(bytes.begin(), '\n', bytes.size())) std::replace(bytes.data(), bytes.data() + bytes.size(), '\r', '\n');
    return bytes;
}

}  // namespace mw
