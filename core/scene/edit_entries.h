// How a function becomes an edit: its parameter struct is described, the function wrapped. For the files that define edits.
#pragma once
#include "core/catalog/entries.h"
#include "core/scene/edit.h"

namespace mw {

template <class P>
Edit editEntry(std::string id, std::string title, std::string summary, void (*apply)(Scene&, const P&, EditRun&),
               std::string (*name)(const Scene&, const P&))
{
    return {std::move(id),
            std::move(title),
            std::move(summary),
            described<P>(),
            [apply](Scene& scene, const ParameterValues& values, EditRun& run) { apply(scene, filled<P>(values), run); },
            [name](const Scene& scene, const ParameterValues& values) { return name(scene, filled<P>(values)); }};
}

/// "bunny", or "3 nodes".
std::string spoken(const Scene& scene, const std::vector<NodeId>& nodes);

// The edits, by file; edit.cpp joins them.
std::vector<Edit> nodeEdits();

}  // namespace mw
