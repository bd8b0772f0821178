// Arrays on the graphics card, kept as long as their originals live: an array is known by its address, so whatever has not changed is
// never sent twice.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "core/mesh/array.h"
#include "render/gl.h"

namespace mw {

/// What a buffer was made of, and for what.
struct GpuKey {
    std::array<const void*, 3> from{};
    uint64_t use = 0;
    auto operator<=>(const GpuKey&) const = default;
};
using Owners = std::array<std::shared_ptr<const void>, 3>;

class GpuCache {
public:
    /// Forgets buffers whose originals are gone, and, beyond `keepBytes`, those that were not drawn for longest.
    void beginFrame();

    template <class T>
    GLuint buffer(const Shared<T>& a)
    {
        if (a.empty()) return 0;
        return buffer({{a.id()}, 0}, {a.owner()}, [&] { return std::as_bytes(a.span()); });
    }
    /// A buffer computed from others; `make` is called when it is not there yet and gives a contiguous range of plain values.
    template <class Make>
    GLuint made(const GpuKey& key, const Owners& owners, Make make)
    {
        return buffer(key, owners, [&, kept = decltype(make()){}]() mutable {
            kept = make();
            return std::as_bytes(std::span(kept.data(), kept.size()));
        });
    }
    size_t bytesOf(const GpuKey& key) const;
    /// A texture that shaders read a buffer through.
    GLuint bufferTexture(const GpuKey& key, GLenum format);
    /// A picture made once; `make` fills the bound 2D texture and says how many bytes it took.
    GLuint picture(const GpuKey& key, const Owners& owners, const std::function<size_t()>& make);

    size_t uploadedBytes() const { return uploaded_; }      ///< since beginFrame()
    void countUpload(size_t bytes) { uploaded_ += bytes; }  ///< of buffers kept elsewhere
    size_t bytes() const { return bytes_; }
    size_t keepBytes = size_t(1) << 30;

private:
    struct Entry {
        gl::Buffer buffer;
        gl::Texture texture;
        std::array<std::weak_ptr<const void>, 3> owners;
        std::array<bool, 3> owned{};
        size_t bytes = 0;
        uint64_t lastUse = 0;
        bool alive() const;
    };
    Entry* find(const GpuKey& key);
    Entry& add(const GpuKey& key, const Owners& owners, size_t bytes);
    template <class Bytes>
    GLuint buffer(const GpuKey& key, const Owners& owners, Bytes bytes)
    {
        if (Entry* e = find(key)) return e->buffer.get();
        const std::span<const std::byte> data = bytes();
        Entry& e = add(key, owners, data.size());
        glBindBuffer(GL_COPY_WRITE_BUFFER, e.buffer.id());
        glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(data.size()), data.data(), GL_STATIC_DRAW);
        return e.buffer.get();
    }

    std::map<GpuKey, Entry> entries_;
    uint64_t frame_ = 0;
    size_t uploaded_ = 0, bytes_ = 0;
};

}  // namespace mw
