// A table on a page.
#include <algorithm>
#include <charconv>

#include "app/figures/figure.h"

namespace mw::figures {
namespace {

constexpr float cellPad = 10;

bool isNumber(const std::string& text)
{
    return !text.empty() && text.find_first_not_of("0123456789.,-+e\u2212 ") == std::string::npos;
}

}  // namespace

void TablePanel::measure(Painter& painter)
{
    size_t columns = header_.size();
    for (const auto& r : rows_) columns = std::max(columns, r.size());
    widths_.assign(columns, 0);
    for (size_t i = 0; i < header_.size(); ++i) widths_[i] = painter.width(header_[i], fontSize, true) + 2 * cellPad;
    for (const auto& r : rows_)
        for (size_t i = 0; i < r.size(); ++i) widths_[i] = std::max(widths_[i], painter.width(r[i].text, fontSize) + 2 * cellPad);
    extent = {0, rowHeight * float(rows_.size() + (header_.empty() ? 0 : 1))};
    for (const float w : widths_) extent.x += w;
}

void TablePanel::paint(Painter& painter)
{
    glm::vec2 at = place_.low;
    const auto cells = [&](float y, size_t i, float x, const std::string& text, glm::vec4 color, bool bold) {
        const bool right = numbersRight && isNumber(text);
        const glm::vec2 base(right ? x + widths_[i] - cellPad : x + cellPad, y + 0.5f * rowHeight + 0.34f * float(fontSize));
        if (!text.empty()) painter.line(base, text, fontSize, color, right ? Canvas::Align::Right : Canvas::Align::Left, bold);
    };
    if (!header_.empty()) {
        painter.box({at, {place_.high.x, at.y + rowHeight}}, look_.head);
        float x = at.x;
        for (size_t i = 0; i < header_.size(); ++i) {
            bool numbers = numbersRight && !rows_.empty();  // a heading stands over its column
            for (const auto& r : rows_) numbers = numbers && (i >= r.size() || isNumber(r[i].text));
            const float w = painter.width(header_[i], fontSize, true);
            const float left = numbers ? x + widths_[i] - cellPad - w : x + cellPad;
            painter.line({left, at.y + 0.5f * rowHeight + 0.34f * float(fontSize)}, header_[i], fontSize, look_.text, Canvas::Align::Left, true);
            x += widths_[i];
        }
        at.y += rowHeight;
    }
    for (size_t k = 0; k < rows_.size(); ++k) {
        if (k > 0 || header_.empty()) {
            const bool strong = std::find(rules_.begin(), rules_.end(), k) != rules_.end();
            if (k > 0) painter.box({{at.x, at.y}, {place_.high.x, at.y + (strong ? 2.f : 1.f)}}, strong ? look_.faint : look_.line);
        }
        float x = at.x;
        for (size_t i = 0; i < rows_[k].size(); ++i) {
            const Cell& c = rows_[k][i];
            if (c.ground.a > 0) painter.box({{x, at.y + 1}, {x + widths_[i], at.y + rowHeight}}, c.ground);
            cells(at.y, i, x, c.text, c.color.a > 0 ? c.color : look_.text, false);
            x += widths_[i];
        }
        at.y += rowHeight;
    }
    painter.box(place_, glm::vec4(0), 0, look_.faint, 1);
}

}  // namespace mw::figures
