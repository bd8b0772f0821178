// Normal deviates by inversion, with arithmetic alone: no function of the mathematical library, whose last digits differ.
#include "core/math/random.h"

#include <bit>
#include <cmath>

namespace mw {

namespace {

/// sum of c[i] r^i, highest first.
template <int N>
double polynomial(const double (&c)[N], double r)
{
    double sum = c[0];
    for (int i = 1; i < N; ++i) sum = sum * r + c[i];
    return sum;
}

/// Natural logarithm of a normal positive number: x = m 2^e with m near 1, log m = 2 artanh((m-1)/(m+1)).
double logarithm(double x)
{
    const auto bits = std::bit_cast<uint64_t>(x);
    int exponent = int(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
    if (m > 1.4142135623730951) m *= 0.5, ++exponent;
    const double s = (m - 1) / (m + 1), square = s * s;
    double sum = 0;
    for (int k = 27; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
    return 2 * s * sum + exponent * 0.69314718055994530942;
}

// Algorithm AS 241 (Wichura 1988), PPND16.
constexpr double middleOver[] = {2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457,
                                 13731.693765509461125, 1971.5909503065514427, 133.14166789178437745, 3.387132872796366608};
constexpr double middleUnder[] = {5226.495278852545925,  28729.085735721942674, 39307.89580009271061,  21213.794301586595867,
                                  5394.1960214247511077, 687.1870074920579083,  42.313330701600911252, 1.0};
constexpr double tailOver[] = {7.7454501427834140764e-4, .0227238449892691845833, .24178072517745061177, 1.27045825245236838258,
                               3.64784832476320460504,   5.7694972214606914055,   4.6303378461565452959, 1.42343711074968357734};
constexpr double tailUnder[] = {1.05075007164441684324e-9, 5.475938084995344946e-4, .0151986665636164571966, .14810397642748007459,
                                .68976733498510000455,     1.6763848301838038494,   2.05319162663775882187,  1.0};
constexpr double farOver[] = {2.01033439929228813265e-7, 2.71155556874348757815e-5, .0012426609473880784386, .026532189526576123093,
                              .29656057182850489123,     1.7848265399172913358,     5.4637849111641143699,   6.6579046435011037772};
constexpr double farUnder[] = {2.04426310338993978564e-15, 1.4215117583164458887e-7, 1.8463183175100546818e-5, 7.868691311456132591e-4,
                               .0148753612908506148525,    .13692988092273580531,    .59983220655588793769,    1.0};

}  // namespace

double normalQuantile(double p)
{
    const double q = p - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(middleOver, r) / polynomial(middleUnder, r);
    }
    const double r = std::sqrt(-logarithm(q < 0 ? p : 1 - p));
    const double x =
        r <= 5 ? polynomial(tailOver, r - 1.6) / polynomial(tailUnder, r - 1.6) : polynomial(farOver, r - 5) / polynomial(farUnder, r - 5);
    return q < 0 ? -x : x;
}

double Random::normal()
{
    return normalQuantile(uniform());
}

}  // namespace mw
