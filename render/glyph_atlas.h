// Letters as pixels in one texture, made when first needed from the system's sans-serif font (fontconfig, FreeType). Without any font,
// labels stay empty and everything else is drawn.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "render/gl.h"

namespace mw {

struct Glyph {
    int x = 0, y = 0, width = 0, height = 0;  ///< place in the atlas
    int left = 0, top = 0;                    ///< of the pixels, from the pen; top upwards
    float advance = 0;
};

class GlyphAtlas {
public:
    static constexpr int side = 1024;
    GlyphAtlas();
    ~GlyphAtlas();

    /// `pixels` is the height of the font; null when there is no font or no such letter.
    const Glyph* glyph(char32_t letter, int pixels, bool bold);
    float width(std::string_view utf8, int pixels, bool bold);
    /// The texture with all letters asked for so far; R8, nearest.
    GLuint texture();

private:
    struct Font;
    bool place(Glyph& g);
    std::unique_ptr<Font> regular_, bold_;
    std::map<uint64_t, Glyph> glyphs_;
    std::vector<uint8_t> pixels_;
    int penX_ = 1, penY_ = 1, rowHeight_ = 0;
    bool changed_ = true;
    gl::Texture texture_;
};

/// The next letter of UTF-8 text, which is shortened by it; U+FFFD for broken bytes.
char32_t nextLetter(std::string_view& utf8);

}  // namespace mw
