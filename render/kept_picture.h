// What lies beneath marks and labels, kept: while scene, camera and size stay, following the pointer draws marks alone, however large the meshes.
#pragma once
#include "render/draw_context.h"

namespace mw {

class KeptPicture {
public:
    /// Puts what was kept, and its counts, into the target; false when that is of something else.
    bool restore(DrawContext& c, unsigned target);
    /// Copies the target, when the frame says by what it is known again and is not as soon drawn anew.
    void keep(const DrawContext& c, unsigned target);

private:
    bool resize(unsigned target, glm::ivec2 size);
    void copy(unsigned from, unsigned to) const;

    gl::Framebuffer framebuffer_;
    gl::Renderbuffer color_, depth_;
    glm::ivec2 size_{0};
    GLint samples_ = -1;
    uint64_t scene_ = 0;  // 0: nothing is kept
    Camera camera_;
    Renderer::Counts counts_;
};

}  // namespace mw
