// Keeping, finding and letting go of arrays on the graphics card.
#include "render/gpu_cache.h"

#include <vector>

namespace mw {
namespace {

constexpr uint64_t unownedFrames = 8;            // what belongs to nobody (marks) goes when it was not drawn for so long
constexpr GLenum makingUnit = GL_TEXTURE0 + 15;  // textures are made here, so that none a pass has bound is pushed out

}  // namespace

bool GpuCache::Entry::alive() const
{
    for (size_t i = 0; i < owners.size(); ++i)
        if (owned[i] && owners[i].expired()) return false;
    return true;
}

void GpuCache::beginFrame()
{
    ++frame_;
    uploaded_ = 0;
    std::erase_if(entries_, [&](const auto& e) {
        const bool owned = e.second.owned[0] || e.second.owned[1] || e.second.owned[2];
        if (e.second.alive() && (owned || e.second.lastUse + unownedFrames >= frame_)) return false;
        bytes_ -= e.second.bytes;
        return true;
    });
    while (bytes_ > keepBytes) {
        auto oldest = entries_.end();
        for (auto i = entries_.begin(); i != entries_.end(); ++i)
            if (i->second.lastUse + 2 < frame_ && (oldest == entries_.end() || i->second.lastUse < oldest->second.lastUse)) oldest = i;
        if (oldest == entries_.end()) return;  // all of it is on screen
        bytes_ -= oldest->second.bytes;
        entries_.erase(oldest);
    }
}

size_t GpuCache::bytesOf(const GpuKey& key) const
{
    const auto i = entries_.find(key);
    return i == entries_.end() ? 0 : i->second.bytes;
}

GpuCache::Entry* GpuCache::find(const GpuKey& key)
{
    const auto i = entries_.find(key);
    if (i == entries_.end() || !i->second.alive()) return nullptr;
    i->second.lastUse = frame_;
    return &i->second;
}

GpuCache::Entry& GpuCache::add(const GpuKey& key, const Owners& owners, size_t bytes)
{
    Entry& e = entries_[key];
    bytes_ += bytes - e.bytes;
    e = Entry();
    for (size_t i = 0; i < owners.size(); ++i) {
        e.owners[i] = owners[i];
        e.owned[i] = owners[i] != nullptr;
    }
    e.bytes = bytes;
    e.lastUse = frame_;
    uploaded_ += bytes;
    return e;
}

GLuint GpuCache::bufferTexture(const GpuKey& key, GLenum format)
{
    Entry* e = find(key);
    if (!e) return 0;
    if (!e->texture) {
        glActiveTexture(makingUnit);
        glBindTexture(GL_TEXTURE_BUFFER, e->texture.id());
        glTexBuffer(GL_TEXTURE_BUFFER, format, e->buffer.get());
    }
    return e->texture.get();
}

GLuint GpuCache::picture(const GpuKey& key, const Owners& owners, const std::function<size_t()>& make)
{
    if (Entry* e = find(key)) return e->texture.get();
    Entry& e = add(key, owners, 0);
    glActiveTexture(makingUnit);
    glBindTexture(GL_TEXTURE_2D, e.texture.id());
    e.bytes = make();
    bytes_ += e.bytes;
    uploaded_ += e.bytes;
    return e.texture.get();
}

}  // namespace mw
