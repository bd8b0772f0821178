#include "app/cli/placement_options.h"

#include "core/io/placement.h"

namespace mw::cli {

namespace {

std::optional<double> takeUnit(Arguments& arguments, std::string_view name)
{
    const std::optional<std::string> text = arguments.value(name);
    if (!text) return {};
    const std::optional<double> metres = metresOf(*text);
    if (!metres || *metres < 1e-12 || *metres > 1e12)
        throw UsageError(std::string(name) + " wants mm, cm, m, in, ft or how many metres a unit is, not \"" + *text + "\"");
    return metres;
}

std::optional<UpAxis> takeAxis(Arguments& arguments, std::string_view name)
{
    const std::optional<std::string> text = arguments.value(name);
    if (!text) return {};
    const std::optional<UpAxis> axis = upAxisOf(*text);
    if (!axis) throw UsageError(std::string(name) + " wants y, z or x, not \"" + *text + "\"");
    return axis;
}

}  // namespace

ImportOptions takeImportOptions(Arguments& arguments)
{
    ImportOptions options;
    options.metresPerUnit = takeUnit(arguments, "--unit");
    options.up = takeAxis(arguments, "--up");
    return options;
}

Placement takeOutPlacement(Arguments& arguments)
{
    Placement placement;
    placement.metresPerUnit = takeUnit(arguments, "--out-unit").value_or(1);
    placement.up = takeAxis(arguments, "--out-up").value_or(UpAxis::Y);
    return placement;
}

}  // namespace mw::cli
