#include "render/picture_target.h"

#include <algorithm>

#include "core/error.h"
#include "render/gl.h"

namespace mw {
namespace {

/// A colour and a depth buffer of some samples.
struct Target {
    gl::Framebuffer framebuffer;
    gl::Renderbuffer color, depth;
    int width = 0, height = 0, samples = -1;

    void resize(int w, int h, int s)
    {
        if (w == width && h == height && s == samples) return;
        width = w, height = h, samples = s;
        glBindRenderbuffer(GL_RENDERBUFFER, color.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, s, GL_RGBA8, w, h);
        glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, s, GL_DEPTH24_STENCIL8, w, h);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.get());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth.get());
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw Error("the graphics driver cannot make a picture of " + std::to_string(w) + " x " + std::to_string(h) +
                        " pixels; take a smaller size");
    }
};

Picture readBack(int width, int height)
{
    Picture p{width, height, std::vector<uint8_t>(size_t(width) * size_t(height) * 4)};
    const size_t row = size_t(width) * 4;
    std::vector<uint8_t> below(p.rgba.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, below.data());
    for (size_t y = 0; y < size_t(height); ++y) std::copy_n(below.data() + (size_t(height) - 1 - y) * row, row, p.rgba.data() + y * row);
    return p;
}

}  // namespace

struct PictureTarget::Impl {
    Target drawn, resolved;
};

PictureTarget::PictureTarget() : impl_(std::make_unique<Impl>()) {}

PictureTarget::~PictureTarget() = default;

Picture PictureTarget::draw(Renderer& renderer, const Frame& frame, int width, int height)
{
    return draw([&](unsigned framebuffer, glm::ivec2 size) { renderer.draw(frame, framebuffer, size); }, frame.options.samples, width, height);
}

Picture PictureTarget::draw(const std::function<void(unsigned framebuffer, glm::ivec2 size)>& into, int wantedSamples, int width, int height)
{
    GLint most = 0, mostSamples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
    if (width < 1 || height < 1 || width > most || height > most)
        throw Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels cannot be drawn; each side may have 1 to " +
                    std::to_string(most));
    const int samples = std::clamp(wantedSamples, 0, int(mostSamples));
    impl_->drawn.resize(width, height, samples > 1 ? samples : 0);
    into(impl_->drawn.framebuffer.get(), {width, height});
    GLuint readFrom = impl_->drawn.framebuffer.get();
    if (samples > 1) {
        impl_->resolved.resize(width, height, 0);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, readFrom);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->resolved.framebuffer.get());
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        readFrom = impl_->resolved.framebuffer.get();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, readFrom);
    return readBack(width, height);
}

}  // namespace mw
