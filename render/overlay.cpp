// Labels, legend and orientation marker, in the measures of ui/UI.md.
#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mw {
namespace {

constexpr float legendWidth = 262, legendHeight = 132, barsHeight = 50, sharedHeight = 16, margin = 12, pad = 11, markerSize = 78;
constexpr size_t legendBars = 20;

const HeatMap* shownHeat(const DrawContext& c)
{
    const DrawObject* best = nullptr;  // of the selected object, else of the first that has one
    for (const DrawObject& o : c.frame.objects)
        if (o.heat && o.heat->table && o.heat->column < o.heat->table->columns.size() && (!best || (o.selected && !best->selected))) best = &o;
    return best ? best->heat.get() : nullptr;
}

const char* perWhat(ElementKind rows)
{
    switch (rows) {
        case ElementKind::Vertex:
            return "per vertex";
        case ElementKind::Face:
            return "per face";
        case ElementKind::Edge:
            return "per edge";
        default:
            return "";
    }
}

/// Counts a heat map's bars once for each table and column: counting a million values is too much for every frame.
struct HistogramCache {
    std::weak_ptr<const Table> table;
    size_t column = 0;
    double low = 0, high = 0;
    std::vector<size_t> bars;
    double least = 0, most = 0;
};

const HistogramCache& histogramFor(const HeatMap& h)
{
    thread_local HistogramCache cache;
    if (cache.table.lock() == h.table && cache.column == h.column && cache.low == h.low && cache.high == h.high) return cache;
    const Column& column = h.table->columns[h.column];
    cache = {h.table, h.column, h.low, h.high, histogramOf(column, h.low, h.high, legendBars), h.high, h.low};
    for (const double v : column.values) {
        if (!std::isfinite(v)) continue;
        cache.least = std::min(cache.least, v);
        cache.most = std::max(cache.most, v);
    }
    return cache;
}

void drawBars(Canvas& canvas, glm::vec2 low, glm::vec2 high, const std::vector<size_t>& bars, glm::vec4 color, float px)
{
    const size_t most = std::max<size_t>(*std::max_element(bars.begin(), bars.end()), 1);
    const float step = (high.x - low.x) / float(bars.size());
    for (size_t i = 0; i < bars.size(); ++i) {
        if (bars[i] == 0) continue;
        const float h = std::max((high.y - low.y) * float(bars[i]) / float(most), px);
        const float left = std::round(low.x + float(i) * step), right = std::round(low.x + float(i + 1) * step) - px;
        canvas.box({left, high.y - h}, {right, high.y}, color);
    }
}

void drawTicks(Canvas& canvas, const HeatMap& h, const HistogramCache& seen, glm::vec2 low, glm::vec2 high, int font, glm::vec4 color)
{
    constexpr int steps = 4;
    std::array<std::string, steps + 1> texts;
    std::array<float, steps + 1> widths;
    for (int i = 0; i <= steps; ++i) {
        std::string& text = texts[size_t(i)];
        text = tickText(h.low + (h.high - h.low) * i / steps);
        if (i == 0 && seen.least < h.low) text = "\u2264 " + text;
        if (i == steps && seen.most > h.high) text = "\u2265 " + text;
        widths[size_t(i)] = canvas.width(text, font, false);
    }
    // Those at the ends stand within the bar and reach towards their neighbours.
    const float quarter = (high.x - low.x) / steps, gap = 0.4f * float(font);
    const bool crowded = std::max(widths[0] + 0.5f * widths[1], widths[steps] + 0.5f * widths[steps - 1]) + gap > quarter;
    for (int i = 0; i <= steps; ++i) {
        if (crowded && i % 2) continue;
        const std::string& text = texts[size_t(i)];
        const auto align = i == 0 ? Canvas::Align::Left : i == steps ? Canvas::Align::Right : Canvas::Align::Centre;
        canvas.text({low.x + (high.x - low.x) * float(i) / steps, high.y}, text, font, color, false, align);
    }
}

/// Categories: as many swatches as there are, with their numbers.
void drawSwatches(Canvas& canvas, const HistogramCache& seen, glm::vec2 low, glm::vec2 high, float px, int font, glm::vec4 color)
{
    const int count = int(std::clamp(seen.most - seen.least + 1, 1.0, double(categoryCount)));
    const float step = (high.x - low.x) / float(count);
    for (int i = 0; i < count; ++i) {
        const float t = float((int(seen.least) + i) % categoryCount) / float(heatEntries - 1);
        canvas.colorBar({std::round(low.x + float(i) * step), low.y}, {std::round(low.x + float(i + 1) * step) - px, high.y}, categoryRow, t, t);
    }
    canvas.text({low.x, high.y + 17 * px}, tickText(seen.least), font, color);
    canvas.text({high.x, high.y + 17 * px}, tickText(seen.most), font, color, false, Canvas::Align::Right);
}

struct Axis {
    glm::vec3 direction;  // view space
    glm::vec3 color;
    const char* name;  // null: the negative end
};

}  // namespace

std::vector<size_t> histogramOf(const Column& column, double low, double high, size_t bars)
{
    std::vector<size_t> counts(bars, 0);
    const double scale = high > low ? double(bars) / (high - low) : 0;
    for (const double v : column.values)
        if (std::isfinite(v)) ++counts[size_t(std::clamp((v - low) * scale, 0.0, double(bars) - 1))];
    return counts;
}

std::string tickText(double v)
{
    if (v == 0) return "0";
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, v, std::chars_format::general, 3).ptr;
    std::string s(text, end);
    if (s[0] == '-') s.replace(0, 1, "\u2212");
    return s;
}

std::optional<Rectangle> placeLabel(glm::vec2 at, glm::vec2 extent, float gap, glm::vec2 picture, std::vector<Rectangle>& taken)
{
    constexpr int rings = 6;
    const auto inside = [&](glm::vec2 low) { return low.x >= 0 && low.y >= 0 && low.x + extent.x <= picture.x && low.y + extent.y <= picture.y; };
    const auto isFree = [&](glm::vec2 low) {
        return std::none_of(taken.begin(), taken.end(), [&](const Rectangle& t) {
            return low.x < t.high.x && t.low.x < low.x + extent.x && low.y < t.high.y && t.low.y < low.y + extent.y;
        });
    };
    for (int ring = 0; ring < rings; ++ring) {
        const float out = gap + float(ring) * (extent.y + 0.4f * gap), left = -gap - extent.x, above = -out - extent.y;
        const glm::vec2 places[] = {
            {gap, out}, {left, out}, {gap, above}, {left, above}, {-0.5f * extent.x, out + 0.6f * gap}, {-0.5f * extent.x, above - 0.6f * gap}};
        for (const glm::vec2& p : places) {
            const glm::vec2 low = glm::round(at + p);
            if ((ring > 0 && !inside(low)) || !isFree(low)) continue;
            taken.push_back({low, low + extent});
            return taken.back();
        }
    }
    return std::nullopt;
}

void drawLabels(const DrawContext& c, Canvas& canvas)
{
    const ThemeColors& theme = themeColors(Theme::Dark);  // labels are dark in both themes: they lie on the model
    const float px = float(c.frame.options.pixelRatio);
    const int font = int(std::lround(13 * px));
    std::vector<Rectangle> taken;
    std::vector<const Label*> shown;
    for (const Label& label : c.frame.labels) {
        const glm::dvec4 clip = c.clipFromView * c.viewFromWorld * glm::dvec4(glm::dvec3(label.atWorld), 1);
        if (clip.w <= 0 || label.text.empty()) continue;
        const glm::vec2 at((0.5 * (clip.x / clip.w + 1)) * c.size.x, (0.5 * (1 - clip.y / clip.w)) * c.size.y);
        const glm::vec2 extent(canvas.width(label.text, font, true) + 11 * px, 21 * px);
        const auto box = placeLabel(at, extent, 9 * px, glm::vec2(c.size), taken);
        if (!box) continue;
        shown.push_back(&label);
        // What lies further out is led back to its point.
        const glm::vec2 nearest = glm::clamp(at, box->low, box->high);
        if (glm::distance(nearest, at) > extent.y) canvas.stroke(at, nearest, 1.2f * px, glm::vec4(glm::vec3(label.color), 0.8f));
    }
    for (size_t i = 0; i < shown.size(); ++i) {
        canvas.box(taken[i].low, taken[i].high, glm::vec4(theme.field, 0.94f), 3 * px);
        canvas.text({taken[i].low.x + 5.5f * px, taken[i].high.y - 6 * px}, shown[i]->text, font, shown[i]->color, true);
    }
}

/// What the table says about the whole ("indices in strips 14"), as many of its numbers as three lines hold.
void drawSummary(Canvas& canvas, const Table& table, glm::vec2 at, float px, int font, glm::vec4 color)
{
    constexpr size_t lineLength = 36, lines = 3;
    std::string line;
    size_t drawn = 0;
    const auto flush = [&] {
        if (!line.empty()) canvas.text({at.x, at.y + float(drawn++) * 14 * px}, line, font, color);
        line.clear();
    };
    for (const auto& [name, value] : table.summary) {
        const std::string entry = name + " " + tickText(value);
        if (!line.empty() && line.size() + entry.size() + 3 > lineLength) flush();
        if (drawn == lines) return;
        line += (line.empty() ? "" : " \u00b7 ") + entry;
    }
    flush();
}

void drawLegend(const DrawContext& c, Canvas& canvas)
{
    const HeatMap* h = c.frame.options.legend ? shownHeat(c) : nullptr;
    const float px = float(c.frame.options.pixelRatio);
    if (!h || float(c.size.x) < (legendWidth + 2 * margin) * px || float(c.size.y) < (legendHeight + 2 * margin) * px) return;
    const Column& column = h->table->columns[h->column];
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    const HistogramCache& seen = histogramFor(*h);
    const int font = int(std::lround(13 * px)), small = int(std::lround(12 * px));
    const glm::vec4 text(theme.text, 1), text2(theme.text2, 1);
    // One legend for several views has no bars: each view has its own distribution.
    const bool bars = !h->shared;
    const float height = legendHeight + (bars ? 0 : sharedHeight - barsHeight);
    const glm::vec2 low = glm::round(glm::vec2(margin * px, float(c.size.y) - (margin + height) * px));
    const glm::vec2 high = low + glm::round(glm::vec2(legendWidth, height) * px);
    canvas.box(low, high, glm::vec4(theme.panel, 1), 4 * px, px, glm::vec4(theme.border, 1));
    const float left = low.x + pad * px, right = high.x - pad * px;
    std::string name = column.name;
    if (!column.unit.empty()) name += " (" + column.unit + ")";
    canvas.text({left, low.y + 22 * px}, name, font, text, true);
    canvas.text({right, low.y + 22 * px}, perWhat(h->table->rows), small, text2, false, Canvas::Align::Right);
    const float barTop = std::round(low.y + (bars ? 84 : 84 - barsHeight) * px), barBottom = barTop + std::round(13 * px);
    if (column.categorical) {
        drawSwatches(canvas, seen, {left, low.y + 34 * px}, {right, low.y + 64 * px}, px, small, text2);
        drawSummary(canvas, *h->table, {left, low.y + 98 * px}, px, int(std::lround(11 * px)), text2);
        return;
    }
    if (bars) drawBars(canvas, {left, low.y + 34 * px}, {right, barTop - 2 * px}, seen.bars, glm::vec4(theme.bars, 1), px);
    canvas.colorBar({left, barTop}, {right, barBottom}, heatRow(*h));
    drawTicks(canvas, *h, seen, {left, barBottom}, {right, barBottom + 19 * px}, small, text2);
    if (!bars) canvas.text({left, barBottom + 38 * px}, "same scale in all views", small, text2);
}

void drawMarker(const DrawContext& c, Canvas& canvas)
{
    if (!c.frame.options.orientationMarker) return;
    const float px = float(c.frame.options.pixelRatio);
    const float radius = 0.5f * markerSize * px, reach = radius - 12 * px, ball = 8.2f * px;
    if (float(c.size.x) < 3 * radius || float(c.size.y) < 3 * radius) return;
    const glm::vec2 centre(float(c.size.x) - margin * px - radius, margin * px + radius);
    const bool dark = c.frame.options.theme == Theme::Dark;
    canvas.disc(centre, radius, dark ? glm::vec4(hex(0x1B1D20), 0.62f) : glm::vec4(hex(0x7D8690), 0.65f));
    const glm::mat3 turn(c.viewFromWorld);
    std::array<Axis, 6> axes{Axis{turn[0], hex(0xE5484D), "X"},      Axis{turn[1], hex(0x6CC04A), "Y"},      Axis{turn[2], hex(0x4A90E2), "Z"},
                             Axis{-turn[0], hex(0xE5484D), nullptr}, Axis{-turn[1], hex(0x6CC04A), nullptr}, Axis{-turn[2], hex(0x4A90E2), nullptr}};
    std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.direction.z < b.direction.z; });
    const int font = int(std::lround(11 * px));
    for (const Axis& a : axes) {
        const glm::vec2 at = centre + reach * glm::vec2(a.direction.x, -a.direction.y);
        const glm::vec4 color(a.color, 1);
        if (!a.name) {
            canvas.disc(at, 5.4f * px, dark ? glm::vec4(hex(0x1B1D20), 0.55f) : glm::vec4(hex(0xD5D9DE), 0.55f), 1.4f * px, color);
            continue;
        }
        canvas.stroke(centre, at, 2 * px, color);
        canvas.disc(at, ball, color);
        canvas.text({at.x, at.y + 4 * px}, a.name, font, glm::vec4(hex(0x101215), 1), true, Canvas::Align::Centre);
    }
}

}  // namespace mw
