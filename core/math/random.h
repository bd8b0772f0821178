// Random numbers that are the same on every machine and with every library: the standard's distributions are not.
#pragma once
#include <cstdint>

namespace mw {

/// SplitMix64 (Steele, Lea, Flood 2014). Each call below draws exactly one number.
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}

    uint64_t next()
    {
        uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    /// Between 0 and 1, neither of them: a middle of 2^53 equal parts.
    double uniform() { return (double(next() >> 11) + 0.5) * 0x1p-53; }
    /// Of mean 0 and standard deviation 1.
    double normal();

private:
    uint64_t state_;
};

/// The number below which a normal deviate lies with probability p, 0 < p < 1; to 1e-15 of itself.
double normalQuantile(double p);

}  // namespace mw
