// Size and theme of pictures.
#include "app/cli/picture_options.h"

#include <charconv>

namespace mw::cli {
namespace {

/// 0 when it is no number from 1 to 16384.
int side(std::string_view text)
{
    int v = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    return error == std::errc() && end == text.data() + text.size() && v >= 1 && v <= 16384 ? v : 0;
}

}  // namespace

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

Theme takeTheme(Arguments& arguments)
{
    const std::string theme = arguments.value("--theme").value_or("dark");
    if (theme == "dark") return Theme::Dark;
    if (theme == "light") return Theme::Light;
    throw UsageError("--theme wants dark or light, not \"" + theme + "\"");
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
