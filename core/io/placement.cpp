#include "core/io/placement.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/io/text.h"

namespace mw {

namespace {

struct Unit {
    double metres;
    std::string_view name;  // plural
    std::array<std::string_view, 5> words;
};
constexpr std::array<Unit, 6> units{{{0.001, "millimetres", {"mm", "millimetre", "millimeter", "millimeters", ""}},
                                     {0.01, "centimetres", {"cm", "centimetre", "centimeter", "centimeters", ""}},
                                     {1, "metres", {"m", "metre", "meter", "meters", ""}},
                                     {1000, "kilometres", {"km", "kilometre", "kilometer", "kilometers", ""}},
                                     {0.0254, "inches", {"in", "inch", "\"", "", ""}},
                                     {0.3048, "feet", {"ft", "foot", "'", "", ""}}}};

std::string lower(std::string_view text)
{
    std::string out(trimmed(text));
    std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return out;
}

/// The rest of `text` behind `word` and ':' or '='; nothing when `text` does not begin so.
std::optional<std::string_view> behind(std::string_view text, std::string_view word)
{
    if (!text.starts_with(word)) return {};
    const std::string_view rest = text.substr(word.size());
    const size_t value = rest.find_first_not_of(" \t:=");
    if (value == rest.npos || rest.substr(0, value).find_first_of(":=") == rest.npos) return {};
    return rest.substr(value);
}

/// Quarter turns have whole entries.
glm::dmat4 turn(UpAxis up)
{
    if (up == UpAxis::Z) return {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
    if (up == UpAxis::X) return {{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    return glm::dmat4(1);
}

glm::dmat4 scaled(glm::dmat4 m, double s)
{
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) m[i][k] *= s;
    return m;
}

}  // namespace

glm::dmat4 sceneFromFile(const Placement& p)
{
    return scaled(turn(p.up), p.metresPerUnit);
}

glm::dmat4 fileFromScene(const Placement& p)
{
    return scaled(glm::transpose(turn(p.up)), 1 / p.metresPerUnit);
}

std::optional<double> metresOf(std::string_view unit)
{
    const std::string text = lower(unit);
    for (const Unit& u : units)
        if (text == u.name || (!text.empty() && std::find(u.words.begin(), u.words.end(), text) != u.words.end())) return u.metres;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !(value > 0) || !std::isfinite(value)) return {};
    const std::string rest = lower({end, size_t(text.data() + text.size() - end)});
    if (rest.empty()) return value;
    for (const Unit& u : units)
        if (rest == u.name || std::find(u.words.begin(), u.words.end(), rest) != u.words.end()) return value * u.metres;
    return {};
}

std::optional<UpAxis> upAxisOf(std::string_view axis)
{
    std::string text = lower(axis);
    if (text.starts_with('+')) text.erase(0, 1);
    for (const std::string_view ending : {"-up", "_up", " up", "up"})
        if (text.size() > ending.size() && text.ends_with(ending)) text.resize(text.size() - ending.size());
    if (text == "y") return UpAxis::Y;
    if (text == "z") return UpAxis::Z;
    if (text == "x") return UpAxis::X;
    return {};
}

std::string unitText(double metresPerUnit)
{
    for (const Unit& u : units)
        if (std::abs(metresPerUnit - u.metres) <= 1e-6 * u.metres) return std::string(u.name);
    char text[32];
    return "units of " + std::string(text, std::to_chars(text, text + sizeof text, metresPerUnit, std::chars_format::general, 6).ptr) + " m";
}

const char* upText(UpAxis up)
{
    return up == UpAxis::Y ? "y" : up == UpAxis::Z ? "z" : "x";
}

void Stated::listen(std::string_view comment)
{
    if (comment.size() > 200) return;
    std::string all = lower(comment);
    // Several statements may share a comment.
    for (size_t at = 0; at < all.size();) {
        const size_t end = std::min(all.find_first_of(",;", at), all.size());
        const std::string text = lower(std::string_view(all).substr(at, end - at));
        at = end + 1;
        for (const std::string_view word :
             {"units", "unit", "file units", "file unit", "export units", "model units", "length unit", "units of length"})
            if (const auto value = behind(text, word))
                if (const auto metres = metresOf(*value); metres && !isDigit(value->back())) metresPerUnit = metres;  // "unit: 3" may be a part
        for (const std::string_view word : {"up axis", "up-axis", "upaxis", "up_axis", "up"})
            if (const auto value = behind(text, word))
                if (const auto axis = upAxisOf(*value)) up = axis;
        if (text == "y-up" || text == "y up" || text == "z-up" || text == "z up" || text == "x-up" || text == "x up") up = upAxisOf(text);
    }
}

void Stated::tell(Imported& in) const
{
    if (!metresPerUnit && !up) return;
    const Placement stated{metresPerUnit.value_or(1), up.value_or(UpAxis::Y)};
    placeAgain(in.scene, in.scene.roots(), {}, stated);
    in.placement = stated;
    in.placementFromFile = metresPerUnit.has_value();
    if (metresPerUnit) in.units = unitText(*metresPerUnit);
}

std::string statement(const Placement& p)
{
    const std::string unit = unitText(p.metresPerUnit);
    char text[32];
    const std::string number(text, std::to_chars(text, text + sizeof text, p.metresPerUnit).ptr);
    return "units: " + (unit.starts_with("units") ? number + " m" : unit) + ", up: " + upText(p.up);
}

}  // namespace mw
