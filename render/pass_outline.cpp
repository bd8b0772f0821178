// The outline of selected objects.
#include <algorithm>
#include <cmath>

#include "render/draw_context.h"

namespace mw {
namespace {

struct Box {
    glm::ivec2 low, high;  // pixels from the bottom left; high is outside
};

/// Pixels that outlined objects may cover; all of them when one reaches behind the eye.
Box outlinedBox(const DrawContext& c, double pixels)
{
    glm::dvec2 low(1e9), high(-1e9);
    std::vector<std::pair<Bounds, glm::dmat4>> outlined;
    for (const DrawObject& o : c.frame.objects)
        if (o.selected || o.hovered) outlined.emplace_back(worldBounds(o), glm::dmat4(1));
    for (const DrawTerrain& t : c.frame.terrains)
        if (t.selected || t.hovered) outlined.emplace_back(boundsOf(t.terrain), t.worldFromLocal);
    for (const auto& [b, worldFromLocal] : outlined) {
        if (b.empty) continue;
        const glm::dmat4 clip = c.clipFromView * c.viewFromWorld * worldFromLocal;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec4 p = clip * glm::dvec4(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1);
            if (p.w <= c.camera.nearClip * 0.5 && c.camera.perspective) return {{0, 0}, c.size};
            const glm::dvec2 pixel = (glm::dvec2(p) / p.w * 0.5 + 0.5) * glm::dvec2(c.size);
            low = glm::min(low, pixel);
            high = glm::max(high, pixel);
        }
    }
    const double margin = pixels * c.frame.options.pixelRatio;
    low = glm::clamp(low - margin, glm::dvec2(0), glm::dvec2(c.size));
    high = glm::clamp(high + margin, glm::dvec2(0), glm::dvec2(c.size));
    return {glm::ivec2(glm::floor(low)), glm::ivec2(glm::ceil(high))};
}

void copyMask(DrawContext& c, unsigned target, const Box& box)
{
    GpuState& gpu = c.gpu;
    if (gpu.maskSize != c.size) {
        gpu.maskSize = c.size;
        glBindTexture(GL_TEXTURE_2D, gpu.mask.id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, c.size.x, c.size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glBindFramebuffer(GL_FRAMEBUFFER, gpu.maskFramebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, gpu.mask.get(), 0);
    }
    // A multisampled picture can only be copied onto the same rectangle.
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, gpu.maskFramebuffer.get());
    glBlitFramebuffer(box.low.x, box.low.y, box.high.x, box.high.y, box.low.x, box.low.y, box.high.x, box.high.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
}

}  // namespace

void drawOutlines(DrawContext& c, unsigned target)
{
    if (c.frame.options.transparentBackground) return;  // there alpha says what is covered
    const auto outlined = [](const auto& o) { return o.selected || o.hovered; };
    if (std::none_of(c.frame.objects.begin(), c.frame.objects.end(), outlined) &&
        std::none_of(c.frame.terrains.begin(), c.frame.terrains.end(), outlined))
        return;
    const Box box = outlinedBox(c, 4);
    if (box.low.x >= box.high.x || box.low.y >= box.high.y) return;
    copyMask(c, target, outlinedBox(c, 9));  // more than is looked at
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
    glDisable(GL_DEPTH_TEST);
    c.blend();
    c.use(ProgramId::Outline);
    c.clearAttributes();
    c.texture(maskUnit, GL_TEXTURE_2D, c.gpu.mask.get());
    const auto isSelected = [](const auto& o) { return o.selected; };
    const bool selected = std::any_of(c.frame.objects.begin(), c.frame.objects.end(), isSelected) ||
                          std::any_of(c.frame.terrains.begin(), c.frame.terrains.end(), isSelected);
    ObjectBlock block;
    block.ids.x = selected;
    c.setObject(block);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace mw
