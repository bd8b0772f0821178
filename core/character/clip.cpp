#include "core/character/clip.h"

#include <algorithm>
#include <cmath>

#include "core/math/hash.h"
#include "core/math/rotations.h"

namespace mw {

namespace {

/// Keys come as `components` numbers, or three times as many (in-tangent, value, out-tangent).
const double* valueOf(const Channel& c, size_t key)
{
    const size_t k = size_t(c.components);
    return c.values.data() + (c.interpolation == Channel::Interpolation::Cubic ? (3 * key + 1) * k : key * k);
}

glm::dquat unit(const double* xyzw)
{
    const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = glm::length(q);
    return length > 0 ? q / length : glm::dquat(1, 0, 0, 0);
}

void put(const glm::dquat& q, double* xyzw)
{
    xyzw[0] = q.x;
    xyzw[1] = q.y;
    xyzw[2] = q.z;
    xyzw[3] = q.w;
}

/// Hermite's cubic between two keys; tangents are per second, so that they count times the distance of the keys (glTF 2.0, appendix C).
void hermite(const Channel& c, size_t key, double s, double* out)
{
    const size_t k = size_t(c.components);
    const double distance = c.times[key + 1] - c.times[key], s2 = s * s, s3 = s2 * s;
    const double *v0 = valueOf(c, key), *out0 = v0 + k, *v1 = valueOf(c, key + 1), *in1 = v1 - k;
    for (size_t i = 0; i < k; ++i)
        out[i] = (2 * s3 - 3 * s2 + 1) * v0[i] + distance * (s3 - 2 * s2 + s) * out0[i] + (3 * s2 - 2 * s3) * v1[i] + distance * (s3 - s2) * in1[i];
}

/// Between key and key + 1, a part `s` of the way.
void between(const Channel& c, size_t key, double s, double* out)
{
    if (c.interpolation == Channel::Interpolation::Cubic) return hermite(c, key, s, out);
    const double *a = valueOf(c, key), *b = valueOf(c, key + 1);
    if (c.path == Channel::Path::Rotation) return put(slerp(unit(a), unit(b), s), out);
    for (int i = 0; i < c.components; ++i) out[i] = a[i] + (b[i] - a[i]) * s;
}

int axisOf(Channel::Path path, Channel::Path ofX)
{
    return int(path) - int(ofX);
}

}  // namespace

double duration(const Clip& c)
{
    double last = 0;
    for (const auto& channel : c.channels)
        if (channel->keys()) last = std::max(last, channel->times[channel->keys() - 1]);
    return last;
}

size_t keyCount(const Clip& c)
{
    size_t n = 0;
    for (const auto& channel : c.channels) n += channel->keys();
    return n;
}

size_t byteSize(const Clip& c)
{
    size_t n = sizeof c;
    for (const auto& channel : c.channels) n += sizeof(Channel) + channel->values.bytes();
    return n;
}

uint64_t contentHash(const Clip& c)
{
    Hasher h;
    h.text(c.name);
    h.bytes(&c.frameTime, sizeof c.frameTime);
    for (const auto& channel : c.channels) {
        h.number(channel->node.value);
        h.number(uint64_t(channel->path) << 16 | uint64_t(channel->interpolation) << 8 | uint64_t(channel->components));
        h.array(channel->times.span());
        h.array(channel->values.span());
    }
    return h.value();
}

void sample(const Channel& c, double time, double* out)
{
    if (c.keys() == 0) return;
    const double* next = std::upper_bound(c.times.begin(), c.times.end(), time);  // of equal times the later key counts
    const size_t after = size_t(next - c.times.begin());
    const bool onKey = after > 0 && c.times[after - 1] == time;  // gives its very bits, also of a negative zero
    if (onKey || after == 0 || after == c.keys() || c.interpolation == Channel::Interpolation::Step) {
        std::copy_n(valueOf(c, after == 0 ? 0 : after - 1), c.components, out);
    } else {
        const double from = c.times[after - 1];
        between(c, after - 1, (time - from) / (*next - from), out);
    }
    if (c.path == Channel::Path::Rotation) put(unit(out), out);
}

Transform sampled(const Transform& rest, std::span<const Channel* const> channels, double time)
{
    using Path = Channel::Path;
    Transform t = rest;
    bool turned = false;
    for (const Channel* c : channels) {
        if (c->keys() == 0 || c->path == Path::Weights) continue;
        double v[4];
        sample(*c, time, v);
        if (c->path == Path::Translation) {
            t.translation = {v[0], v[1], v[2]};
        } else if (c->path == Path::Rotation) {
            t.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
        } else if (c->path == Path::Scale) {
            t.scale = {v[0], v[1], v[2]};
        } else if (c->path <= Path::PositionZ) {
            t.translation[axisOf(c->path, Path::PositionX)] += v[0];
        } else {
            const glm::dquat q = aboutAxis(axisOf(c->path, Path::EulerX), glm::radians(v[0]));
            t.rotation = turned ? t.rotation * q : q;
            turned = true;
        }
    }
    return t;
}

}  // namespace mw
