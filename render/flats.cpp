// Flat marks of tools over the picture, and the regions they enclose.
#include <algorithm>
#include <cmath>

#include "render/overlay.h"

namespace mw {
namespace {

constexpr float haloWidth = 1.4f;
constexpr float darkHalo = 0.85f;  // its alpha

void drawLine(Canvas& canvas, const Flat& f, float px)
{
    for (const bool halo : {true, false}) {
        if (halo && !f.halo) continue;
        const glm::vec4 color = halo ? glm::vec4(haloColor, darkHalo * f.color.a) : f.color;
        for (size_t i = 0; i + 1 < f.at.size(); ++i)
            canvas.stroke(px * f.at[i], px * f.at[i + 1], px * (f.width + (halo ? 2 * haloWidth : 0)), color);
    }
}

void drawPlate(Canvas& canvas, const Flat& f, float px)
{
    const ThemeColors& theme = themeColors(Theme::Dark);  // dark in both themes, as labels are
    const int font = int(std::lround(13 * px));
    const float width = canvas.width(f.text, font, true);
    const glm::vec2 low = glm::round(px * f.at[0] - glm::vec2(0, 10.5f * px)), high = low + glm::vec2(width + 11 * px, 21 * px);
    canvas.box(low, high, glm::vec4(theme.field, 0.94f), 3 * px);
    canvas.text({low.x + 5.5f * px, high.y - 6 * px}, f.text, font, f.color, true);
}

}  // namespace

void drawFlats(const DrawContext& c, Canvas& canvas)
{
    const float px = float(c.frame.options.pixelRatio);
    for (const Flat& f : c.frame.flats) {
        if (f.at.empty()) continue;
        const glm::vec4 halo(haloColor, darkHalo * f.color.a);
        if (f.kind == Flat::Kind::Line) {
            drawLine(canvas, f, px);
        } else if (f.kind == Flat::Kind::Disc) {
            if (f.halo) canvas.disc(px * f.at[0], px * (0.5f * f.width + haloWidth), halo);
            canvas.disc(px * f.at[0], px * 0.5f * f.width, f.color);
        } else if (f.kind == Flat::Kind::Quad && f.at.size() == 4) {
            if (f.halo) canvas.quad({px * f.at[0], px * f.at[1], px * f.at[2], px * f.at[3]}, halo, px * haloWidth);
            canvas.quad({px * f.at[0], px * f.at[1], px * f.at[2], px * f.at[3]}, f.color, 0);
        } else if (f.kind == Flat::Kind::Text) {
            drawPlate(canvas, f, px);
        }
    }
}

bool Region::contains(glm::dvec2 pixel) const
{
    const glm::ivec2 p(glm::floor(pixel));
    if (p.x < low.x || p.y < low.y || p.x >= high.x || p.y >= high.y) return false;
    return mask.empty() || mask[size_t(p.y - low.y) * size_t(high.x - low.x) + size_t(p.x - low.x)] != 0;
}

Region polygonRegion(const std::vector<glm::dvec2>& corners, glm::ivec2 size)
{
    Region r;
    if (corners.size() < 3) return r;
    glm::dvec2 least = corners[0], most = corners[0];
    for (const glm::dvec2& c : corners) {
        least = glm::min(least, c);
        most = glm::max(most, c);
    }
    r.low = glm::clamp(glm::ivec2(glm::floor(least)), glm::ivec2(0), size);
    r.high = glm::clamp(glm::ivec2(glm::ceil(most)), r.low, size);
    const size_t width = size_t(r.high.x - r.low.x);
    r.mask.assign(width * size_t(r.high.y - r.low.y), 0);
    std::vector<double> crossings;
    for (int y = r.low.y; y < r.high.y; ++y) {  // between odd and even crossings of a row of pixel centres lies the inside
        crossings.clear();
        const double at = y + 0.5;
        for (size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
            if ((a.y <= at) != (b.y <= at)) crossings.push_back(a.x + (at - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        std::sort(crossings.begin(), crossings.end());
        for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int from = std::clamp(int(std::ceil(crossings[i] - 0.5)), r.low.x, r.high.x);
            const int to = std::clamp(int(std::ceil(crossings[i + 1] - 0.5)), from, r.high.x);
            const auto row = r.mask.begin() + ptrdiff_t(size_t(y - r.low.y) * width);
            std::fill(row + (from - r.low.x), row + (to - r.low.x), uint8_t(1));
        }
    }
    return r;
}

}  // namespace mw
