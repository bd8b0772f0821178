// The edit that reads the numbers of an imported file another way: other units, another axis up.
#include "core/io/io.h"
#include "core/scene/edit_entries.h"

namespace mw {
namespace {

/// The same roots, as if their file had been read in other units or with another axis up.
struct PlaceImport {
    std::string nodes;
    double fromUnit = 1, unit = 1;
    UpAxis fromUp = UpAxis::Y, up = UpAxis::Y;
    template <class V>
    void describe(V& v)
    {
        const std::vector<std::string> axes{"y", "z", "x"};
        v.object("nodes", nodes, {.title = "Nodes", .help = "The roots of what was imported, joined by +."});
        v.number("from-unit", fromUnit,
                 {.title = "Unit before", .help = "Metres of one unit, as it was read.", .unit = "m", .min = 1e-9, .max = 1e9});
        v.choice("from-up", fromUp, axes, {.title = "Up before", .help = "The axis that pointed up, as it was read."});
        v.number("unit", unit, {.title = "Unit", .help = "Metres of one unit of the file.", .unit = "m", .min = 1e-9, .max = 1e9});
        v.choice("up", up, axes, {.title = "Up", .help = "The axis of the file that points up."});
    }
};

void placeImport(Scene& scene, const PlaceImport& p, EditRun&)
{
    placeAgain(scene, nodesOf(scene, p.nodes), {p.fromUnit, p.fromUp}, {p.unit, p.up});
}

std::string placeImportName(const Scene& scene, const PlaceImport& p)
{
    return spoken(scene, nodesOf(scene, p.nodes)) + ": units and up axis";
}

}  // namespace

std::vector<Edit> placementEdits()
{
    return {editEntry<PlaceImport>("place-import", "Units and up axis",
                                   "Reads the numbers of an imported file in other units, or with another axis up.", placeImport, placeImportName)};
}

}  // namespace mw
