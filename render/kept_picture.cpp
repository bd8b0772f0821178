#include "render/kept_picture.h"

namespace mw {
namespace {

constexpr size_t worthKeeping = 100'000;  // triangles; fewer are drawn about as soon as they are copied

GLint samplesOf(unsigned target)
{
    GLint samples = 0;
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glGetIntegerv(GL_SAMPLES, &samples);
    return samples;
}

/// Depth can only be copied between buffers of the same format.
bool depthIsAsOurs(unsigned target)
{
    const auto bits = [](GLenum attachment, GLenum what) {
        GLint type = GL_NONE, n = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
        if (type != GL_NONE) glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, what, &n);
        return n;
    };
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    return bits(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) == 24 &&
           bits(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) == 8;
}

}  // namespace

bool KeptPicture::resize(unsigned target, glm::ivec2 size)
{
    const GLint samples = samplesOf(target);
    if (size == size_ && samples == samples_) return true;
    glBindRenderbuffer(GL_RENDERBUFFER, color_.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.x, size.y);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, size.x, size.y);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
    size_ = size;
    samples_ = samples;
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void KeptPicture::copy(unsigned from, unsigned to) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void KeptPicture::keep(const DrawContext& c, unsigned target)
{
    if (c.frame.scene == 0 || c.counts.triangles < worthKeeping || target == 0 || !depthIsAsOurs(target) || !resize(target, c.size)) {
        *this = {};
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        return;
    }
    copy(target, framebuffer_.get());
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    scene_ = c.frame.scene;
    camera_ = c.camera;
    counts_ = c.counts;
}

bool KeptPicture::restore(DrawContext& c, unsigned target)
{
    if (scene_ == 0 || c.frame.scene != scene_ || c.size != size_ || c.camera != camera_ || samplesOf(target) != samples_) return false;
    copy(framebuffer_.get(), target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    c.counts = counts_;
    c.counts.kept = true;
    return true;
}

}  // namespace mw
