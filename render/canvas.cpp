// Items of the canvas as instances of one quad.
#include "render/canvas.h"

#include <cmath>
#include <cstddef>

#include "render/draw_context.h"

namespace mw {
namespace {

enum Kind { boxKind, letterKind, strokeKind, barKind, quadKind };

}  // namespace

void Canvas::box(glm::vec2 low, glm::vec2 high, glm::vec4 fill, float radius, float borderWidth, glm::vec4 border)
{
    items_.push_back({{low, high}, fill, border, {float(boxKind), radius, borderWidth, 0}, {}});
}

void Canvas::disc(glm::vec2 centre, float radius, glm::vec4 fill, float borderWidth, glm::vec4 border)
{
    box(centre - radius, centre + radius, fill, radius, borderWidth, border);
}

void Canvas::quad(const std::array<glm::vec2, 4>& p, glm::vec4 fill, float grow)
{
    items_.push_back({{p[0], p[1]}, fill, {}, {float(quadKind), grow, 0, 0}, {p[2], p[3]}});
}

void Canvas::stroke(glm::vec2 from, glm::vec2 to, float width, glm::vec4 color)
{
    items_.push_back({{from, to}, color, {}, {float(strokeKind), 0.5f * width, 0, 0}, {}});
}

void Canvas::colorBar(glm::vec2 low, glm::vec2 high, int heatRow, float from, float to)
{
    items_.push_back({{low, high}, glm::vec4(1), {}, {float(barKind), 0, 0, float(heatRow)}, {from, 0, to, 0}});
}

float Canvas::text(glm::vec2 at, std::string_view utf8, int pixels, glm::vec4 color, bool bold, Align align)
{
    const float whole = atlas_.width(utf8, pixels, bold);
    glm::vec2 pen(std::round(at.x - (align == Align::Right ? whole : align == Align::Centre ? 0.5f * whole : 0.f)), std::round(at.y));
    while (!utf8.empty()) {
        const Glyph* g = atlas_.glyph(nextLetter(utf8), pixels, bold);
        if (!g) continue;
        const glm::vec2 low(std::round(pen.x) + float(g->left), pen.y - float(g->top)), extent(g->width, g->height);
        const glm::vec2 texel(g->x, g->y);
        if (g->width > 0) items_.push_back({{low, low + extent}, color, {}, {float(letterKind), 0, 0, 0}, {texel, texel + extent}});
        pen.x += g->advance;
    }
    return whole;
}

void Canvas::flush(DrawContext& c)
{
    if (items_.empty()) return;
    const GLuint letters = atlas_.texture();
    glDisable(GL_DEPTH_TEST);
    c.blend();
    c.use(ProgramId::Canvas);
    c.texture(atlasUnit, GL_TEXTURE_2D, letters);
    c.texture(heatUnit, GL_TEXTURE_2D, c.gpu.heatTable.get());
    gl::stream(buffer_, std::span<const Item>(items_));
    c.clearAttributes();
    for (GLuint i = 0; i < 5; ++i) gl::attribute({i, buffer_.get(), 4, sizeof(Item), i * sizeof(glm::vec4), 1});
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(items_.size()));
    items_.clear();
}

}  // namespace mw
