// Putting panels on a page: rows, letters, captions, legends.
#include <algorithm>
#include <cmath>

#include "app/figures/figure.h"
#include "render/colors.h"
#include "render/flat_painter.h"
#include "render/overlay.h"

namespace mw::figures {
namespace {

constexpr float border = 22, gap = 20, titleHeight = 44, captionHeight = 20, scaleHeight = 50, keyHeight = 24, barsHeight = 34;
constexpr int captionSize = 15, titleSize = 19;

glm::vec4 opaque(glm::vec3 c)
{
    return {c, 1};
}

}  // namespace

glm::vec4 Page::ink(Ink ink) const
{
    const bool light = theme_ == Theme::Light;
    switch (ink) {
        case Ink::Text:
            return opaque(light ? hex(0x1C2126) : hex(0xE6E8EB));
        case Ink::Faint:
            return opaque(light ? hex(0x66707A) : hex(0xAEB5BD));
        case Ink::Line:
            return opaque(light ? hex(0x3A434C) : hex(0x9AA3AC));
        case Ink::Paper:
            return opaque(light ? hex(0xFFFFFF) : hex(0x1F2225));
        case Ink::Panel:
            return opaque(light ? hex(0xF1F3F5) : hex(0x2B2F34));
        case Ink::Focus:
            return opaque(light ? hex(0xE8710A) : hex(0xFF9A3C));
        case Ink::Neighbour:
            return opaque(light ? hex(0x1F6FC4) : hex(0x6CB2FF));
        case Ink::Removed:
            return opaque(light ? hex(0x8A9199) : hex(0x9097A0));
        case Ink::New:
            return opaque(light ? hex(0x14935A) : hex(0x37D98C));
        case Ink::Offender:
            return opaque(light ? hex(0xD32F2F) : hex(0xFF6B5E));
        case Ink::Rejected:
            return opaque(light ? hex(0x9334B0) : hex(0xC775E0));
    }
    return {};
}

glm::vec4 Page::series(int i) const
{
    constexpr uint32_t light[] = {0x1F6FC4, 0xE8710A, 0x14935A, 0xB01E7A, 0x7A5BD0, 0x8A6D1B, 0x117E8F, 0xC0392B};
    constexpr uint32_t dark[] = {0x6CB2FF, 0xFFA94D, 0x5FD49A, 0xF27BC0, 0xB79CFF, 0xE0C352, 0x4FD0E0, 0xFF8A7A};
    return opaque(hex((theme_ == Theme::Light ? light : dark)[size_t(i) % std::size(light)]));
}

glm::vec4 Page::tint(glm::vec4 color, float share) const
{
    return glm::mix(ink(Ink::Panel), color, share);
}

template <class P>
P& Page::add(std::string caption)
{
    if (rows_.empty()) row();
    auto panel = std::make_unique<P>();
    P& p = *panel;
    p.caption = std::move(caption);
    rows_.back().push_back(std::move(panel));
    return p;
}

Space& Page::space(std::string caption, glm::vec2 size)
{
    Space& s = add<Space>(std::move(caption));
    s.extent = size;
    s.paper_ = ink(Ink::Panel);
    s.look(30, 25);
    Material clay;
    clay.baseColor = theme_ == Theme::Light ? glm::dvec4(0.80, 0.81, 0.82, 1) : glm::dvec4(0.45, 0.46, 0.48, 1);
    clay.roughness = 0.9;
    s.clay_ = std::make_shared<const Material>(clay);
    ViewOptions& o = s.frame.options;
    o.theme = theme_;
    o.shading = Shading::Flat;
    o.wireOverlay = true;
    o.grid = o.axes = o.orientationMarker = o.legend = false;
    o.transparentBackground = true;
    o.samples = 8;
    return s;
}

Drawing& Page::drawing(std::string caption, glm::vec2 size)
{
    Drawing& d = add<Drawing>(std::move(caption));
    d.extent = size;
    d.paper_ = ink(Ink::Panel);
    return d;
}

TablePanel& Page::table(std::string caption, std::vector<std::string> header)
{
    TablePanel& t = add<TablePanel>(std::move(caption));
    t.header(std::move(header));
    t.framed = false;
    t.look_ = {ink(Ink::Text), ink(Ink::Removed), tint(ink(Ink::Removed), 0.25f), tint(ink(Ink::Removed), 0.22f)};
    return t;
}

Plot& Page::plot(std::string caption, std::string xTitle, std::string yTitle, glm::vec2 size)
{
    Plot& p = add<Plot>(std::move(caption));
    p.extent = size;
    p.xTitle = std::move(xTitle);
    p.yTitle = std::move(yTitle);
    p.look_ = {ink(Ink::Text), ink(Ink::Faint), tint(ink(Ink::Removed), 0.3f)};
    return p;
}

void Page::link(const Panel& from, At a, const Panel& to, At b, const Pen& pen)
{
    links_.push_back({&from, &to, a, b, pen});
}

/// Where each panel's cell is: picture, legends and caption.
struct Page::Layout {
    glm::vec2 size{0};
    std::vector<std::pair<Panel*, Box>> cells;
};

namespace {

/// Swatches in as many lines as they need.
float keyLines(const Painter& painter, const Panel& p, float widest)
{
    float lines = p.keys.empty() ? 0 : 1, x = 0;
    for (const Panel::Key& k : p.keys) {
        const float w = painter.width(k.text, 14) + 38;
        if (x > 0 && x + w > widest) {
            ++lines;
            x = 0;
        }
        x += w;
    }
    return lines;
}

float legendHeight(const Painter& painter, const Panel& p)
{
    float h = keyLines(painter, p, p.extent.x) * keyHeight;
    if (p.scale) h += scaleHeight + (p.scale->histogram ? barsHeight : 0);
    return h;
}

std::string captionText(const Panel& p)
{
    return p.letter.empty() ? p.caption : p.letter + (p.caption.empty() ? "" : " " + p.caption);
}

void paintScale(Painter& painter, const Panel::Scale& s, Box room, const Page& page)
{
    const Column& column = s.heat.table->columns[s.heat.column];
    float y = room.low.y + 18;
    painter.line({room.low.x, y}, column.unit.empty() ? s.title : s.title + " (" + column.unit + ")", 14, page.ink(Ink::Text), Canvas::Align::Left,
                 true);
    y += 6;
    if (s.histogram) {
        const std::vector<size_t> bars = histogramOf(column, s.heat.low, s.heat.high, 40);
        const float most = float(std::max<size_t>(1, *std::max_element(bars.begin(), bars.end()))), step = room.size().x / float(bars.size());
        for (size_t i = 0; i < bars.size(); ++i) {
            const float h = (barsHeight - 4) * float(bars[i]) / most, x = room.low.x + step * float(i);
            if (bars[i]) painter.box({{x, y + barsHeight - 2 - std::max(h, 1.f)}, {x + step - 1, y + barsHeight - 2}}, page.ink(Ink::Removed));
        }
        y += barsHeight;
    }
    painter.colorBar({{room.low.x, y}, {room.high.x, y + 10}}, heatRow(s.heat));
    for (int i = 0; i <= 4; ++i) {
        const auto align = i == 0 ? Canvas::Align::Left : i == 4 ? Canvas::Align::Right : Canvas::Align::Centre;
        painter.line({room.low.x + room.size().x * float(i) / 4, y + 25}, shortNumber(s.heat.low + (s.heat.high - s.heat.low) * i / 4), 13,
                     page.ink(Ink::Faint), align);
    }
}

}  // namespace

void Page::arrange(Painter& painter, Layout& layout, const std::string& title)
{
    float widest = painter.width(title, titleSize, true);
    std::vector<glm::vec2> rowSizes;
    size_t panels = 0, letter = 0;
    for (const auto& r : rows_) panels += r.size();
    for (const auto& r : rows_) {
        glm::vec2 size(0);
        for (const auto& p : r) {
            if (letters_ && panels > 1) p->letter = std::string("(") + char('a' + char(letter++)) + ")";
            p->measure(painter);
            const auto lines = painter.wrapped(captionText(*p), captionSize, std::max(p->extent.x, 160.f));
            const float h = p->extent.y + legendHeight(painter, *p) + (lines.empty() ? 0 : 8) + captionHeight * float(lines.size());
            size = {size.x + (size.x > 0 ? gap : 0) + std::max(p->extent.x, 160.f), std::max(size.y, h)};
        }
        rowSizes.push_back(size);
        widest = std::max(widest, size.x);
    }
    for (const std::string& n : notes_) widest = std::max(widest, std::min(painter.width(n, captionSize), 900.f));
    float y = border + titleHeight;
    for (size_t k = 0; k < rows_.size(); ++k) {
        float x = border + 0.5f * (widest - rowSizes[k].x);
        for (const auto& p : rows_[k]) {
            const float w = std::max(p->extent.x, 160.f);
            layout.cells.push_back({p.get(), Box{{x, y}, {x + w, y + rowSizes[k].y}}});
            const float left = x + 0.5f * (w - p->extent.x);
            p->arrange({glm::round(glm::vec2(left, y)), glm::round(glm::vec2(left, y) + p->extent)});
            x += w + gap;
        }
        y += rowSizes[k].y + gap;
    }
    for (const std::string& n : notes_) y += captionHeight * float(painter.wrapped(n, captionSize, widest).size());
    layout.size = glm::ceil(glm::vec2(widest + 2 * border, y - (notes_.empty() ? gap : 0) + border));
}

void Page::paintLegends(Painter& painter, const Panel& panel, float& y) const
{
    const Box& place = panel.place();
    if (panel.scale) {
        const float h = scaleHeight + (panel.scale->histogram ? barsHeight : 0);
        paintScale(painter, *panel.scale, {{place.low.x, y}, {place.high.x, y + h}}, *this);
        y += h;
    }
    float x = place.low.x;
    for (const Panel::Key& k : panel.keys) {
        const float w = painter.width(k.text, 14) + 38;
        if (x > place.low.x && x + w > place.high.x + 1) {
            x = place.low.x;
            y += keyHeight;
        }
        const float middle = y + 0.5f * keyHeight + 1;
        if (k.line)
            painter.path({{x + 2, middle}, {x + 18, middle}}, Pen(k.color, 3));
        else
            painter.box({{x + 3, middle - 6}, {x + 16, middle + 6}}, k.color, 2, ink(Ink::Faint), 1);
        painter.line({x + 24, middle + 5}, k.text, 14, ink(Ink::Text));
        x += w;
    }
    if (!panel.keys.empty()) y += keyHeight;
}

void Page::paintPanel(Painter& painter, Panel& panel, const Box& cell) const
{
    painter.on(panel.framed ? ink(Ink::Panel) : ink(Ink::Paper));
    panel.paint(painter);
    painter.on(ink(Ink::Paper));
    float y = panel.place().high.y;
    paintLegends(painter, panel, y);
    y += 8;
    for (const std::string& line : painter.wrapped(captionText(panel), captionSize, cell.size().x)) {
        y += captionHeight;
        painter.line({cell.middle().x, y - 5}, line, captionSize, ink(Ink::Text), Canvas::Align::Centre);
    }
}

void Page::paintNotes(Painter& painter, glm::vec2 size) const
{
    std::vector<std::string> lines;
    for (const std::string& n : notes_)
        for (std::string& line : painter.wrapped(n, captionSize, size.x - 2 * border)) lines.push_back(std::move(line));
    float y = size.y - border;
    for (size_t i = lines.size(); i-- > 0; y -= captionHeight) painter.line({border, y - 4}, lines[i], captionSize, ink(Ink::Text));
}

namespace {

/// What a test asks about the text of a page.
void checkText(const std::vector<Painter::Put>& texts, glm::vec2 size, Page::Made& made)
{
    for (size_t i = 0; i < texts.size(); ++i) {
        const Box& b = texts[i].box;
        if (b.low.x < 0 || b.low.y < 0 || b.high.x > size.x || b.high.y > size.y) made.outside.push_back(texts[i].text);
        for (size_t j = 0; j < i; ++j)
            if (b.inset(1.5f).touches(texts[j].box.inset(1.5f))) made.covered.push_back(texts[j].text + " | " + texts[i].text);
    }
}

}  // namespace

Page::Made Page::draw(Offscreen& offscreen, const std::string& title, float pixelRatio)
{
    FlatPainter flat(offscreen);
    Painter painter(flat.canvas(), pixelRatio, ink(Ink::Paper));
    Layout layout;
    arrange(painter, layout, title);
    const glm::ivec2 pixels(glm::ceil(layout.size * pixelRatio));
    painter.box({glm::vec2(0), layout.size + 1.f}, ink(Ink::Paper));
    for (const auto& [panel, cell] : layout.cells)
        if (panel->framed) painter.box(panel->place(), ink(Ink::Panel), 5);
    Made made;
    made.picture = flat.draw(pixels.x, pixels.y);
    for (const auto& [panel, cell] : layout.cells)
        if (const std::optional<Picture> p = panel->picture(offscreen, pixelRatio)) {
            const glm::ivec2 at(glm::round(panel->place().low * pixelRatio));
            overlay(made.picture, *p, at.x, at.y);
        }
    painter.line({border, border + 20}, title, titleSize, ink(Ink::Text), Canvas::Align::Left, true);
    for (const auto& [panel, cell] : layout.cells) {
        paintPanel(painter, *panel, cell);
        made.captions.push_back(captionText(*panel));
    }
    for (const Link& l : links_) painter.path({l.from->onPage(l.a), l.to->onPage(l.b)}, l.pen);
    paintNotes(painter, layout.size);
    overlay(made.picture, flat.draw(pixels.x, pixels.y), 0, 0);
    checkText(painter.texts(), layout.size, made);
    return made;
}

std::string shortNumber(double v)
{
    return tickText(v);
}

std::string countText(size_t n, const char* one, const char* many)
{
    return std::to_string(n) + " " + (n == 1 ? one : many ? many : std::string(one) + "s");
}

}  // namespace mw::figures
