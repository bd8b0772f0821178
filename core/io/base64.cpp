#include "core/io/base64.h"

#include <array>

namespace mw {

namespace {

constexpr std::array<int8_t, 256> makeValues()
{
    std::array<int8_t, 256> v{};
    v.fill(-1);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < alphabet.size(); ++i) v[uint8_t(alphabet[i])] = int8_t(i);
    v[uint8_t('-')] = 62;  // the alphabet for file names occurs, too
    v[uint8_t('_')] = 63;
    return v;
}
constexpr std::array<int8_t, 256> values = makeValues();

}  // namespace

std::optional<std::vector<uint8_t>> decodedBase64(std::string_view text)
{
    for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::vector<uint8_t> out;
    out.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int v = values[uint8_t(c)];
        if (v < 0) return std::nullopt;
        bits = bits << 6 | uint32_t(v);
        if ((count += 6) >= 8) out.push_back(uint8_t(bits >> (count -= 8)));
    }
    return out;
}

}  // namespace mw
