// Curves over axes on a page.
#include <algorithm>
#include <cmath>

#include "app/figures/figure.h"

namespace mw::figures {
namespace {

std::pair<double, double> rangeOf(const std::vector<double>& values, std::pair<double, double> r, bool first)
{
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        r.first = first ? v : std::min(r.first, v);
        r.second = first ? v : std::max(r.second, v);
        first = false;
    }
    return r;
}

/// Steps of 1, 2 or 5 times a power of ten, about `count` of them.
double roundStep(double extent, int count)
{
    const double rough = extent / count, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double f : {1., 2., 5.})
        if (f * power >= rough * 0.999) return f * power;
    return 10 * power;
}

}  // namespace

void Plot::series(std::string name, std::vector<double> x, std::vector<double> y, const Pen& pen, float discs)
{
    series_.push_back({std::move(name), std::move(x), std::move(y), pen, discs});
}

void Plot::mark(double x, double y, std::string text, glm::vec4 color)
{
    marked_.push_back({x, y, std::move(text), color});
}

void Plot::measure(Painter&)
{
    if (keys.empty() && series_.size() > 1)
        for (const Series& s : series_) lineKey(s.pen.color, s.name);
    bool first = true;
    for (const Series& s : series_) {
        std::vector<double> y = s.y;
        if (logY)
            for (double& v : y) v = v > 0 ? std::log10(v) : NAN;
        x_ = rangeOf(s.x, x_, first);
        y_ = rangeOf(y, y_, first);
        first = false;
    }
    if (xRange) x_ = *xRange;
    if (yRange) y_ = logY ? std::pair(std::log10(yRange->first), std::log10(yRange->second)) : *yRange;
    if (!(x_.second > x_.first)) x_.second = x_.first + 1;
    if (!(y_.second > y_.first)) y_.second = y_.first + 1;
    const double room = yRange ? 0 : 0.05 * (y_.second - y_.first);
    y_.first -= y_.first == 0 ? 0 : room;
    y_.second += room;
}

glm::vec2 Plot::onPage(const At& at) const
{
    const double y = logY ? std::log10(std::max(at.p.y, 1e-300)) : at.p.y;
    const double s = (at.p.x - x_.first) / (x_.second - x_.first), t = (y - y_.first) / (y_.second - y_.first);
    return {area_.low.x + float(s) * area_.size().x, area_.high.y - float(t) * area_.size().y};
}

void Plot::paintAxes(Painter& painter)
{
    const double dx = roundStep(x_.second - x_.first, 6),
                 dy = logY ? std::max(1., roundStep(y_.second - y_.first, 5)) : roundStep(y_.second - y_.first, 5);
    for (double v = std::ceil(x_.first / dx - 1e-9) * dx; v <= x_.second + 1e-9 * dx; v += dx) {
        const float x = area_.low.x + float((v - x_.first) / (x_.second - x_.first)) * area_.size().x;
        painter.path({{x, area_.low.y}, {x, area_.high.y}}, Pen(look_.line, 1));
        painter.line({x, area_.high.y + 17}, shortNumber(std::abs(v) < 1e-9 * dx ? 0 : v), 13, look_.faint, Canvas::Align::Centre);
    }
    for (double v = std::ceil(y_.first / dy - 1e-9) * dy; v <= y_.second + 1e-9 * dy; v += dy) {
        const float y = area_.high.y - float((v - y_.first) / (y_.second - y_.first)) * area_.size().y;
        painter.path({{area_.low.x, y}, {area_.high.x, y}}, Pen(look_.line, 1));
        const double value = logY ? std::pow(10, v) : std::abs(v) < 1e-9 * dy ? 0 : v;
        painter.line({area_.low.x - 6, y + 4}, shortNumber(value), 13, look_.faint, Canvas::Align::Right);
    }
    painter.path({area_.low, {area_.low.x, area_.high.y}, area_.high}, Pen(look_.text, 1.5f));
    painter.line({area_.middle().x, area_.high.y + 36}, xTitle, 14, look_.text, Canvas::Align::Centre);
    painter.line({place_.low.x + 8, area_.low.y - 10}, yTitle, 14, look_.text);
}

void Plot::paint(Painter& painter)
{
    area_ = {place_.low + glm::vec2(66, 34), place_.high - glm::vec2(20, 46)};
    paintAxes(painter);
    painter.labelsWithin(area_);
    for (const Series& s : series_) {
        std::vector<glm::vec2> line;
        for (size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
            const bool shown = std::isfinite(s.y[i]) && (!logY || s.y[i] > 0);
            if (shown) line.push_back(onPage({s.x[i], s.y[i]}));
            if (!shown || i + 1 == s.x.size()) {
                if (s.pen.width > 0) painter.path(line, s.pen);
                if (s.discs > 0)
                    for (const glm::vec2& p : line) painter.disc(p, s.discs, s.pen.color);
                line.clear();
            }
        }
    }
    for (const Marked& m : marked_) {
        painter.disc(onPage({m.x, m.y}), 9, m.color);
        painter.words(onPage({m.x, m.y}), m.text, {m.color, Beside::Auto, 14, true});
    }
}

}  // namespace mw::figures
