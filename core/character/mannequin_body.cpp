// The body as the zero set of a field of distances to blended limbs, meshed by a surface net. Left and right are the same to the last bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/character/mannequin.h"
#include "core/math/limb.h"
#include "core/mesh/surface_net.h"

namespace mw {

namespace {

using glm::dvec3;

/// Of the left half; the right one is its mirror.
const std::vector<Limb>& limbs()
{
    static const std::vector<Limb> all = [] {
        std::vector<Limb> l{
            // head: skull, jaw, nose; neck
            {{0, 1.655, -0.014}, {0, 1.660, 0.012}, 0.082, 0.078, {0.92, 1.06, 1.08}},
            {{0, 1.645, 0.008}, {0, 1.580, 0.022}, 0.074, 0.053, {0.92, 1, 1}},
            {{0, 1.640, 0.088}, {0, 1.622, 0.090}, 0.004, 0.008},
            {{0, 1.44, -0.020}, {0, 1.57, -0.006}, 0.050, 0.046},
            {{0.018, 1.505, -0.030}, {0.115, 1.425, -0.022}, 0.036, 0.034},
            // trunk: shoulder girdle, ribs, waist, pelvis
            {{0, 1.415, -0.018}, {0.135, 1.402, -0.018}, 0.062, 0.048, {1, 1, 1}},
            {{0, 1.31, -0.004}, {0.066, 1.315, -0.006}, 0.110, 0.098, {1, 1.1, 0.80}},
            {{0, 1.22, 0.002}, {0.050, 1.22, 0}, 0.098, 0.090, {1, 1.1, 0.80}},
            {{0, 1.10, 0.004}, {0.042, 1.10, 0.002}, 0.086, 0.078, {1, 1.2, 0.82}},
            {{0, 1.045, 0.002}, {0.050, 1.035, 0.000}, 0.086, 0.078, {1, 1.2, 0.84}},
            {{0, 0.985, 0.000}, {0.064, 0.950, -0.002}, 0.090, 0.088, {1, 1.1, 0.88}},
            {{0.066, 0.905, -0.034}, {0.068, 0.945, -0.026}, 0.070, 0.068},
            {{0.064, 1.325, 0.038}, {0.085, 1.335, 0.034}, 0.052, 0.046, {1, 1, 0.8}},
            // leg
            {{0.093, 0.90, 0.002}, {0.100, 0.52, 0.006}, 0.078, 0.050},
            {{0.100, 0.52, 0.010}, {0.101, 0.475, 0.008}, 0.047, 0.043},
            {{0.102, 0.40, -0.014}, {0.104, 0.33, -0.012}, 0.048, 0.042},
            {{0.101, 0.49, 0.002}, {0.105, 0.10, -0.004}, 0.044, 0.031},
            // foot: heel, instep, ball, toes
            {{0.105, 0.034, -0.040}, {0.105, 0.060, -0.012}, 0.033, 0.034},
            {{0.105, 0.075, 0.000}, {0.100, 0.034, 0.110}, 0.034, 0.026},
            {{0.104, 0.030, -0.010}, {0.122, 0.026, 0.105}, 0.030, 0.025},
            {{0.086, 0.024, 0.130}, {0.092, 0.018, 0.186}, 0.023, 0.018},
            {{0.108, 0.023, 0.130}, {0.112, 0.017, 0.182}, 0.021, 0.017},
            {{0.128, 0.022, 0.120}, {0.130, 0.016, 0.164}, 0.020, 0.015},
        };
        // The arm, along its own line from the shoulder: t along, s to the palm, z.
        const dvec3 shoulder(0.172, 1.405, -0.018), along(std::sqrt(0.5), -std::sqrt(0.5), 0), palm(-std::sqrt(0.5), -std::sqrt(0.5), 0);
        const auto at = [&](double t, double s, double z) { return shoulder + along * t + palm * s + dvec3(0, 0, z); };
        for (const Limb& piece : {
                 Limb{at(-0.012, 0, 0), at(0.05, 0, 0), 0.055, 0.050},
                 Limb{at(0.04, 0, 0), at(0.28, 0, -0.002), 0.047, 0.037},
                 Limb{at(0.13, 0.004, 0.008), at(0.18, 0.002, 0.006), 0.041, 0.038},
                 Limb{at(0.28, 0, -0.002), at(0.53, 0, 0.004), 0.038, 0.024},
                 Limb{at(0.33, 0.002, 0), at(0.38, 0.002, 0), 0.040, 0.035},
                 Limb{at(0.53, 0, 0.004), at(0.56, 0, 0.006), 0.025, 0.024},
                 // hand: palm, fingers held together, thumb
                 Limb{at(0.550, 0.002, 0.018), at(0.615, 0.004, 0.027), 0.019, 0.017},
                 Limb{at(0.550, 0.002, -0.004), at(0.615, 0.004, -0.015), 0.019, 0.017},
                 Limb{at(0.600, 0.004, 0.006), at(0.620, 0.004, 0.006), 0.017, 0.017},
                 Limb{at(0.615, 0.004, 0.028), at(0.694, 0.014, 0.024), 0.0150, 0.0125},
                 Limb{at(0.620, 0.004, 0.006), at(0.708, 0.015, 0.006), 0.0155, 0.0125},
                 Limb{at(0.615, 0.004, -0.015), at(0.686, 0.014, -0.012), 0.0150, 0.0120},
                 Limb{at(0.550, 0.006, 0.024), at(0.592, 0.020, 0.053), 0.0175, 0.0140},
                 Limb{at(0.592, 0.020, 0.053), at(0.628, 0.028, 0.062), 0.0140, 0.0120},
             })
            l.push_back(piece);
        return l;
    }();
    return all;
}

/// All limbs blended: the smooth minimum by exponentials does not depend on their order. The soles are flat.
double field(dvec3 p)
{
    constexpr double blend = 0.011;
    p.x = std::abs(p.x);
    const double body = blendedDistance(limbs(), p, blend), below = -p.y;
    constexpr double edge = 0.006;
    const double h = std::max(edge - std::abs(body - below), 0.0) / edge;
    return std::max(body, below) + h * h * edge / 4;
}

/// Grid lines: finer where hands and feet are. Symmetric about 0 when `mirrored`.
std::vector<double> lines(std::initializer_list<std::array<double, 2>> untilWithStep, double from, bool mirrored)
{
    std::vector<double> at{from};
    for (const auto& [until, step] : untilWithStep) {
        const double begin = at.back();
        const int n = std::max(1, int(std::lround((until - begin) / step)));
        for (int i = 1; i <= n; ++i) at.push_back(begin + (until - begin) * i / n);
    }
    if (!mirrored) return at;
    std::vector<double> both;
    for (size_t i = at.size() - 1; i > 0; --i) both.push_back(-at[i]);
    both.insert(both.end(), at.begin(), at.end());
    return both;
}

NetLines grid()
{
    return {lines({{0.20, 0.0182}, {0.52, 0.0178}, {0.72, 0.0130}}, 0, true),
            lines({{0.09, 0.0125}, {0.84, 0.0225}, {1.06, 0.0150}, {1.80, 0.0185}}, -0.021, false), lines({{0.23, 0.0164}}, -0.160, false)};
}

}  // namespace

Mesh mannequinBody()
{
    return mirroredSurfaceNet(grid(), field);
}

}  // namespace mw
