// Flat drawing in device pixels over the picture: boxes, strokes, letters, the colour bar. All of it is one draw, in the order it was put.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "render/glyph_atlas.h"

namespace mw {

struct DrawContext;

class Canvas {
public:
    /// Corners low and high, from the top left.
    void box(glm::vec2 low, glm::vec2 high, glm::vec4 fill, float radius = 0, float borderWidth = 0, glm::vec4 border = {});
    void disc(glm::vec2 centre, float radius, glm::vec4 fill, float borderWidth = 0, glm::vec4 border = {});
    /// A convex one, grown by so many pixels.
    void quad(const std::array<glm::vec2, 4>& corners, glm::vec4 fill, float grow);
    void stroke(glm::vec2 from, glm::vec2 to, float width, glm::vec4 color);
    /// Colours of a row of the heat table from `from` to `to` (0 to 1).
    void colorBar(glm::vec2 low, glm::vec2 high, int heatRow, float from = 0, float to = 1);

    enum class Align { Left, Centre, Right };
    /// `at` is on the baseline. Returns the width.
    float text(glm::vec2 at, std::string_view utf8, int pixels, glm::vec4 color, bool bold = false, Align align = Align::Left);
    float width(std::string_view utf8, int pixels, bool bold = false) { return atlas_.width(utf8, pixels, bold); }

    /// Draws what was put and forgets it.
    void flush(DrawContext& c);

private:
    struct Item {
        glm::vec4 box, fill, border, shape, texels;
    };
    std::vector<Item> items_;
    GlyphAtlas atlas_;
    gl::Buffer buffer_;
};

}  // namespace mw
