// Between the numbers of a screen (sRGB) and linear light, one channel from 0 to 1. IEC 61966-2-1.
#pragma once
#include <algorithm>
#include <cmath>

namespace mw {

/// Clamped to 0..1.
inline double srgbFromLinear(double v)
{
    v = std::clamp(v, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

inline double linearFromSrgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace mw
