#include "core/math/rotations.h"

#include <cmath>

#include "core/math/hash.h"

namespace mw {

glm::dquat aboutAxis(int axis, double angle)
{
    glm::dquat q(std::cos(angle / 2), 0, 0, 0);
    (axis == 0 ? q.x : axis == 1 ? q.y : q.z) = std::sin(angle / 2);
    return q;
}

glm::dquat quaternionOf(const int axes[3], const double angles[3])
{
    return aboutAxis(axes[0], angles[0]) * aboutAxis(axes[1], angles[1]) * aboutAxis(axes[2], angles[2]);
}

glm::dquat slerp(const glm::dquat& a, glm::dquat b, double t)
{
    double cosine = glm::dot(a, b);
    if (cosine < 0) {
        b = -b;
        cosine = -cosine;
    }
    if (cosine > 1 - 1e-9) return glm::normalize(a * (1 - t) + b * t);
    const double angle = std::acos(cosine);
    return glm::normalize((a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / std::sin(angle));
}

size_t byteSize(const Rotations& r)
{
    size_t n = sizeof r;
    for (const Rotations::Path& p : r.paths) n += sizeof p + p.samples.size() * sizeof(Rotations::Sample);
    return n;
}

uint64_t contentHash(const Rotations& r)
{
    Hasher h;
    h.bytes(&r.from, sizeof r.from);
    h.bytes(&r.to, sizeof r.to);
    for (const Rotations::Path& p : r.paths) {
        h.text(p.name);
        h.array(std::span<const Rotations::Sample>(p.samples));
    }
    return h.value();
}

}  // namespace mw
