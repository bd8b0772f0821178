// Size, look and camera of pictures.
#include "app/cli/picture_options.h"

#include <charconv>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/environment.h"
#include "render/matcap.h"

namespace mw::cli {
namespace {

/// 0 when it is no number from 1 to 16384.
int side(std::string_view text)
{
    int v = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    return error == std::errc() && end == text.data() + text.size() && v >= 1 && v <= 16384 ? v : 0;
}

/// "shaded, flat, ..." of a list of things with names.
template <class List>
std::string namesOf(const List& list)
{
    std::string out;
    for (const auto& e : list) out += (out.empty() ? "" : ", ") + std::string(e.name);
    return out;
}

void readStyle(const std::string& text, PictureLook& look)
{
    constexpr std::string_view heat = "heat:", matcap = "matcap:";
    ViewOptions& o = look.options;
    if (text == "shaded") return;
    if (text == "flat") {
        o.shading = Shading::Flat;
        o.wireOverlay = true;
    } else if (text == "wire") {
        o.shading = Shading::Wire;
    } else if (text == "checker") {
        o.checker = true;
    } else if (text == "matcap" || text.starts_with(matcap)) {
        o.shading = Shading::Matcap;
        if (text != "matcap") o.matcap = text.substr(matcap.size());
        if (!findMatcap(o.matcap)) throw UsageError("there is no matcap \"" + o.matcap + "\"; there are " + namesOf(matcaps()));
    } else if (text.starts_with(heat)) {
        look.metric = parseCall(std::string_view(text).substr(heat.size()));
        const Operation& op = *look.metric->operation;
        if (op.accepts != Kind::Mesh || op.yields != Kind::Table)
            throw Error("the operation " + op.id +
                        " gives no numbers on a mesh to colour by; `meshwright algorithms` lists those that yield a table");
    } else {
        throw UsageError("--style wants shaded, flat, wire, matcap, checker or heat:METRIC, not \"" + text + "\"");
    }
}

void readLight(const std::string& text, ViewOptions& o)
{
    if (text == "three-point") return;
    if (!findEnvironment(text)) throw UsageError("--light wants three-point, " + namesOf(environments()) + ", not \"" + text + "\"");
    o.lighting = Lighting::Environment;
    o.environment = text;
}

/// Finite numbers between commas; false when they are not as many.
bool readNumbers(std::string_view text, std::span<double> out)
{
    for (size_t i = 0; i < out.size(); ++i) {
        const size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == out.size())) return false;
        const std::string_view one = text.substr(0, comma);
        const auto [end, error] = std::from_chars(one.data(), one.data() + one.size(), out[i]);
        if (error != std::errc() || end != one.data() + one.size() || !std::isfinite(out[i])) return false;
        text.remove_prefix(std::min(comma, text.size() - 1) + 1);
    }
    return true;
}

}  // namespace

PictureLook takeLook(Arguments& arguments)
{
    PictureLook look;
    ViewOptions& o = look.options;
    o.theme = takeTheme(arguments);
    readStyle(arguments.value("--style").value_or("shaded"), look);
    readLight(arguments.value("--light").value_or("three-point"), o);
    if (const auto turn = arguments.value("--light-turn")) {
        double degrees = 0;
        if (!readNumbers(*turn, {&degrees, 1})) throw UsageError("--light-turn wants degrees, not \"" + *turn + "\"");
        o.environmentTurn = glm::radians(degrees);
    }
    o.shadows = arguments.flag("--shadows");
    o.transparentBackground = arguments.flag("--transparent");
    if (arguments.flag("--no-grid") || o.transparentBackground) o.grid = o.axes = o.orientationMarker = false;
    return look;
}

std::optional<Camera> takeCamera(Arguments& arguments)
{
    const std::optional<std::string> text = arguments.value("--camera");
    if (!text) return {};
    const std::string_view whole = *text;
    const size_t first = whole.find('/'), second = first == std::string_view::npos ? first : whole.find('/', first + 1);
    double eye[3], target[3], angle = 40;
    bool good = first != std::string_view::npos && readNumbers(whole.substr(0, first), eye);
    good = good && readNumbers(whole.substr(first + 1, second == std::string_view::npos ? second : second - first - 1), target);
    if (good && second != std::string_view::npos) good = readNumbers(whole.substr(second + 1), {&angle, 1});
    const glm::dvec3 from = good ? glm::dvec3(eye[0], eye[1], eye[2]) - glm::dvec3(target[0], target[1], target[2]) : glm::dvec3(0);
    const double distance = glm::length(from);
    if (!good || !(distance > 0) || !(angle >= 1 && angle <= 150))
        throw UsageError("--camera wants EYE/TARGET/ANGLE, as 4,3,2/0,0,0/40 (two places, and 1 to 150 degrees), not \"" + *text + "\"");
    Camera c;
    c.target = {target[0], target[1], target[2]};
    c.distance = distance;
    c.azimuth = std::atan2(from.x, from.z);
    c.elevation = std::asin(glm::clamp(from.y / distance, -1.0, 1.0));
    c.fieldOfView = glm::radians(angle);
    return c;
}

PictureSize takeSize(Arguments& arguments, PictureSize otherwise)
{
    const std::optional<std::string> text = arguments.value("--size");
    if (!text) return otherwise;
    const std::string_view whole = *text;
    const size_t x = whole.find('x');
    const PictureSize size{side(whole.substr(0, x)), x == std::string_view::npos ? 0 : side(whole.substr(x + 1))};
    if (size.width == 0 || size.height == 0) throw UsageError("--size wants WIDTHxHEIGHT, each 1 to 16384, not \"" + *text + "\"");
    return size;
}

std::optional<Theme> takeThemeIfSaid(Arguments& arguments)
{
    const std::optional<std::string> theme = arguments.value("--theme");
    if (!theme) return {};
    if (*theme == "dark") return Theme::Dark;
    if (*theme == "light") return Theme::Light;
    throw UsageError("--theme wants dark or light, not \"" + *theme + "\"");
}

Theme takeTheme(Arguments& arguments)
{
    return takeThemeIfSaid(arguments).value_or(Theme::Dark);
}

std::shared_ptr<const HeatMap> heatMapOf(Table table, size_t column)
{
    auto heat = std::make_shared<HeatMap>();
    heat->column = column;
    std::tie(heat->low, heat->high) = heatRange(table.columns.at(column));
    heat->table = std::make_shared<Table>(std::move(table));
    return heat;
}

}  // namespace mw::cli
