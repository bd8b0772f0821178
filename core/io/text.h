// Numbers in text, fast and independent of the locale. All readers here expect a buffer that ends in '\n' or zero and `textPadding` zeros
// (FileBytes).
#pragma once
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/mesh/large_pages.h"

namespace mw {

/// How far behind the end a number's reader may look.
inline constexpr size_t textPadding = 20;

inline bool isDigit(char c)
{
    return uint8_t(c - '0') < 10;
}
/// Space, tab, line end, or the zeros after the end.
inline bool endsToken(char c)
{
    return uint8_t(c) <= ' ';
}
inline std::string_view tokenAt(const char* p)
{
    const char* q = p;
    while (!endsToken(*q)) ++q;
    return {p, size_t(q - p)};
}

namespace detail {

/// The value of eight digits, each 0 to 9 in a byte, the first one in the lowest.
inline uint32_t valueOfEight(uint64_t d)
{
    d = d * 2561 >> 8 & 0x00ff00ff00ff00ffu;
    d = d * 6553601 >> 16 & 0x0000ffff0000ffffu;
    return uint32_t(d * 42949672960001u >> 32);
}

/// How many digits stand at p, eight at most, and their value: all at once. Reads eight bytes.
inline int upToEightDigits(const char* p, uint32_t& value)
{
    static_assert(std::endian::native == std::endian::little);
    uint64_t bytes;
    std::memcpy(&bytes, p, 8);
    uint64_t d = bytes ^ 0x3030303030303030u;  // digits become 0 to 9
    const uint64_t others = ((d + 0x7676767676767676u) | d) & 0x8080808080808080u;
    const int count = others ? std::countr_zero(others) / 8 : 8;
    value = valueOfEight(count ? d << (64 - 8 * count) : 0);  // zeros before them
    return count;
}
inline constexpr uint32_t wholePowersOfTen[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/// Appends the digits at p to the mantissa; what is more than 64 bits hold wraps round, and whoever calls sees it by their number.
inline const char* appendDigits(const char* p, uint64_t& mantissa)
{
    uint32_t value = 0;
    int count = 8;
    while (count == 8) {
        count = upToEightDigits(p, value);
        mantissa = mantissa * wholePowersOfTen[count] + value;
        p += count;
    }
    return p;
}

inline constexpr double powersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                         1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

#ifdef __SSE2__
/// "-12.3456" in sixteen characters at most, as nearly all coordinates are: its ends are found at once, so that the next number need not wait for the
/// digits of this one. False when it is anything else.
inline bool parsePlain(const char*& p, double& value)
{
    const bool negative = *p == '-';
    const char* q = p + negative;
    const __m128i d = _mm_sub_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(q)), _mm_set1_epi8('0'));
    const unsigned digits = unsigned(_mm_movemask_epi8(_mm_cmpeq_epi8(_mm_min_epu8(d, _mm_set1_epi8(9)), d)));
    const unsigned others = ~digits & 0xffff, afterPoint = others & (others - 1);
    if (!afterPoint) return false;
    const int point = std::countr_zero(others), end = std::countr_zero(afterPoint), count = end - 1;
    if (q[point] != '.' || count == 0 || (q[end] | 0x20) == 'e') return false;
    // The point is taken out, and what follows the last digit; zeros come before the first.
    uint64_t low = uint64_t(_mm_cvtsi128_si64(d)), high = uint64_t(_mm_cvtsi128_si64(_mm_unpackhi_epi64(d, d)));
    unsigned __int128 all = (unsigned __int128)high << 64 | low, before = (((unsigned __int128)1) << 8 * point) - 1;
    all = ((all & before) | (all >> 8 & ~before)) << 8 * (16 - count);
    const uint64_t mantissa = uint64_t(valueOfEight(uint64_t(all))) * 100000000 + valueOfEight(uint64_t(all >> 64));
    // At most 14 digits and as many decimals: both are exact.
    const double v = double(mantissa) / powersOfTen[count - point];
    value = negative ? -v : v;
    p = q + end;
    return true;
}

/// Where tokens end among 64 characters: a bit each.
inline uint64_t tokenEnds(const char* p)
{
    uint64_t ends = 0;
    for (int i = 0; i < 4; ++i) {
        const __m128i c = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p) + i);
        const __m128i blank = _mm_cmpeq_epi8(_mm_min_epu8(c, _mm_set1_epi8(' ')), c);
        ends |= uint64_t(unsigned(_mm_movemask_epi8(blank))) << 16 * i;
    }
    return ends;
}
#else
inline bool parsePlain(const char*&, double&)
{
    return false;
}
#endif

/// Whatever the fast path does not do: many digits, large exponents, "nan", "inf".
template <class T>
bool parseSlowly(const char*& p, T& value)
{
    const char* first = p + (*p == '+' ? 1 : 0);
    if (*p == '+' && *first == '-') return false;
    const std::string_view token = tokenAt(first);
    const auto [end, error] = std::from_chars(first, first + token.size(), value);
    if (error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) {
        // Too large, or too close to zero: the exponent's sign tells, or else a digit before the point.
        const std::string_view number(first, size_t(end - first));
        const size_t e = number.find_first_of("eE");
        const bool small =
            e != number.npos ? number.substr(e + 1).starts_with('-') : number.substr(0, number.find('.')).find_first_of("123456789") == number.npos;
        const T size = small ? T(0) : std::numeric_limits<T>::infinity();
        value = *first == '-' ? -size : size;
    }
    p = end;
    return true;
}

/// Sign, digits, point, exponent. False when the value is not surely exact in a double by one operation.
inline bool parseExact(const char*& p, double& value)
{
    const char* q = p;
    const bool negative = *q == '-';
    if (negative || *q == '+') ++q;
    uint64_t mantissa = 0;
    const char* digits = q;
    q = appendDigits(q, mantissa);
    long count = q - digits, exponent = 0;
    if (*q == '.') {
        const char* decimals = ++q;
        q = appendDigits(q, mantissa);
        exponent = decimals - q;
        count -= exponent;
    }
    if (count == 0 || count > 19 || mantissa > (uint64_t(1) << 53)) return false;
    if ((*q | 0x20) == 'e') {
        const char* e = q + 1;
        const bool down = *e == '-';
        if (down || *e == '+') ++e;
        if (isDigit(*e)) {
            long n = 0;
            while (isDigit(*e)) n = n < 10000 ? n * 10 + (*e++ - '0') : (++e, n);
            exponent += down ? -n : n;
            q = e;
        }
    }
    if (exponent < -22 || exponent > 22) return false;
    // Both factors are exact, so that one division or product is correctly rounded (Clinger 1990).
    const double v = exponent < 0 ? double(mantissa) / powersOfTen[-exponent] : double(mantissa) * powersOfTen[exponent];
    value = negative ? -v : v;
    p = q;
    return true;
}

}  // namespace detail

/// Reads the number at p, correctly rounded, and moves p past it; false, p as it was, when there is none. Understands a leading '+', "nan" and
/// "inf"; what is too large becomes infinite.
inline bool parseNumber(const char*& p, double& value)
{
    return detail::parsePlain(p, value) || detail::parseExact(p, value) || detail::parseSlowly(p, value);
}
inline bool parseNumber(const char*& p, float& value)
{
    const char* start = p;
    double d = 0;
    if (detail::parsePlain(p, d) || detail::parseExact(p, d)) {
        // A double that lies half-way between two floats may itself have been rounded: then the text decides. Tiny ones have fewer bits.
        const bool halfway = (std::bit_cast<uint64_t>(d) & 0x1fffffff) == 0x10000000;
        if (!halfway && (std::abs(d) >= double(std::numeric_limits<float>::min()) || d == 0)) {
            value = float(d);
            return true;
        }
        p = start;
    }
    return detail::parseSlowly(p, value);
}

/// Decimal digits; false when there are none. Stays at 2^40 or a little above when there are more.
inline bool parseDigits(const char*& p, uint64_t& value)
{
    uint32_t first = 0;
    const int count = detail::upToEightDigits(p, first);
    if (count < 8) {
        p += count;
        value = first;
        return count > 0;
    }
    uint64_t v = 0;
    while (isDigit(*p)) {
        if (v < (uint64_t(1) << 40)) v = v * 10 + uint64_t(*p - '0');
        ++p;
    }
    value = v;
    return true;
}
/// A whole number of one to seven digits, as nearly all indices are; false when it is none.
inline bool parseShort(const char*& p, uint32_t& value)
{
    const int count = detail::upToEightDigits(p, value);
    if (count == 0 || count == 8) return false;
    p += count;
    return true;
}

namespace detail {

/// See parseThree; `parse` reads one.
template <class T, class Parse>
bool threeAtOnce(const char*& p, T* to, const Parse& parse)
{
#ifdef __SSE2__
    const uint64_t first = tokenEnds(p), second = first & (first - 1), third = second & (second - 1);
    if (!third) return false;
    const char* const ends[] = {p + std::countr_zero(first), p + std::countr_zero(second), p + std::countr_zero(third)};
    if (*ends[0] != ' ' || *ends[1] != ' ') return false;
    const char* q = p;
    for (int k = 0; k < 3; ++k) {
        if (!parse(q, to[k]) || q != ends[k]) return false;
        q = ends[k] + 1;
    }
    p = ends[2];
    return true;
#else
    return false;
#endif
}

}  // namespace detail

/// Three numbers with a space between, as nearly all places and triangles are written: the ends of all are found in one look at 64 characters, so
/// that none waits for the digits of another. False, p as it was, when they stand otherwise. The bytes must be readable that far: see FileBytes.
inline bool parseThree(const char*& p, float* to)
{
    return detail::threeAtOnce(p, to, [](const char*& q, float& v) { return parseNumber(q, v); });
}
/// The same for whole numbers of up to seven digits.
inline bool parseThree(const char*& p, uint32_t* to)
{
    return detail::threeAtOnce(p, to, [](const char*& q, uint32_t& v) { return parseShort(q, v); });
}

/// A piece of a file for a message: cut short, nothing unprintable.
std::string inQuotes(std::string_view text);
/// Without blanks and line ends at both ends.
std::string_view trimmed(std::string_view text);

/// An array that is filled one by one without being zeroed first.
template <class T>
class Filling {
public:
    void expect(size_t n)
    {
        if (n > array_.size()) grow(n);
    }
    void push(const T& v)
    {
        if (size_ == array_.size()) grow(size_ + size_ / 2 + 64);
        array_[size_++] = v;
    }
    /// Where to put up to `n` more; then say with cut() how many there are now.
    T* room(size_t n)
    {
        if (array_.size() - size_ < n) grow(size_ + size_ / 2 + n + 64);
        return array_.data() + size_;
    }
    void fill(size_t to, const T& v)
    {
        while (size_ < to) push(v);
    }
    void cut(size_t n) { size_ = n; }
    size_t size() const { return size_; }
    T& operator[](size_t i) { return array_[i]; }
    const T& operator[](size_t i) const { return array_[i]; }
    Array<T> take()
    {
        array_.resize(size_);
        size_ = 0;
        return std::move(array_);
    }

private:
    void grow(size_t n)
    {
        array_.reserve(n);
        preferLargePages(array_);
        array_.resize(n);
    }
    Array<T> array_;
    size_t size_ = 0;
};

}  // namespace mw
