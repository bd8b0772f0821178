// Numbers to text, quickly: the same bytes as std::to_chars, which makes the shortest text that reads back equal.
#pragma once
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace mw {

/// How much room a number needs; all of it may be written to, whatever the number's length.
inline constexpr int numberRoom = 32;

namespace detail {

static_assert(std::endian::native == std::endian::little);

inline constexpr uint32_t tenToTheEighth = 100'000'000;
inline constexpr uint64_t zeros = 0x3030303030303030u;  // as text
extern const std::array<uint32_t, 10000> fourDigits;    // of each number as text, the first one in the lowest byte

/// v < 10^8.
inline uint64_t eightDigits(uint32_t v)
{
    return fourDigits[v / 10000] | uint64_t(fourDigits[v % 10000]) << 32;
}
inline void put(char* to, uint64_t eight)
{
    std::memcpy(to, &eight, 8);
}

}  // namespace detail

/// Writes `v` at `to` and gives the end of its text.
char* putNumber(char* to, float v);
inline char* putNumber(char* to, uint32_t v)
{
    if (v >= detail::tenToTheEighth) return std::to_chars(to, to + numberRoom, v).ptr;
    const uint64_t digits = detail::eightDigits(v);
    const int before = std::countr_zero((digits ^ detail::zeros) | uint64_t(1) << 56) / 8;  // 0 has a digit, too
    detail::put(to, digits >> 8 * before);
    return to + 8 - before;
}

}  // namespace mw
