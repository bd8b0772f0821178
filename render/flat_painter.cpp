// The canvas with a graphics state of its own, beside the renderer's.
#include "render/flat_painter.h"

#include <algorithm>

#include "render/draw_context.h"
#include "render/heat_values.h"
#include "render/picture_target.h"

namespace mw {

struct FlatPainter::Impl {
    Offscreen& offscreen;
    GpuState gpu;
    Canvas canvas;
    PictureTarget target;

    explicit Impl(Offscreen& o) : offscreen(o) { makeHeatTable(gpu.heatTable); }
};

FlatPainter::FlatPainter(Offscreen& offscreen)
{
    offscreen.renderer();  // makes the context current
    impl_ = std::make_unique<Impl>(offscreen);
}

FlatPainter::~FlatPainter()
{
    impl_->offscreen.renderer();
}

Canvas& FlatPainter::canvas()
{
    return impl_->canvas;
}

Picture FlatPainter::draw(int width, int height)
{
    impl_->offscreen.renderer();
    Frame empty;
    empty.options.transparentBackground = true;
    return impl_->target.draw(
        [&](unsigned framebuffer, glm::ivec2 size) {
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            glViewport(0, 0, size.x, size.y);
            glBindVertexArray(impl_->gpu.vertexArray.id());
            glClearColor(0, 0, 0, 0);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            DrawContext c(impl_->gpu, empty, size);
            uploadFrameBlocks(c);
            impl_->canvas.flush(c);
            glBindVertexArray(0);
            glUseProgram(0);
        },
        0, width, height);
}

void overlay(Picture& under, const Picture& over, int left, int top)
{
    for (int y = std::max(0, -top); y < over.height && y + top < under.height; ++y) {
        for (int x = std::max(0, -left); x < over.width && x + left < under.width; ++x) {
            const uint8_t* a = &over.rgba[4 * (size_t(y) * size_t(over.width) + size_t(x))];
            uint8_t* b = &under.rgba[4 * (size_t(y + top) * size_t(under.width) + size_t(x + left))];
            for (int k = 0; k < 4; ++k) b[k] = uint8_t(std::min(255, a[k] + (b[k] * (255 - a[3]) + 127) / 255));
        }
    }
}

}  // namespace mw
