#include "core/scene/stroke_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

namespace mw {
namespace {

void put(std::string& text, double v)
{
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, v).ptr);
}

double taken(std::string_view& text, char end, size_t number)
{
    double v = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    const size_t used = size_t(stop - text.data());
    const bool ends = used == text.size() ? end == ';' : text[used] == end;
    if (error != std::errc() || !ends || !(std::abs(v) <= 1e8))
        throw Error("place " + std::to_string(number) + " of the stroke is not x/z within 1e8 m; places are written 10/-20;12.5/-18");
    text.remove_prefix(std::min(text.size(), used + 1));
    return v;
}

}  // namespace

std::string strokeText(std::span<const glm::dvec2> places)
{
    std::string text;
    for (const glm::dvec2& p : places) {
        if (!text.empty()) text += ';';
        put(text, p.x);
        text += '/';
        put(text, p.y);
    }
    return text;
}

std::vector<glm::dvec2> parsedStroke(std::string_view text)
{
    std::vector<glm::dvec2> places;
    while (!text.empty()) {
        const double x = taken(text, '/', places.size() + 1), z = taken(text, ';', places.size() + 1);
        places.push_back({x, z});
    }
    if (places.empty()) throw Error("the stroke has no places; they are written 10/-20;12.5/-18");
    return places;
}

double dabsOf(std::span<const glm::dvec2> places, const Brush& brush)
{
    double way = 0;
    for (size_t i = 1; i < places.size(); ++i) way += glm::distance(places[i - 1], places[i]);
    return 1 + way / (brush.radius * brush.spacing);
}

}  // namespace mw
