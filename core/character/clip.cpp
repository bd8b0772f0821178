#include "core/character/clip.h"

#include <algorithm>

#include "core/math/hash.h"

namespace mw {

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

}  // namespace mw
