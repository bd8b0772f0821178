// Finding a font and filling the atlas row by row.
#include "render/glyph_atlas.h"

#include <algorithm>
#include <cmath>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <string>
#include FT_FREETYPE_H

namespace mw {
namespace {

/// File of the system's sans-serif font, empty when there is none.
std::string fontFile(bool bold)
{
    std::string file;
    FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>(bold ? "sans-serif:bold" : "sans-serif"));
    if (!wanted) return file;
    FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcResult result = FcResultNoMatch;
    FcPattern* found = FcFontMatch(nullptr, wanted, &result);
    FcChar8* name = nullptr;
    if (found && FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch) file = reinterpret_cast<const char*>(name);
    if (found) FcPatternDestroy(found);
    FcPatternDestroy(wanted);
    return file;
}

}  // namespace

struct GlyphAtlas::Font {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit Font(bool bold)
    {
        const std::string file = fontFile(bold);
        if (file.empty() || FT_Init_FreeType(&library) != 0) return;
        if (FT_New_Face(library, file.c_str(), 0, &face) != 0) face = nullptr;
    }
    ~Font()
    {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }
};

GlyphAtlas::GlyphAtlas() : pixels_(size_t(side) * side, 0) {}
GlyphAtlas::~GlyphAtlas() = default;

bool GlyphAtlas::place(Glyph& g)
{
    if (penX_ + g.width + 1 > side) {
        penX_ = 1;
        penY_ += rowHeight_ + 1;
        rowHeight_ = 0;
    }
    if (penY_ + g.height + 1 > side) return false;
    g.x = penX_;
    g.y = penY_;
    penX_ += g.width + 1;
    rowHeight_ = std::max(rowHeight_, g.height);
    return true;
}

const Glyph* GlyphAtlas::glyph(char32_t letter, int pixels, bool bold)
{
    const uint64_t key = uint64_t(letter) << 16 | uint64_t(std::clamp(pixels, 4, 200)) << 1 | uint64_t(bold);
    if (const auto i = glyphs_.find(key); i != glyphs_.end()) return &i->second;
    std::unique_ptr<Font>& font = bold ? bold_ : regular_;
    if (!font) font = std::make_unique<Font>(bold);
    FT_Face face = font->face;
    if (!face || FT_Set_Pixel_Sizes(face, 0, FT_UInt(std::clamp(pixels, 4, 200))) != 0) return nullptr;
    if (FT_Load_Char(face, letter, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) return nullptr;
    const FT_GlyphSlot slot = face->glyph;
    Glyph g;
    g.width = int(slot->bitmap.width);
    g.height = int(slot->bitmap.rows);
    g.left = slot->bitmap_left;
    g.top = slot->bitmap_top;
    g.advance = float(slot->advance.x) / 64.f;
    if (!place(g)) {  // full: begin anew, letters in use come back at once
        glyphs_.clear();
        std::fill(pixels_.begin(), pixels_.end(), uint8_t(0));
        penX_ = penY_ = 1;
        rowHeight_ = 0;
        if (!place(g)) return nullptr;
    }
    for (int y = 0; y < g.height; ++y)
        std::copy_n(slot->bitmap.buffer + ptrdiff_t(y) * slot->bitmap.pitch, g.width, pixels_.data() + size_t(g.y + y) * side + size_t(g.x));
    changed_ = true;
    return &glyphs_.emplace(key, g).first->second;
}

float GlyphAtlas::width(std::string_view utf8, int pixels, bool bold)
{
    float w = 0;
    while (!utf8.empty())
        if (const Glyph* g = glyph(nextLetter(utf8), pixels, bold)) w += g->advance;
    return w;
}

GLuint GlyphAtlas::texture()
{
    if (!changed_) return texture_.get();
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, side, side, 0, GL_RED, GL_UNSIGNED_BYTE, pixels_.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    changed_ = false;
    return texture_.get();
}

char32_t nextLetter(std::string_view& s)
{
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(s[i]); };
    const unsigned first = byte(0);
    const size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    char32_t letter = length == 1 ? first : length ? first & (0x7Fu >> length) : 0xFFFD;
    size_t used = 1;
    for (; used < length; ++used) {
        if (used >= s.size() || (byte(used) & 0xC0) != 0x80) {
            letter = 0xFFFD;
            break;
        }
        letter = letter << 6 | (byte(used) & 0x3F);
    }
    s.remove_prefix(used);
    return letter;
}

}  // namespace mw
