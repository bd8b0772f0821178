// OpenGL objects that free themselves. All need a current context, to be made and to be destroyed.
#pragma once
#include <epoxy/gl.h>
#include <span>
#include <utility>

namespace mw::gl {

/// Owns one name; Traits make and delete it.
template <class Traits>
class Handle {
public:
    Handle() = default;
    Handle(Handle&& o) noexcept : id_(std::exchange(o.id_, 0)) {}
    Handle& operator=(Handle&& o) noexcept
    {
        std::swap(id_, o.id_);
        return *this;
    }
    ~Handle()
    {
        if (id_) Traits::destroy(id_);
    }
    /// Makes it on first use.
    GLuint id()
    {
        if (!id_) id_ = Traits::create();
        return id_;
    }
    GLuint get() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    GLuint id_ = 0;
};

struct BufferTraits {
    static GLuint create()
    {
        GLuint i = 0;
        glGenBuffers(1, &i);
        return i;
    }
    static void destroy(GLuint i) { glDeleteBuffers(1, &i); }
};
struct TextureTraits {
    static GLuint create()
    {
        GLuint i = 0;
        glGenTextures(1, &i);
        return i;
    }
    static void destroy(GLuint i) { glDeleteTextures(1, &i); }
};
struct VertexArrayTraits {
    static GLuint create()
    {
        GLuint i = 0;
        glGenVertexArrays(1, &i);
        return i;
    }
    static void destroy(GLuint i) { glDeleteVertexArrays(1, &i); }
};
struct FramebufferTraits {
    static GLuint create()
    {
        GLuint i = 0;
        glGenFramebuffers(1, &i);
        return i;
    }
    static void destroy(GLuint i) { glDeleteFramebuffers(1, &i); }
};
struct RenderbufferTraits {
    static GLuint create()
    {
        GLuint i = 0;
        glGenRenderbuffers(1, &i);
        return i;
    }
    static void destroy(GLuint i) { glDeleteRenderbuffers(1, &i); }
};

using Buffer = Handle<BufferTraits>;
using Texture = Handle<TextureTraits>;
using VertexArray = Handle<VertexArrayTraits>;
using Framebuffer = Handle<FramebufferTraits>;
using Renderbuffer = Handle<RenderbufferTraits>;

/// One attribute of floats out of a buffer, into the bound vertex array.
struct Attribute {
    GLuint location = 0, buffer = 0;
    GLint components = 3;
    GLsizei stride = 0;
    size_t offset = 0;
    GLuint divisor = 0;
};
void attribute(const Attribute& a);

/// A uniform block, bound.
template <class Block>
void uploadBlock(Buffer& buffer, GLuint point, const Block& block)
{
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, point, buffer.get());
}

/// Replaces the content of a buffer that changes every frame.
template <class T>
void stream(Buffer& buffer, std::span<const T> data, GLenum target = GL_ARRAY_BUFFER)
{
    glBindBuffer(target, buffer.id());
    glBufferData(target, GLsizeiptr(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

}  // namespace mw::gl
