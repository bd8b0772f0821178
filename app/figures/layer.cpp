// Items of a layer, and the view of the plane.
#include <algorithm>
#include <cmath>

#include "app/figures/figure.h"

namespace mw::figures {

void Layer::line(At a, At b, const Pen& pen)
{
    items_.push_back({Item::Kind::Path, {a, b}, pen});
}

void Layer::path(std::vector<At> points, const Pen& pen, bool closed)
{
    if (closed && !points.empty()) points.push_back(points.front());
    items_.push_back({Item::Kind::Path, std::move(points), pen});
}

void Layer::polygon(std::vector<At> corners, glm::vec4 fill)
{
    items_.push_back({Item::Kind::Polygon, std::move(corners), {}, fill});
}

void Layer::disc(At at, glm::vec4 fill, float diameter)
{
    items_.push_back({Item::Kind::Disc, {at}, {}, fill, diameter});
}

void Layer::ring(At at, glm::vec4 color, float diameter, float width)
{
    items_.push_back({Item::Kind::Disc, {at}, Pen(color, width), glm::vec4(0), diameter});
}

void Layer::label(At at, std::string text, glm::vec4 color, Beside beside, int size, bool bold)
{
    words(at, std::move(text), {color, beside, size, bold});
}

void Layer::words(At at, std::string text, const Words& look)
{
    items_.push_back({Item::Kind::Words, {at}, {}, {}, 0, std::move(text), look});
}

void Layer::paintItems(Painter& painter) const
{
    painter.on(paper_);
    painter.labelsWithin(place_);
    const auto all = [&](auto wanted) {
        for (const Item& item : items_) {
            if (!wanted(item)) continue;
            std::vector<glm::vec2> at;
            for (const At& a : item.at) at.push_back(onPage(a));
            if (item.kind == Item::Kind::Path) painter.path(at, item.pen);
            if (item.kind == Item::Kind::Polygon) painter.polygon(at, item.fill);
            if (item.kind == Item::Kind::Disc) {
                if (item.fill.a > 0)
                    painter.disc(at[0], item.diameter, item.fill, paper_, 1);
                else
                    painter.disc(at[0], item.diameter, glm::vec4(glm::vec3(item.pen.color), 0), item.pen.color, item.pen.width);
                const glm::vec2 half(0.4f * item.diameter);
                painter.keepFree({at[0] - half, at[0] + half});
            }
            if (item.kind == Item::Kind::Words) painter.words(at[0], item.text, item.look);
        }
    };
    all([](const Item& i) { return i.kind == Item::Kind::Path || i.kind == Item::Kind::Polygon; });
    all([](const Item& i) { return i.kind == Item::Kind::Disc; });
    // Labels that find their own place come after those that stand where they are told.
    all([](const Item& i) { return i.kind == Item::Kind::Words && i.look.beside != Beside::Auto; });
    all([](const Item& i) { return i.kind == Item::Kind::Words && i.look.beside == Beside::Auto; });
}

void Drawing::arc(At centre, double radius, double from, double to, const Pen& pen)
{
    std::vector<At> points;
    const int steps = std::max(2, int(std::abs(to - from) / 0.06));
    for (int i = 0; i <= steps; ++i) {
        const double a = from + (to - from) * i / steps;
        points.emplace_back(centre.p.x + radius * std::cos(a), centre.p.y + radius * std::sin(a));
    }
    path(std::move(points), pen);
}

void Drawing::arrange(const Box& place)
{
    Panel::arrange(place);
    if (!given_) {
        bool first = true;
        for (const Item& item : items_)
            for (const At& a : item.at) {
                const glm::dvec2 p(a.p);
                low_ = first ? p : glm::min(low_, p);
                high_ = first ? p : glm::max(high_, p);
                first = false;
            }
    }
    const glm::dvec2 room(place.inset(margin).size()), all = glm::max(high_ - low_, glm::dvec2(1e-9));
    unit_ = std::min(room.x / all.x, room.y / all.y);
}

glm::vec2 Drawing::onPage(const At& at) const
{
    const glm::dvec2 from = glm::dvec2(at.p) - 0.5 * (low_ + high_);
    return place_.middle() + glm::vec2(unit_ * from.x, -unit_ * from.y);
}

void Drawing::paint(Painter& painter)
{
    paintItems(painter);
}

}  // namespace mw::figures
