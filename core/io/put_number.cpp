// The shortest decimal of a float. As many decimals are taken as leave at least one decimal in the interval that is rounded to the float, but not ten
// of them: then it is the multiple of ten in the interval, when there is one, or else the nearest (as in R. Giulietti, The Schubfach way to render
// doubles, 2020). A float has 24 bits and the decimal at most 30, so that a product of doubles says which, but for a few cases in a million
// that lie within its rounding of a border; std::to_chars decides those.
#include "core/io/put_number.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace mw {

namespace detail {

constinit const std::array<uint32_t, 10000> fourDigits = [] {
    std::array<uint32_t, 10000> all{};
    for (uint32_t i = 0; i < all.size(); ++i) all[i] = 0x30303030 + i / 1000 + (i / 100 % 10 << 8) + (i / 10 % 10 << 16) + (i % 10 << 24);
    return all;
}();

}  // namespace detail

namespace {

using detail::put, detail::tenToTheEighth, detail::zeros;

struct Decimal {
    uint32_t digits;
    int decimals;  ///< the value is digits / 10^decimals
};

/// For floats of 24 bits times 2^exponent.
struct Scale {
    double power;  ///< 10^decimals, exact
    double half;   ///< half of the distance to the next float, times that: 1/2 to 5
    int decimals;
};
constexpr int leastExponent = -60;
constexpr std::array<Scale, -leastExponent> scales = [] {
    std::array<Scale, -leastExponent> all{};
    double unit = 1, power = 1;
    int decimals = 0;
    for (Scale& s : all) {  // exponents -1, -2, ...
        unit /= 2;
        while (unit * power < 1) {
            power *= 10;
            ++decimals;
        }
        s = {power, unit * power / 2, decimals};
    }
    return all;
}();

/// The nearest whole number; |x| < 2^51.
inline double rounded(double x)
{
    constexpr double large = 0x1.8p52;
    return x + large - large;
}

/// The shortest decimal of v > 0, perhaps with zeros at its end. False when it is too close to call.
inline bool shortest(float v, const Scale& scale, Decimal& d)
{
    constexpr double doubt = 1e-6;  // x is below 2^28, its rounding below 1e-7
    const double x = double(v) * scale.power, ten = 10 * rounded(x * 0.1), one = rounded(x);
    const double toTen = std::abs(ten - x) - scale.half, toOne = std::abs(one - x) - 0.5;
    const bool isTen = toTen < 0;
    d = {uint32_t(int32_t(isTen ? ten : one)), scale.decimals};
    return std::abs(toTen) > doubt && (isTen || toOne < -doubt);
}

/// In fixed notation or with an exponent, whichever is shorter.
inline char* putDecimal(char* to, Decimal d)
{
    // A ninth digit goes before the eight that fit a register, unless it can go from the end.
    if (d.digits >= tenToTheEighth && d.digits % 10 == 0) d = {d.digits / 10, d.decimals - 1};
    const uint32_t ninth = d.digits / tenToTheEighth;
    uint64_t eight = detail::eightDigits(d.digits - ninth * tenToTheEighth);
    int count = 9;
    if (!ninth) {
        const int before = std::countr_zero(eight ^ zeros) / 8, after = std::countl_zero(eight ^ zeros) / 8;
        eight = eight >> 8 * before | (before ? zeros << (64 - 8 * before) : 0);
        count = 8 - before - after;
        d.decimals -= after;
    }
    const int whole = count - d.decimals;  // digits before the point
    const int first = ninth ? 1 : 0;
    if (whole > 0 && -d.decimals <= 4 + (count > 1)) {
        *to = char('0' + ninth);
        put(to + first, eight);
        if (d.decimals <= 0) return to + whole;  // behind its digits `eight` has zeros
        to[whole] = '.';
        put(to + whole + 1, eight >> 8 * (whole - first));
        return to + count + 1;
    }
    if (whole <= 0 && d.decimals <= count + 2 + (count > 1)) {
        put(to, zeros);
        to[1] = '.';
        to += 2 - whole;
        *to = char('0' + ninth);
        put(to + first, eight);
        return to + count;
    }
    *to = char(ninth ? '0' + ninth : eight & 0xff);
    to[1] = '.';
    put(to + 2, ninth ? eight : eight >> 8);
    to += count + (count > 1);
    const int exponent = std::abs(whole - 1);
    const char text[4] = {'e', whole > 0 ? '+' : '-', char('0' + exponent / 10), char('0' + exponent % 10)};
    std::memcpy(to, text, 4);
    return to + 4;
}

}  // namespace

char* putNumber(char* to, float v)
{
    const uint32_t bits = std::bit_cast<uint32_t>(v), fraction = bits & 0x7fffff;
    const int exponent = int(bits >> 23 & 0xff) - 150;
    Decimal d;
    // A power of two is nearer to the float below than to the one above.
    if (exponent < leastExponent || exponent >= 0 || fraction == 0 || !shortest(std::abs(v), scales[size_t(-1 - exponent)], d))
        return std::to_chars(to, to + numberRoom, v).ptr;
    *to = '-';
    return putDecimal(to + (bits >> 31), d);
}

}  // namespace mw
