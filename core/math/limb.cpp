#include "core/math/limb.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mw {

using glm::dvec3;

double distanceTo(const Limb& l, const dvec3& where)
{
    const dvec3 p = (where - l.a) / l.flat, ba = (l.b - l.a) / l.flat;
    const double least = std::min({l.flat.x, l.flat.y, l.flat.z});
    const double l2 = glm::dot(ba, ba);
    if (l2 == 0) return (glm::length(p) - l.ra) * least;
    // Round cone: Quilez, "Distance functions".
    const double rr = l.ra - l.rb, a2 = l2 - rr * rr, il2 = 1 / l2, y = glm::dot(p, ba), z = y - l2;
    const dvec3 across = p * l2 - ba * y;
    const double x2 = glm::dot(across, across), y2 = y * y * l2, z2 = z * z * l2, k = (rr < 0 ? -1 : 1) * rr * rr * x2;
    double d;
    if ((z < 0 ? -1 : 1) * a2 * z2 > k)
        d = std::sqrt(x2 + z2) * il2 - l.rb;
    else if ((y < 0 ? -1 : 1) * a2 * y2 < k)
        d = std::sqrt(x2 + y2) * il2 - l.ra;
    else
        d = (std::sqrt(x2 * a2 * il2) + y * rr) * il2 - l.ra;
    return d * least;
}

double blendedDistance(std::span<const Limb> limbs, const dvec3& p, double blend)
{
    double distances[64], least = 1e9;
    size_t n = 0;
    for (const Limb& l : limbs) least = std::min(least, distances[n++] = distanceTo(l, p));
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        if (const double beyond = (distances[i] - least) / blend; beyond < 30) sum += std::exp(-beyond);
    return least - blend * std::log(sum);
}

}  // namespace mw
